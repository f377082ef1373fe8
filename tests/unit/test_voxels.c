/* Voxels on a lattice: what a cell gets, cut out and mirrored. */
#include "check.h"

#include "memory.h"
#include "random.h"
#include "voxels.h"

#include <stdlib.h>

static struct voxels random_voxels(const int64_t count[3], int phases, bool holes)
{
    struct voxels voxels = {.count = {count[0], count[1], count[2]}, .edge = {1, 0.5, 2}};
    const size_t number = (size_t)(count[0] * count[1] * count[2]);
    voxels.phase = memory_new(number, sizeof *voxels.phase);
    voxels.grain = memory_new(number, sizeof *voxels.grain);
    for (size_t v = 0; v < number; v++) {
        const uint64_t drawn = random_hash(5, "voxels", v);
        voxels.phase[v] = (uint8_t)(drawn % (uint64_t)phases);
        voxels.grain[v] = (int64_t)(drawn / 7 % 3) - 1;
        if (holes && drawn / 31 % 5 == 0) voxels.phase[v] = VOXEL_EMPTY;
    }
    return voxels;
}

static int64_t number_of(const struct voxels *voxels, int64_t i, int64_t j, int64_t k)
{
    return i + voxels->count[0] * (j + voxels->count[1] * k);
}

/* On the voxels' own lattice both rules give the voxels. */
static void a_cell_of_a_voxel_gets_it(void **state)
{
    (void)state;
    const int64_t count[3] = {7, 5, 4};
    struct voxels voxels = random_voxels(count, 3, true);
    for (int rule = VOXELS_NEAREST; rule <= VOXELS_MAJORITY; rule++)
        for (int64_t v = 0; v < 7 * 5 * 4; v++) {
            const double point[3] = {(double)(v % 7) - 3, 0.5 * ((double)(v / 7 % 5) - 2),
                                     2 * ((double)(v / 35) - 1.5)};
            struct voxel found = voxels_at(&voxels, point, voxels.edge, (enum voxels_rule)rule);
            assert_int_equal(found.phase, voxels.phase[v]);
            if (found.phase != VOXEL_EMPTY) assert_int_equal(found.grain, voxels.grain[v]);
        }
    const double beyond[3] = {3.6, 0, 0};
    assert_int_equal(voxels_at(&voxels, beyond, voxels.edge, VOXELS_NEAREST).phase, VOXEL_OUTSIDE);
    voxels_free(&voxels);
}

/* The majority by counting points on a grid within the cell, so fine that its points lie in whole
 * parts of the voxels: 12 to a cell along each axis, where cells are 3/2, 3 and 3/4 voxels long.
 * Where counts are equal the first phase wins, and of its grains any of the largest. */
static void majorities_are_those_of_points(void **state)
{
    (void)state;
    enum { POINTS = 12, PHASES = 3 };
    const int64_t count[3] = {6, 6, 6};
    struct voxels voxels = random_voxels(count, PHASES, true);
    const double cell[3] = {1.5, 1.5, 1.5};
    const int64_t cells[3] = {4, 2, 8};
    for (int64_t c = 0; c < 4 * 2 * 8; c++) {
        const int64_t at[3] = {c % 4, c / 4 % 2, c / 8};
        double middle[3];
        int phases[PHASES + 1] = {0}, grains[PHASES][3] = {{0}};
        for (int axis = 0; axis < 3; axis++)
            middle[axis] = ((double)at[axis] + 0.5 - 0.5 * (double)cells[axis]) * cell[axis];
        for (int p = 0; p < POINTS * POINTS * POINTS; p++) {
            const int part[3] = {p % POINTS, p / POINTS % POINTS, p / POINTS / POINTS};
            int64_t in[3];
            for (int axis = 0; axis < 3; axis++)
                in[axis] = (int64_t)floor(((double)at[axis] + (part[axis] + 0.5) / POINTS) *
                                          cell[axis] / voxels.edge[axis]);
            const int64_t v = number_of(&voxels, in[0], in[1], in[2]);
            const bool empty = voxels.phase[v] == VOXEL_EMPTY;
            phases[empty ? PHASES : voxels.phase[v]]++;
            if (!empty) grains[voxels.phase[v]][voxels.grain[v] + 1]++;
        }
        int best = 0, most = 0;
        for (int phase = 1; phase <= PHASES; phase++)
            if (phases[phase] > phases[best]) best = phase;
        struct voxel found = voxels_at(&voxels, middle, cell, VOXELS_MAJORITY);
        assert_int_equal(found.phase, best == PHASES ? VOXEL_EMPTY : best);
        if (best == PHASES) continue;
        for (int g = 0; g < 3; g++) most = grains[best][g] > most ? grains[best][g] : most;
        assert_int_equal(grains[best][found.grain + 1], most);
    }
    voxels_free(&voxels);
}

/* Cut out and doubled: the second half is the first one backwards, so that opposite ends are alike.
 */
static void mirrored_voxels_fit_at_their_ends(void **state)
{
    (void)state;
    const int64_t count[3] = {7, 5, 4}, low[3] = {1, 0, 2}, high[3] = {6, 5, 3};
    const bool mirror[3] = {true, false, true};
    struct voxels voxels = random_voxels(count, 3, false), whole = random_voxels(count, 3, false);
    voxels_crop(&voxels, low, high, mirror);
    assert_int_equal(voxels.count[0], 10);
    assert_int_equal(voxels.count[1], 5);
    assert_int_equal(voxels.count[2], 2);
    assert_near(voxels_size(&voxels, 0), 10, 1e-15);
    for (int64_t v = 0; v < 100; v++) {
        const int64_t i = v % 10, j = v / 10 % 5;
        const int64_t from = number_of(&whole, 1 + (i < 5 ? i : 9 - i), j, 2);
        assert_int_equal(voxels.phase[v], whole.phase[from]);
        assert_int_equal(voxels.grain[v], whole.grain[from]);
    }
    voxels_free(&voxels);
    voxels_free(&whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cell_of_a_voxel_gets_it),
        cmocka_unit_test(majorities_are_those_of_points),
        cmocka_unit_test(mirrored_voxels_fit_at_their_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
