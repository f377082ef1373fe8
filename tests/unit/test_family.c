/* Families: the table of offsets, shape tensors and bonds counted by hand. */
#include "check.h"

#include "family_sums.h"
#include "memory.h"

#include <stdlib.h>

static struct lattice box(int x, int y, int z)
{
    struct lattice lattice = {
        .size = {x, y, z}, .spacing = 1, .edge = {1, 1, 1}, .n_sites = (int64_t)x * y * z};
    lattice.n_nodes = lattice.n_sites;
    lattice.phase = memory_new((size_t)lattice.n_sites, 1);
    return lattice;
}

/* Lattice points within a sphere, half of them: 6, 18, 26, 32, 56 and 122 in all. */
static void test_sizes(void **state)
{
    (void)state;
    static const double horizons[] = {1, 1.45, 1.75, 2, 2.25, 3, 3.015};
    static const int halves[] = {3, 9, 13, 16, 28, 61, 61}, reach[] = {1, 1, 1, 2, 2, 3, 3};
    for (int h = 0; h < 7; h++) {
        struct family family = family_new(horizons[h], 0, false);
        assert_int_equal(family.n_half, halves[h]);
        assert_int_equal(family.reach, reach[h]);
        for (int o = 0; o < family.n_half; o++) {
            const int *s = family.half[o].step;
            assert_true(family.half[o].weight == 1);
            assert_true(s[2] > 0 || (s[2] == 0 && (s[1] > 0 || (s[1] == 0 && s[0] > 0))));
            for (int p = 0; p < o; p++) {
                const int *t = family.half[p].step;
                assert_true(s[0] != t[0] || s[1] != t[1] || s[2] != t[2]);
            }
        }
        family_free(&family);
    }
}

static void test_steep_weights(void **state)
{
    (void)state;
    assert_int_equal(family_influence("steep"), 1);
    assert_string_equal(family_influences[1], "steep");
    struct family family = family_new(3, 1, false);
    for (int o = 0; o < family.n_half; o++) {
        const int *s = family.half[o].step;
        const double square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
        assert_relative(family.half[o].weight, pow(square, -4), 1e-14); /* pow's rounding */
    }
    family_free(&family);
}

/* Deep inside: K isotropic by cubic symmetry, sum of xi zero.  K_11 counted by hand: 2 at horizon
 * 1; at 2: 2 + 2 * 4 on the axis, 8 of (1, 1, 0) and 8 of (1, 1, 1). */
static void test_inside(void **state)
{
    (void)state;
    static const double K[] = {2, 26};
    for (int horizon = 1; horizon <= 2; horizon++) {
        struct lattice lattice = box(7, 7, 7);
        struct family family = family_new(horizon, 0, false);
        double inverse[6], first[3];
        assert_true(family_shape(&family, &lattice, (int[]){3, 3, 3}, inverse, first));
        for (int k = 0; k < 3; k++) {
            assert_relative(inverse[k], 1 / K[horizon - 1], 1e-15);
            assert_true(inverse[3 + k] == 0 && first[k] == 0);
        }
        family_free(&family);
        lattice_free(&lattice);
    }
}

/* At faces, edges and corners, and in a body with holes: K K^-1 = 1, K and s summed here anew. */
static void test_inverse_everywhere(void **state)
{
    (void)state;
    struct lattice lattice = box(6, 5, 5);
    lattice.phase[lattice_site(&lattice, 2, 2, 0)] = ABSENT;
    lattice.phase[lattice_site(&lattice, 3, 4, 4)] = ABSENT;
    struct family family = family_new(2, 1, false);
    for (int64_t site = 0; site < lattice.n_sites; site++) {
        const int at[3] = {(int)(site % 6), (int)(site / 6 % 5), (int)(site / 30)};
        double K[3][3] = {{0}}, s[3] = {0}, k[6], first[3];
        assert_true(family_shape(&family, &lattice, at, k, first));
        for (int z = -2; z <= 2; z++)
            for (int y = -2; y <= 2; y++)
                for (int x = -2; x <= 2; x++) {
                    const int xi[3] = {x, y, z}, square = x * x + y * y + z * z;
                    if (square == 0 || square > 4) continue;
                    if (lattice_phase(&lattice, at[0] + x, at[1] + y, at[2] + z) == ABSENT)
                        continue;
                    for (int a = 0; a < 3; a++) {
                        s[a] += xi[a] * pow(square, -4);
                        for (int b = 0; b < 3; b++) K[a][b] += xi[a] * xi[b] * pow(square, -4);
                    }
                }
        const double inverse[3][3] = {{k[0], k[3], k[5]}, {k[3], k[1], k[4]}, {k[5], k[4], k[2]}};
        for (int a = 0; a < 3; a++) {
            assert_near(first[a], s[a], 1e-15); /* roundings of a sum of order one */
            for (int b = 0; b < 3; b++) {
                double product = 0;
                for (int c = 0; c < 3; c++) product += K[a][c] * inverse[c][b];
                assert_near(product, a == b, 1e-14); /* condition number below ten */
            }
        }
    }
    family_free(&family);
    lattice_free(&lattice);
}

