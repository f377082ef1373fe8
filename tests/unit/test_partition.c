/* Partition: every particle has one owner, the shares are even, the same each time. */
#include "dies.h"
#include "small_ranks.h"

#include "memory.h"
#include "partition.h"

#include <stdlib.h>
#include <string.h>

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

/* METIS allows 3 % of imbalance, and a cell goes to one rank whole. */
static void test_shares_are_even(void **state)
{
    (void)state;
    struct lattice lattice = waisted(61, 25, 9);
    static const int sizes[] = {1, 2, 3, 4, 7, 16};
    for (int reach = 1; reach <= 3; reach++)
        for (int k = 0; k < 6; k++) {
            int64_t counts[16];
            struct partition partition = partition_new(&lattice, reach, 0, sizes[k]);
            assert_int_equal(partition.edge[2], reach > 2 ? reach : 2);
            count(&lattice, &partition, sizes[k], counts);
            const double share = (double)lattice.n_nodes / sizes[k],
                         cell = partition.edge[0] * partition.edge[1] * (double)partition.edge[2];
            for (int r = 0; r < sizes[k]; r++) {
                assert_true(counts[r] > 0);
                assert_true((double)counts[r] <= 1.03 * share + 2 * cell);
            }
            partition_free(&partition);
        }
    lattice_free(&lattice);
}

static void test_is_the_same_each_time(void **state)
{
    (void)state;
    struct lattice lattice = waisted(40, 20, 8);
    struct partition one = partition_new(&lattice, 1, 0, 5), two = partition_new(&lattice, 1, 0, 5);
    const size_t cells = (size_t)one.cells[0] * (size_t)one.cells[1] * (size_t)one.cells[2];
    assert_memory_equal(one.owner, two.owner, cells * sizeof *one.owner);
    partition_free(&one);
    partition_free(&two);
    lattice_free(&lattice);
}

/* Of a body with room for them, cells are as long as strips, which then stay whole. */
static void test_strips_stay_whole(void **state)
{
    (void)state;
    struct lattice lattice = waisted(130, 40, 40);
    struct partition partition = partition_new(&lattice, 1, 0, 4);
    assert_int_equal(partition.edge[0], 64);
    partition_free(&partition);
    partition = partition_new(&lattice, 1, 0, 40);
    assert_in_range(partition.edge[0], 16, 32);
    partition_free(&partition);
    lattice_free(&lattice);
}

/* Cells without particles belong to nobody. */
static void test_empty_cells(void **state)
{
    (void)state;
    struct lattice lattice = waisted(30, 24, 4);
    struct partition partition = partition_new(&lattice, 1, 0, 3);
    assert_int_equal(partition_owner(&partition, 15, 1, 1), -1);
    assert_true(partition_owner(&partition, 15, 12, 1) >= 0);
    partition_free(&partition);
    lattice_free(&lattice);
}

/* As many ranks as cells is the most there can be. */
static void take_more_ranks_than_cells(const void *lattice)
{
    struct partition partition = partition_new(lattice, 1, 0, 13);
    partition_free(&partition);
}

static void test_most_ranks(void **state)
{
    (void)state;
    struct lattice lattice = {
        .size = {6, 4, 4}, .spacing = 1, .edge = {1, 1, 1}, .n_sites = 96, .n_nodes = 96};
    lattice.phase = memory_new(96, 1);
    int64_t counts[12];
    struct partition partition = partition_new(&lattice, 1, 0, 12);
    count(&lattice, &partition, 12, counts);
    for (int r = 0; r < 12; r++) assert_int_equal(counts[r], 8);
    partition_free(&partition);
    assert_dies(EXIT_USER, "13 ranks for 12 cells", take_more_ranks_than_cells, &lattice);
    lattice_free(&lattice);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares_are_even),   cmocka_unit_test(test_is_the_same_each_time),
        cmocka_unit_test(test_strips_stay_whole), cmocka_unit_test(test_empty_cells),
        cmocka_unit_test(test_most_ranks),
    };
    return cmocka_run_group_tests_name("partition", tests, small_ranks_start, small_ranks_stop);
}
