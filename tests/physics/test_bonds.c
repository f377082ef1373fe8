/* The bonds of a body: how many, and that a list of neighbours of scattered particles gives what
 * the lattice gives. */
#include "check.h"

#include "random.h"
#include "small_body.h"

#include <stdlib.h>
#include <string.h>

static const char spring[] = "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}, "
                             "B: {model: bond_based, density: 8900, youngs_modulus: 120 GPa}}";

static uint8_t chequers(const int size[3], const int at[3])
{
    (void)size;
    return (uint8_t)((at[0] / 2 + at[1] / 3 + at[2] / 2) % 2);
}

static uint8_t without_corner(const int size[3], const int at[3])
{
    (void)size;
    return at[0] + at[1] + at[2] == 0 ? ABSENT : 0;
}

static int64_t bonds_of(struct small_case wanted)
{
    struct small_body small;
    wanted.materials = spring;
    small_body_new(&small, &wanted);
    int64_t count = bonds_total(small.bonds);
    small_body_free(&small);
    return count;
}

/* A box has (n_x - |a|)(n_y - |b|)(n_z - |c|) bonds of the offset (a, b, c). */
static void test_number(void **state)
{
    (void)state;
    const int64_t nearest = 4 * 4 * 3 + 5 * 3 * 3 + 5 * 4 * 2;
    for (int list = 0; list < 2; list++) {
        assert_int_equal(bonds_of((struct small_case){{5, 4, 3}, 1, .scattered = list}), nearest);
        assert_int_equal(
            bonds_of((struct small_case){{5, 4, 3}, 1, .phase = without_corner, .scattered = list}),
            nearest - 3);
        int64_t expected = 0;
        for (int a = -2; a <= 2; a++)
            for (int b = -2; b <= 2; b++)
                for (int c = -2; c <= 2; c++)
                    if (a * a + b * b + c * c <= 4 && (a || b || c))
                        expected += (int64_t)(5 - abs(a)) * (4 - abs(b)) * (3 - abs(c));
        assert_int_equal(bonds_of((struct small_case){{5, 4, 3}, 2, .scattered = list}),
                         expected / 2);
    }
}

/* Force and stress of every particle by both paths; the particles of a full box come in the same
 * order. */
static void compare_paths(struct small_case wanted, double tolerance)
{
    struct small_body small[2];
    for (int list = 0; list < 2; list++) {
        wanted.scattered = list;
        small_body_new(&small[list], &wanted);
        const double H[9] = {0.02, 0.004, 0, 0.001, -0.009, 0.002, 0, 0, 0};
        small_body_deform(&small[list], H);
    }
    int64_t node = 0;
    const double most_strain = 0.05;
    struct random_stream *stream = random_new(5, "shake");
    for (int64_t site = 0; site < small[0].body.grid.n_sites; site++) {
        if (!small_body_has(&small[0], site)) continue;
        for (int a = 0; a < 3; a++) {
            double shake = most_strain * SMALL_SPACING * (2 * random_uniform(stream) - 1);
            small[0].body.u[a][site] += shake;
            small[1].body.u[a][node] += shake;
        }
        node++;
    }
    random_free(stream);
    for (int list = 0; list < 2; list++) {
        small_body_force(&small[list], false, false);
        model_prepare(small[list].model, &small[list].body, 3);
    }
    const double most = small_body_largest(&small[0], small[0].body.f);
    double most_stress = 0;
    for (int64_t site = 0; site < small[0].body.grid.n_sites; site++)
        most_stress = fmax(most_stress, fabs(small[0].body.S[0][site]));
    node = 0;
    for (int64_t site = 0; site < small[0].body.grid.n_sites; site++) {
        if (!small_body_has(&small[0], site)) continue;
        for (int a = 0; a < 3; a++)
            assert_near(small[0].body.f[a][site], small[1].body.f[a][node], tolerance * most);
        for (int k = 0; k < 9; k++) {
            assert_near(small[0].body.S[k][site], small[1].body.S[k][node],
                        tolerance * most_stress);
            /* strains of some per cent from differences of displacements of their size */
            assert_near(small[0].body.H[k][site], small[1].body.H[k][node], tolerance);
        }
        node++;
    }
    for (int list = 0; list < 2; list++) small_body_free(&small[list]);
}

/* Sums of 122 terms of either sign in another order: some 1e-14 of the largest. */
static void test_list_gives_the_force_of_the_lattice(void **state)
{
    (void)state;
    compare_paths((struct small_case){{9, 8, 7}, 3.015, .materials = spring}, 1e-13);
    compare_paths((struct small_case){{9, 8, 7},
                                      3.015,
                                      .influence = 3,
                                      .materials = spring,
                                      .n_phases = 2,
                                      .phase = chequers,
                                      .partial = true,
                                      /* scattered particles have no cells for bonds in series */
                                      .breaking = "interfaces: mean"},
                  1e-13);
    compare_paths(
        (struct small_case){{12, 9, 1}, 3.015, .materials = spring, .plane = PLANE_STRESS}, 1e-13);
}