/* A sheet, a line and a single point do not span space. */
static void test_no_gradient(void **state)
{
    (void)state;
    static const int sizes[][3] = {{5, 5, 1}, {5, 1, 1}, {1, 1, 1}};
    for (int k = 0; k < 3; k++) {
        struct lattice lattice = box(sizes[k][0], sizes[k][1], sizes[k][2]);
        struct family family = family_new(2, 0, false);
        double inverse[6], first[3];
        assert_false(family_shape(&family, &lattice, (int[]){0, 0, 0}, inverse, first));
        for (int i = 0; i < 6; i++) assert_true(inverse[i] == 0);
        family_free(&family);
        lattice_free(&lattice);
    }
}

/* In a plane the family is judged, and measured, by its part there: whole, and nearly a line, in
 * any units. */
static void test_plane(void **state)
{
    (void)state;
    static const double scales[] = {1e-3, 1, 1e3};
    for (int k = 0; k < 3; k++) {
        const double whole[6] = {2 * scales[k], scales[k], 0, 0.5 * scales[k], 0, 0},
                     line[6] = {scales[k], 1e-6 * scales[k], 0, 0, 0, 0}, none[6] = {0};
        double inverse[6];
        assert_true(family_invert_shape(whole, 2, inverse));
        /* det = 7/4: by hand, to round-off */
        assert_relative(inverse[0], 4.0 / 7 / scales[k], 1e-15);
        assert_relative(inverse[1], 8.0 / 7 / scales[k], 1e-15);
        assert_relative(inverse[3], -2.0 / 7 / scales[k], 1e-15);
        assert_false(family_invert_shape(line, 2, inverse));
        assert_false(family_invert_shape(none, 2, inverse));
    }
}

/* Whole columns against member by member, of a random field below 1/2: up to a thousand terms, each
 * rounded by 1e-16 of the largest. */
static void test_sums(void **state)
{
    (void)state;
    enum { WIDE = 104, COUNT = 61, SIZE = 17 };
    const struct grid grid = {.step = {1, WIDE, WIDE * SIZE}};
    double *field = memory_new((size_t)WIDE * SIZE * SIZE, sizeof *field);
    uint64_t seed = 1;
    for (int i = 0; i < WIDE * SIZE * SIZE; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        field[i] = (double)(seed >> 11) * 0x1p-53 - 0.5;
    }
    const double *first = field + WIDE * SIZE * (SIZE / 2) + WIDE * (SIZE / 2) + 16;
    for (int influence = 0; family_influences[influence]; influence++)
        for (double horizon = 1; horizon <= 8; horizon += 0.505) {
            struct family family = family_new(horizon, influence, influence % 2);
            for (int b = 0; b < 3; b++) {
                double out[COUNT] = {0}, largest = 0;
                family_sums_add(&family, &grid, b, COUNT, first, out);
                for (int i = 0; i < COUNT; i++) {
                    double sum = 0;
                    for (int o = 0; o < family.n_half; o++) {
                        const struct offset *offset = &family.half[o];
                        const int64_t shift = grid_shift(&grid, offset->step);
                        const double member = offset->weight * offset->step[b];
                        sum += member * (first[i + shift] - first[i - shift]);
                        largest = fmax(largest, fabs(member));
                    }
                    assert_true(fabs(out[i] - sum) <= 1e-12 * largest);
                }
            }
            family_free(&family);
        }
    free(field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_steep_weights),
        cmocka_unit_test(test_sums),
        cmocka_unit_test(test_inside),
        cmocka_unit_test(test_inverse_everywhere),
        cmocka_unit_test(test_no_gradient),
        cmocka_unit_test(test_plane),
    };
    return cmocka_run_group_tests_name("family", tests, NULL, NULL);
}
