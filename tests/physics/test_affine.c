/* Affine maps: the deformation gradient is exact at every node, a rigid motion gives no stress. */
#include "check.h"

#include "memory.h"
#include "small_body.h"

#include <stdlib.h>
#include <string.h>

/* A block with a notch, a hole from side to side and a step: faces, edges and corners of both
 * kinds. */
static uint8_t rugged(const int size[3], const int at[3])
{
    bool notch = at[0] > 3 && at[0] < 7 && at[1] < 3;
    bool hole = at[0] > 8 && at[0] < 11 && at[1] > 4 && at[1] < 7;
    bool step = at[2] > size[2] - 4 && at[1] > size[1] - 4;
    return notch || hole || step ? ABSENT : 0;
}

static const double horizons[] = {1, 1.5, 2, 3};

static void check_gradient(struct small_body *small, const double H[9])
{
    small_body_deform(small, H);
    small_body_force(small, false, true);
    for (int64_t site = 0; site < small->body.grid.n_sites; site++)
        for (int k = 0; k < 9 && small_body_has(small, site); k++)
            /* u is rounded at 1e-16 of 14 spacings, and the shape tensor of a corner has a
             * condition number of about ten */
            assert_near(small->body.H[k][site], H[k], 1e-13);
}

static void test_gradient_is_exact_at_faces_edges_and_corners(void **state)
{
    (void)state;
    static const double maps[][9] = {
        {0.3, 0, 0, 0, -0.11, 0, 0, 0, -0.11},
        {0, 0.2, 0, 0, 0, 0, 0, 0, 0},
        {0.05, -0.2, 0.13, 0.31, -0.17, 0.07, -0.11, 0.23, 0.19},
    };
    for (int h = 0; h < 4; h++)
        for (int influence = 0; influence < 2; influence++) {
            struct small_body small;
            small_body_new(&small, &(struct small_case){{14, 10, 9},
                                                        horizons[h],
                                                        influence,
                                                        small_mix,
                                                        small_elastic,
                                                        .phase = rugged});
            assert_int_equal(small.body.unsupported, 0);
            for (int m = 0; m < 3; m++) check_gradient(&small, maps[m]);
            small_body_free(&small);
        }
}

/* R - 1 of the rotation about an axis that lies no way special. */
static void rotation(double angle, double H[9])
{
    const double n[3] = {2.0 / 7, 3.0 / 7, 6.0 / 7};
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) H[3 * a + b] = (1 - cos(angle)) * (n[a] * n[b] - (a == b));
    H[1] -= sin(angle) * n[2], H[2] += sin(angle) * n[1];
    H[3] += sin(angle) * n[2], H[5] -= sin(angle) * n[0];
    H[6] -= sin(angle) * n[1], H[7] += sin(angle) * n[0];
}

static void test_rotation_gives_no_stress(void **state)
{
    (void)state;
    const char *laws[] = {small_mix, small_capped};
    for (int h = 0; h < 4; h++)
        for (int law = 0; law < 2; law++) {
            struct small_body small;
            small_body_new(
                &small, &(struct small_case){
                            {14, 10, 9}, horizons[h], 0, laws[law], small_nickel, .phase = rugged});
            for (int k = 1; k <= 6; k++) {
                double H[9];
                rotation(0.5 * k, H);
                small_body_deform(&small, H);
                small_body_force(&small, true, false);
                /* H is known to 1e-14 (test above): stress 1e-14 E, force density that by spacing,
                 * times the few terms that meet at a corner */
                assert_near(small_body_largest(&small, small.body.f) * SMALL_SPACING / 210e9, 0,
                            1e-13);
            }
            small_body_free(&small);
        }
}

/* (H + 1) u, at every node, added to u = H X */
static void turn(struct small_body *small, const double H[9])
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        double u[3], *const *now = small->body.u;
        int at[3];
        small_body_position(small, site, at);
        for (int a = 0; a < 3 && small_body_has(small, site); a++) u[a] = now[a][site];
        for (int a = 0; a < 3 && small_body_has(small, site); a++)
            for (int b = 0; b < 3; b++)
                now[a][site] += H[3 * a + b] * (u[b] + at[b] * SMALL_SPACING);
    }
}