/* The same of state-based materials, in plastic flow; a shape tensor's inverse costs another digit.
 */
static void test_list_gives_the_force_of_any_material(void **state)
{
    (void)state;
    static const char linear[] = "{A: {model: ordinary, density: 8900, youngs_modulus: 210 GPa, "
                                 "poissons_ratio: 0.31}}",
                      flowing[] =
                          "{A: {model: ordinary_plastic, density: 8900, youngs_modulus: 210 GPa, "
                          "poissons_ratio: 0.31, hardening: {law: linear, yield: 185 MPa, "
                          "modulus: 898 MPa}}}";
    compare_paths((struct small_case){{9, 8, 7}, 3.015, .influence = 3, .materials = linear},
                  1e-12);
    compare_paths(
        (struct small_case){{12, 9, 1}, 3.015, .materials = linear, .plane = PLANE_STRAIN}, 1e-12);
    compare_paths((struct small_case){{9, 8, 7}, 3.015, .materials = flowing}, 1e-12);
    for (int horizon = 1; horizon <= 2; horizon++)
        compare_paths((struct small_case){{9, 8, 7},
                                          horizon,
                                          .stabilisation = small_capped,
                                          .materials = small_two_phases,
                                          .n_phases = 2,
                                          .phase = chequers},
                      1e-12);
}

/* Forces of a jittered set add up to nothing, and turn with the body. */
static void test_scattered_forces_balance(void **state)
{
    (void)state;
    struct small_body small;
    small_body_new(&small, &(struct small_case){{8, 7, 6},
                                                3.015,
                                                .materials = spring,
                                                .n_phases = 2,
                                                .phase = chequers,
                                                .scattered = true,
                                                .jitter = 0.2});
    small_body_shake(&small, 0.05, 3);
    small_body_force(&small, false, false);
    const double most = small_body_largest(&small, small.body.f);
    double sum[3] = {0};
    int64_t count = 0;
    for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
        if (!small_body_has(&small, site)) continue;
        for (int a = 0; a < 3; a++)
            sum[a] += small.body.f[a][site] * body_volume(&small.body, site);
        count++;
    }
    /* rounding of the sum of all */
    for (int a = 0; a < 3; a++)
        assert_near(sum[a], 0, 1e-15 * (double)count * most * small.body.volume);
    small_body_free(&small);
}

/* A strip whose bonds have weights of their own goes through other loops; as long as they are those
 * of the offset, it gives the same bits.  With a part of the strips so, as on ranks that know
 * different ones to be cut. */
static void test_own_weights_change_no_bit(void **state)
{
    (void)state;
    static const char *const materials[] = {
        spring,
        "{A: {model: ordinary, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31}, "
        "B: {model: ordinary, density: 8900, youngs_modulus: 120 GPa, poissons_ratio: 0.31}}",
        "{A: {model: ordinary_plastic, density: 8900, youngs_modulus: 210 GPa, "
        "poissons_ratio: 0.31, hardening: {law: linear, yield: 185 MPa, modulus: 898 MPa}}, "
        "B: {model: ordinary_plastic, density: 8900, youngs_modulus: 120 GPa, "
        "poissons_ratio: 0.31, hardening: {law: linear, yield: 1 GPa, modulus: 898 MPa}}}"};
    for (size_t m = 0; m < sizeof materials / sizeof *materials; m++)
        for (int phases = 1; phases <= 2; phases++) {
            struct small_body small[2];
            for (int own = 0; own < 2; own++) {
                small_body_new(&small[own],
                               &(struct small_case){{19, 8, 7},
                                                    3.015,
                                                    .influence = 3,
                                                    .materials = materials[m],
                                                    .n_phases = phases,
                                                    .phase = phases > 1 ? chequers : NULL,
                                                    .partial = true});
                for (int64_t s = 0; own && s < small[own].bonds->count; s++)
                    if (s % 3) bonds_own_weights(small[own].bonds, &small[own].bonds->strips[s]);
            }
            for (int step = 1; step <= 3; step++) {
                for (int own = 0; own < 2; own++) {
                    small_body_shake(&small[own], 0.002, step);
                    small_body_force(&small[own], true, false);
                }
                assert_true(small_body_largest(&small[0], small[0].body.f) > 0);
                for (int a = 0; a < 3; a++)
                    assert_memory_equal(small[0].body.f[a], small[1].body.f[a],
                                        (size_t)small[0].body.grid.n_sites * sizeof(double));
            }
            for (int own = 0; own < 2; own++) small_body_free(&small[own]);
        }
}

