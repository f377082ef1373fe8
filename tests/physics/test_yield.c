/* Yield stresses that vary from node to node. */
#include "check.h"

#include "small_body.h"

#include <stdlib.h>

#define STEEL "model: correspondence, density: 7800, youngs_modulus: 211 GPa, poissons_ratio: 0"
#define LAW   "hardening: {law: linear, yield: 460 MPa, modulus: 5 GPa}"

static const double young = 211e9, yield = 460e6, slope = 5e9;

static void start(struct small_body *small, const char *stabilisation, const char *materials)
{
    small_body_new(small, &(struct small_case){.size = {4, 24, 4},
                                               .horizon = 3.004,
                                               .stabilisation = stabilisation,
                                               .materials = materials});
}

/* Fully prescribed uniaxial strain with a soft flaw, a verification case of Peridigm (its bar of 1
 * x 6 x 1 and radius 0.751, in spacings of a quarter): with nu = 0, 2 mu = E and, sigma_y reduced
 * but not its slope, p = (E ln F - sigma_y)/(3 E/2 + H),  q = sigma_y + H p at every node.  (j2.3)
 * is exact for strains along one axis; what is left is round-off of the tables. */
static void test_flaw_in_uniaxial_strain(void **state)
{
    (void)state;
    static const char materials[] =
        "{A: {" STEEL ", " LAW ", flaw: {centre: [37.5 um, 287.5 um, 37.5 um], "
        "radius: 75.1 um, reduction: 0.2}}}";
    static const char *const laws[] = {small_mix, small_capped};
    for (int k = 0; k < 2; k++) {
        struct small_body small;
        double low = 1, high = 0;
        start(&small, laws[k], materials);
        for (int step = 1; step <= 4; step++) {
            const double F = 1 + 0.025 * step;
            small_body_deform(&small, (double[9]){0, 0, 0, 0, F - 1});
            small_body_force(&small, true, false);
            for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
                static const double centre[3] = {37.5e-6, 287.5e-6, 37.5e-6};
                double x[3], square = 0;
                struct node_state node;
                if (!small_body_has(&small, site)) continue;
                body_position(&small.body, site, x);
                for (int a = 0; a < 3; a++) square += (x[a] - centre[a]) * (x[a] - centre[a]);
                const double soft = yield * (1 - 0.2 * exp(-square / (75.1e-6 * 75.1e-6)));
                const double exact = (young * log(F) - soft) / (1.5 * young + slope);
                const int i = small_body_observe(&small, site, &node);
                assert_relative(node.plastic[i], exact, 1e-9);
                /* Of Kirchhoff's stress. */
                assert_relative(F * (node.cauchy[1][i] - node.cauchy[0][i]), soft + slope * exact,
                                1e-9);
                low = fmin(low, soft / yield);
                high = fmax(high, soft / yield);
            }
        }
        assert_true(low < 0.82 && high > 0.999);
        small_body_free(&small);
    }
}

/* Mean and deviation of 384 nodes: 1/sqrt(384) = 5 % of a deviation, three times that; of the share
 * within one deviation, sqrt(0.684 0.316/384) = 2.4 %. */
static void test_scatter(void **state)
{
    (void)state;
    struct small_body one, other;
    double sum = 0, squares = 0, most = 0;
    int n = 0, same = 0, within = 0;
    start(&one, small_mix, "{A: {" STEEL ", " LAW ", yield_scatter: {deviation: 0.05, seed: 3}}}");
    start(&other, small_mix,
          "{A: {" STEEL ", " LAW ", yield_scatter: {deviation: 0.05, seed: 4}}}");
    for (int64_t site = 0; site < one.body.grid.n_sites; site++) {
        if (!small_body_has(&one, site)) continue;
        const double g = one.body.yield_shift[site] / (0.05 * yield);
        sum += g;
        squares += g * g;
        most = fmax(most, fabs(g));
        within += fabs(g) < 1;
        n++;
        same += one.body.yield_shift[site] == other.body.yield_shift[site];
    }
    assert_near(sum / n, 0, 0.15);
    assert_near(sqrt(squares / n), 1, 0.11);
    assert_near((double)within / n, 0.6845, 0.07); /* erf(1/sqrt 2)/erf(3/sqrt 2) */
    assert_true(most > 2 && most <= 3);
    assert_int_equal(same, 0);
    small_body_free(&one);
    small_body_free(&other);
}

