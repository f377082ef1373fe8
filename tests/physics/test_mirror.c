/* A body and its mirror image: forces are mirror images, too, whatever the phases, flaws and
 * plastic states of both ends of a bond.  What belongs to two nodes must not be that of the one
 * with the lower number. */
#include "check.h"

#include "small_body.h"

#include <math.h>

enum { LONG = 10, WIDE = 5 };

static uint8_t left_is_first(const int size[3], const int at[3])
{
    return at[0] < size[0] / 2 ? 0 : 1;
}
static uint8_t right_is_first(const int size[3], const int at[3])
{
    return at[0] < size[0] / 2 ? 1 : 0;
}

static int64_t mirrored(const struct small_body *small, int64_t site)
{
    int at[3];
    small_body_position(small, site, at);
    at[0] = LONG - 1 - at[0];
    return grid_site(&small->body.grid, at);
}

/* Strains of per cents that differ from layer to layer and along the way across. */
static void deform(struct small_body *small, int sign, double amount)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        const double x = sign * (at[0] - 0.5 * (LONG - 1)), y = at[1] - 0.4, z = at[2] - 1.3;
        const double scale = amount * SMALL_SPACING;
        small->body.u[0][site] = sign * scale * (x + 0.2 * x * x + 0.03 * x * y * z);
        small->body.u[1][site] = scale * (0.2 * x * y - 0.4 * y + 0.1 * x * x);
        small->body.u[2][site] = scale * (0.1 * x * z + 0.3 * y * z);
    }
}

/* Flows twice, then looks at forces and energies; sums in another order are 1e-14 of their largest
 * terms, which stiff springs and the roots of flow raise. */
static void compare(struct small_case wanted, const char *first, const char *second)
{
    struct small_body one, other;
    wanted.size[0] = LONG;
    wanted.size[1] = wanted.size[2] = WIDE;
    wanted.materials = first;
    wanted.phase = wanted.n_phases == 2 ? left_is_first : NULL;
    small_body_new(&one, &wanted);
    wanted.materials = second;
    wanted.phase = wanted.n_phases == 2 ? right_is_first : NULL;
    small_body_new(&other, &wanted);
    for (int step = 1; step <= 2; step++) {
        deform(&one, 1, 0.004 * step);
        deform(&other, -1, 0.004 * step);
        small_body_force(&one, true, false);
        small_body_force(&other, true, false);
    }
    deform(&one, 1, 0.007);
    deform(&other, -1, 0.007);
    small_body_force(&one, false, false);
    small_body_force(&other, false, false);
    const double most = small_body_largest(&one, one.body.f);
    assert_true(most > 0);
    for (int64_t site = 0; site < one.body.grid.n_sites; site++) {
        if (!small_body_has(&one, site)) continue;
        const int64_t image = mirrored(&one, site);
        for (int a = 0; a < 3; a++)
            assert_near(other.body.f[a][image], (a == 0 ? -1 : 1) * one.body.f[a][site],
                        1e-9 * most);
    }
    assert_relative(small_body_potential(&other), small_body_potential(&one), 1e-10);
    small_body_free(&one);
    small_body_free(&other);
}

#define SPRINGS                                                                                    \
    "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}, "                            \
    "B: {model: bond_based, density: 8900, youngs_modulus: 60 GPa}}"
#define SOLIDS                                                                                     \
    "{A: {model: ordinary, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31}, "        \
    "B: {model: ordinary, density: 8900, youngs_modulus: 60 GPa, poissons_ratio: 0.2}}"
#define FLOWING                                                                                    \
    "model: correspondence, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31, "        \
    "hardening: {law: linear, yield: 300 MPa, modulus: 2 GPa}"
#define PLASTIC                                                                                    \
    "model: ordinary_plastic, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31, "      \
    "hardening: {law: linear, yield: 300 MPa, modulus: 2 GPa}"
/* At the second layer, and at its image. */
#define FLAW  ", flaw: {centre: [25 um, 0, 0], radius: 60 um, reduction: 0.6}}}"
#define IMAGE ", flaw: {centre: [200 um, 0, 0], radius: 60 um, reduction: 0.6}}}"

static void test_phases_of_springs(void **state)
{
    (void)state;
    compare((struct small_case){.horizon = 2.015, .n_phases = 2}, SPRINGS, SPRINGS);
    compare((struct small_case){.horizon = 2.015, .n_phases = 2, .surface_correction = "energy"},
            SPRINGS, SPRINGS);
    compare((struct small_case){.horizon = 2.015, .influence = 3, .n_phases = 2}, SOLIDS, SOLIDS);
}

static void test_phases_of_correspondence(void **state)
{
    (void)state;
    static const char *const laws[] = {small_mix, small_capped};
    for (int k = 0; k < 2; k++)
        for (int horizon = 1; horizon <= 2; horizon++)
            compare(
                (struct small_case){.horizon = horizon, .stabilisation = laws[k], .n_phases = 2},
                small_two_phases, small_two_phases);
}

static void test_flaws(void **state)
{
    (void)state;
    static const char *const laws[] = {small_mix, small_capped};
    for (int k = 0; k < 2; k++)
        compare((struct small_case){.horizon = 1, .stabilisation = laws[k]}, "{A: {" FLOWING FLAW,
                "{A: {" FLOWING IMAGE);
    compare((struct small_case){.horizon = 2.015, .influence = 3}, "{A: {" PLASTIC FLAW,
            "{A: {" PLASTIC IMAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_phases_of_springs),
        cmocka_unit_test(test_phases_of_correspondence),
        cmocka_unit_test(test_flaws),
    };
    return cmocka_run_group_tests_name("mirror", tests, small_ranks_start, small_ranks_stop);
}