/* Deforms the body, lets it flow, and compares the forces before and after a turn by 2.2 rad. */
static void check_forces_turn(const char *law, const double stretch[9], double shake)
{
    struct small_body small;
    small_body_new(&small,
                   &(struct small_case){{14, 10, 9}, 1, 0, law, small_nickel, .phase = rugged});
    small_body_deform(&small, stretch);
    small_body_shake(&small, shake, 1);
    small_body_force(&small, true, false);
    small_body_force(&small, false, false);
    const double largest = small_body_largest(&small, small.body.f);
    assert_true(largest * SMALL_SPACING > 1e6);
    double *before[3], H[9];
    const size_t bytes = (size_t)small.body.grid.n_sites * sizeof(double);
    for (int a = 0; a < 3; a++) before[a] = memcpy(memory_new(bytes, 1), small.body.f[a], bytes);
    rotation(2.2, H);
    turn(&small, H);
    small_body_force(&small, false, false);
    for (int64_t site = 0; site < small.body.grid.n_sites; site++)
        for (int a = 0; a < 3; a++) {
            double turned = before[a][site];
            for (int b = 0; b < 3; b++) turned += H[3 * a + b] * before[b][site];
            /* strains rounded at 1e-15 against elastic strains of 1e-3 */
            assert_near(small.body.f[a][site], turned, 1e-10 * largest);
        }
    for (int a = 0; a < 3; a++) free(before[a]);
    small_body_free(&small);
}

static void test_forces_turn_with_a_body_that_has_flowed(void **state)
{
    (void)state;
    static const double stretch[9] = {0.03, 0.01, 0, 0, -0.012, 0, 0.004, 0, -0.015};
    check_forces_turn(small_mix, stretch, 0.01);
    check_forces_turn(small_mix, stretch, 0.0001);
}

/* The slip of capped bonds is kept in the reference configuration: their forces turn with the body
 * below their cap (here 4e-5 spacings at first yield) and beyond it. */
static void test_forces_of_capped_bonds_turn(void **state)
{
    (void)state;
    static const double stretch[9] = {0.03, 0.01, 0, 0, -0.012, 0, 0.004, 0, -0.015};
    check_forces_turn(small_capped, stretch, 5e-6);
    check_forces_turn(small_capped, stretch, 0.01);
}

static uint8_t full(const int size[3], const int at[3])
{
    (void)size, (void)at;
    return 0;
}

/* A sheet one node thick has no gradient across it: no stress, and the body says so. */
static void test_sheet_is_reported(void **state)
{
    (void)state;
    struct small_body small;
    small_body_new(&small,
                   &(struct small_case){{9, 8, 1}, 2, 0, small_mix, small_elastic, .phase = full});
    assert_int_equal(small.body.unsupported, 72);
    small_body_deform(&small, (const double[9]){0.01});
    small_body_force(&small, false, true);
    for (int64_t site = 0; site < small.body.grid.n_sites; site++)
        for (int k = 0; k < 9; k++) assert_true(small.body.H[k][site] == 0);
    small_body_free(&small);
}

/* A motion that alternates from node to node, which no gradient sees: inside, f = -sum_j 2 V c (2
 * u) over the four nearest, c = 0.3 (lambda + 4 mu)/kappa_0; kappa_0 = 6 by hand of a layer at a
 * horizon of 1.45, 10 of the body. */
static void check_alternating(enum plane plane, int layers, int axes, double kappa)
{
    struct small_body small;
    small_body_new(&small,
                   &(struct small_case){
                       {13, 13, layers}, 1.45, 0, small_capped, small_elastic, .plane = plane});
    const double u = 1e-6 * SMALL_SPACING, mu = small.materials.shear[0],
                 lambda = small.materials.bulk[0] - 2 * mu / 3;
    for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&small, site)) continue;
        small_body_position(&small, site, at);
        small.body.u[0][site] = (at[0] + at[1] + at[2]) % 2 ? -u : u;
    }
    small_body_force(&small, false, true);
    const int64_t middle = small_body_middle(&small);
    const double stiffness = 2 * 0.3 * (lambda + 4 * mu) / (kappa * SMALL_SPACING * SMALL_SPACING);
    /* rounding of sums of four to six terms, and of u against positions of 13 spacings */
    assert_relative(fabs(small.body.f[0][middle]), 2 * axes * stiffness * 2 * u, 1e-12);
    small_body_free(&small);
}

static void test_capped_bonds_of_a_layer(void **state)
{
    (void)state;
    check_alternating(PLANE_STRAIN, 1, 2, 6);
    check_alternating(SPACE, 13, 3, 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gradient_is_exact_at_faces_edges_and_corners),
        cmocka_unit_test(test_rotation_gives_no_stress),
        cmocka_unit_test(test_forces_turn_with_a_body_that_has_flowed),
        cmocka_unit_test(test_forces_of_capped_bonds_turn),
        cmocka_unit_test(test_sheet_is_reported),
        cmocka_unit_test(test_capped_bonds_of_a_layer),
    };
    return cmocka_run_group_tests_name("affine maps", tests, small_ranks_start, small_ranks_stop);
}