#define PLAIN                                                                                      \
    "density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31, hardening: {law: linear, "      \
    "modulus: 2 GPa, yield: "
#define WEAK   PLAIN "100 MPa}}}"
#define FLAWED PLAIN "200 MPa}, flaw: {centre: [0, 0, 0], radius: 1000 m, reduction: 0.5}}}"

/* Strains up to some per cent that differ from node to node: stabilisations act, and slip. */
static void bend(struct small_body *small, double amount)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        const double x = at[0], y = at[1], z = at[2], scale = amount * SMALL_SPACING;
        small->body.u[0][site] = scale * (x + 0.1 * x * x - 0.1 * y * z);
        small->body.u[1][site] = scale * (0.2 * x * y - 0.4 * y);
        small->body.u[2][site] = scale * (0.1 * x * z + 0.3 * y * z - 0.4 * z);
    }
}

/* Half of the yield stress everywhere by a flaw, and by the law: the same body.  Both tables of a
 * flow curve are good to 1e-9 of it, and the flaw's edge is 1e-14 lower. */
static void compare_weak(struct small_case wanted, const char *weak, const char *flawed)
{
    struct small_body small[2];
    for (int k = 0; k < 2; k++) {
        wanted.size[0] = 6;
        wanted.size[1] = wanted.size[2] = 4;
        wanted.materials = k ? flawed : weak;
        small_body_new(&small[k], &wanted);
    }
    for (int step = 1; step <= 4; step++)
        for (int k = 0; k < 2; k++) {
            bend(&small[k], 0.004 * step);
            small_body_force(&small[k], true, false);
            damage_grow(small[k].damage);
        }
    for (int k = 0; k < 2; k++) {
        bend(&small[k], 0.018);
        small_body_force(&small[k], false, false);
    }
    double range[2];
    const double most = small_body_largest(&small[0], small[0].body.f);
    small_body_plastic_range(&small[0], range);
    assert_true(range[1] > 0.01);
    for (int64_t site = 0; site < small[0].body.grid.n_sites; site++) {
        if (!small_body_has(&small[0], site)) continue;
        for (int a = 0; a < 3; a++)
            assert_near(small[1].body.f[a][site], small[0].body.f[a][site], 1e-8 * most);
    }
    assert_relative(small_body_potential(&small[1]), small_body_potential(&small[0]), 1e-8);
    for (int k = 0; k < 2; k++) small_body_free(&small[k]);
}

static void test_flaw_without_an_end_is_another_yield_stress(void **state)
{
    (void)state;
    static const char breaking[] = "damage: [{phase: A, law: ductile, onset: 0.002, full: 0.2}]";
    for (int damaged = 0; damaged < 2; damaged++) {
        const char *sections = damaged ? breaking : NULL;
        compare_weak(
            (struct small_case){.horizon = 1, .stabilisation = small_mix, .breaking = sections},
            "{A: {model: correspondence, " WEAK, "{A: {model: correspondence, " FLAWED);
        compare_weak(
            (struct small_case){.horizon = 2, .stabilisation = small_capped, .breaking = sections},
            "{A: {model: correspondence, " WEAK, "{A: {model: correspondence, " FLAWED);
        compare_weak((struct small_case){.horizon = 2.015, .influence = 3, .breaking = sections},
                     "{A: {model: ordinary_plastic, " WEAK,
                     "{A: {model: ordinary_plastic, " FLAWED);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flaw_in_uniaxial_strain),
        cmocka_unit_test(test_scatter),
        cmocka_unit_test(test_flaw_without_an_end_is_another_yield_stress),
    };
    return cmocka_run_group_tests_name("yield", tests, small_ranks_start, small_ranks_stop);
}