/* What bonds hold by themselves, w_ij V_i V_j, adds up to what the body stores, also between
 * phases: sums in another order. */
static void test_energies_of_bonds(void **state)
{
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct small_body small;
        small_body_new(&small, &(struct small_case){{7, 6, 5},
                                                    2.015,
                                                    .materials = spring,
                                                    .n_phases = 2,
                                                    .phase = chequers,
                                                    .surface_correction = "energy",
                                                    .scattered = list});
        small_body_deform(&small, (const double[9]){0.01, 0.004, 0, 0, -0.003, 0, 0, 0.002, 0});
        small_body_shake(&small, 0.01, 3);
        small_body_force(&small, false, false);
        double sum = 0, energy[BOND_LANES];
        for (int64_t s = 0; s < small.bonds->count; s++) {
            const struct bond_view view = bonds_view(small.bonds, &small.bonds->strips[s]);
            small.model->formulation->bond_energy(small.model->self, &small.body,
                                                  &small.bonds->strips[s], energy);
            for (int k = 0; k < view.count; k++)
                sum += energy[k] * view.volume_i[k * view.geometry_step] *
                       view.volume_j[k * view.geometry_step];
        }
        assert_true(sum > 0);
        assert_relative(sum, small_body_elastic_energy(&small), 1e-11);
        small_body_free(&small);
    }
}

/* sum |xi| n_a^4 over the members of a node's family that there are, in spacings. */
static void stretched_energy(const int size[3], const int at[3], double sums[3])
{
    for (int a = 0; a < 3; a++) sums[a] = 0;
    for (int z = -2; z <= 2; z++)
        for (int y = -2; y <= 2; y++)
            for (int x = -2; x <= 2; x++) {
                const int step[3] = {x, y, z};
                const double length = sqrt(x * x + y * y + z * z);
                bool there = length > 0 && length < 2.015;
                for (int a = 0; a < 3; a++)
                    there &= at[a] + step[a] >= 0 && at[a] + step[a] < size[a];
                for (int a = 0; a < 3 && there; a++) sums[a] += length * pow(step[a] / length, 4);
            }
}

/* (surface.2) of each bond of a box, anew; the full family is that of the lattice, of a list the
 * continuum's, pi delta^4/5: the mean of n_a^4 over directions is 1/5.  Simpson's rule of the
 * family's moments is exact for powers. */
static void test_surface_correction_of_each_bond(void **state)
{
    (void)state;
    static const int size[3] = {6, 5, 7}, wide[3] = {9, 9, 9}, centre[3] = {4, 4, 4};
    for (int list = 0; list < 2; list++) {
        struct small_body small;
        double full[3];
        small_body_new(&small, &(struct small_case){{6, 5, 7},
                                                    2.015,
                                                    .materials = spring,
                                                    .surface_correction = "energy",
                                                    .scattered = list});
        stretched_energy(wide, centre, full);
        if (list)
            for (int a = 0; a < 3; a++) full[a] = M_PI * pow(2.015, 4) / 5;
        for (int64_t s = 0; s < small.bonds->count; s++) {
            const struct bond_view view = bonds_view(small.bonds, &small.bonds->strips[s]);
            for (int k = 0; k < view.count; k++) {
                double ends[2][3], x[2][3], sum = 0;
                body_position(&small.body, bond_lower(&view, k), x[0]);
                body_position(&small.body, bond_upper(&view, k), x[1]);
                for (int end = 0; end < 2; end++) {
                    int at[3];
                    for (int a = 0; a < 3; a++) at[a] = (int)lround(x[end][a] / SMALL_SPACING);
                    stretched_energy(size, at, ends[end]);
                }
                const double length = view.length[k * view.geometry_step];
                for (int a = 0; a < 3; a++) {
                    const double n = (x[1][a] - x[0][a]) / length,
                                 g = 0.5 * full[a] * (1 / ends[0][a] + 1 / ends[1][a]);
                    sum += n * n / (g * g);
                }
                assert_relative(view.weight[k * view.weight_step], 1 / sqrt(sum), 1e-10);
            }
        }
        small_body_free(&small);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_energies_of_bonds),
        cmocka_unit_test(test_surface_correction_of_each_bond),
        cmocka_unit_test(test_number),
        cmocka_unit_test(test_list_gives_the_force_of_the_lattice),
        cmocka_unit_test(test_list_gives_the_force_of_any_material),
        cmocka_unit_test(test_scattered_forces_balance),
        cmocka_unit_test(test_own_weights_change_no_bit),
    };
    return cmocka_run_group_tests_name("bonds", tests, small_ranks_start, small_ranks_stop);
}
