/* Partition: every particle has one owner, the shares are even, the same each time. */
#include "dies.h"

#include "memory.h"
#include "partition.h"
#include "ranks.h"

#include <stdlib.h>
#include <string.h>

static int start(void **state)
{
    (void)state;
    ranks_start(NULL, NULL);
    return 0;
}

static int stop(void **state)
{
    (void)state;
    ranks_stop();
    return 0;
}

/* A plate with its middle cut narrow, as a dog-bone. */
static struct lattice waisted(int x, int y, int z)
{
    struct lattice lattice = {
        .size = {x, y, z}, .spacing = 1, .edge = {1, 1, 1}, .n_sites = (int64_t)x * y * z};
    lattice.phase = memory_new((size_t)lattice.n_sites, 1);
    for (int64_t site = 0; site < lattice.n_sites; site++) {
        int64_t at_x = site % x, at_y = site / x % y;
        bool waist = at_x >= x / 3 && at_x < 2 * x / 3;
        if (waist && (at_y < y / 4 || at_y >= y - y / 4)) lattice.phase[site] = ABSENT;
        lattice.n_nodes += lattice.phase[site] != ABSENT;
    }
    return lattice;
}

/* Counts the particles of each rank; none is without an owner. */
static void count(const struct lattice *lattice, const struct partition *partition, int size,
                  int64_t *counts)
{
    for (int r = 0; r < size; r++) counts[r] = 0;
    for (int z = 0; z < lattice->size[2]; z++)
        for (int y = 0; y < lattice->size[1]; y++)
            for (int x = 0; x < lattice->size[0]; x++) {
                if (lattice_phase(lattice, x, y, z) == ABSENT) continue;
                int owner = partition_owner(partition, x, y, z);
                assert_in_range(owner, 0, size - 1);
                counts[owner]++;
            }
}

/* What a rank has too much is at most half of a layer of its own for each cut that made it: of the
 * parts here, some 9 wide, 15 % of their nodes.  Each lies in its box. */
static void test_shares_are_even(void **state)
{
    (void)state;
    struct lattice lattice = waisted(61, 25, 9);
    static const int sizes[] = {1, 2, 3, 4, 7, 16};
    for (int k = 0; k < 6; k++) {
        int64_t counts[16];
        struct partition partition = partition_new(&lattice, sizes[k]);
        count(&lattice, &partition, sizes[k], counts);
        const double share = (double)lattice.n_nodes / sizes[k];
        for (int r = 0; r < sizes[k]; r++) {
            assert_true((double)counts[r] >= 0.85 * share);
            assert_true((double)counts[r] <= 1.15 * share);
        }
        partition_free(&partition);
    }
    lattice_free(&lattice);
}

/* Boxes are the smallest about their nodes, also where the body has a hole in its cuboid. */
static void test_boxes_are_tight(void **state)
{
    (void)state;
    struct lattice lattice = waisted(60, 24, 4);
    struct partition partition = partition_new(&lattice, 3);
    /* A third of the nodes is the waist with two layers of either side at most. */
    assert_int_equal(partition.boxes[0].low[1], 0);
    for (int r = 0; r < 3; r++)
        for (int a = 0; a < 3; a++) {
            int at[3], ends = 0;
            for (int64_t site = 0; site < lattice.n_sites; site++) {
                lattice_position(&lattice, site, at);
                if (lattice.phase[site] == ABSENT ||
                    partition_owner(&partition, at[0], at[1], at[2]) != r)
                    continue;
                assert_in_range(at[a], partition.boxes[r].low[a], partition.boxes[r].high[a] - 1);
                ends |= (at[a] == partition.boxes[r].low[a] ? 1 : 0) |
                        (at[a] == partition.boxes[r].high[a] - 1 ? 2 : 0);
            }
            assert_int_equal(ends, 3);
        }
    partition_free(&partition);
    lattice_free(&lattice);
}

/* Each rank has a node at least. */
static void take_more_ranks_than_nodes(const void *lattice)
{
    struct partition partition = partition_new(lattice, 97);
    partition_free(&partition);
}

static void test_most_ranks(void **state)
{
    (void)state;
    struct lattice lattice = {
        .size = {6, 4, 4}, .spacing = 1, .edge = {1, 1, 1}, .n_sites = 96, .n_nodes = 96};
    lattice.phase = memory_new(96, 1);
    static const int sizes[] = {12, 96};
    for (int k = 0; k < 2; k++) {
        int64_t counts[96];
        struct partition partition = partition_new(&lattice, sizes[k]);
        count(&lattice, &partition, sizes[k], counts);
        for (int r = 0; r < sizes[k]; r++) assert_int_equal(counts[r], 96 / sizes[k]);
        partition_free(&partition);
    }
    assert_dies(EXIT_USER, "97 ranks for 96 nodes", take_more_ranks_than_nodes, &lattice);
    lattice_free(&lattice);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares_are_even),
        cmocka_unit_test(test_boxes_are_tight),
        cmocka_unit_test(test_most_ranks),
    };
    return cmocka_run_group_tests_name("partition", tests, start, stop);
}
