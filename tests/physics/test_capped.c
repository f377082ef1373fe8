/* Bond springs of `capped` beyond their cap, turned, and in nodes that degrade: on the motion that
 * alternates from node to node, of which inner nodes have no gradient, so that the springs are all
 * there is. */
#include "check.h"

#include "integrity.h"
#include "small_body.h"

#include <math.h>

enum { SIDE = 8 };
static const double young = 210e9, yield = 300e6, cap = 0.05; /* C, the default */
static const char materials[] =
    "{A: {model: correspondence, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31, "
    "hardening: {law: linear, yield: 300 MPa, modulus: 1 GPa}}}";

static void start(struct small_body *small, const char *breaking)
{
    small_body_new(small, &(struct small_case){.size = {SIDE, SIDE, SIDE},
                                               .horizon = 1,
                                               .stabilisation = small_capped,
                                               .materials = materials,
                                               .breaking = breaking});
}

/* u_x = amplitude (-1)^(x + y + z), then all turned by a right angle about z. */
static void alternate(struct small_body *small, double amplitude, bool turned)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        const double X = at[0] * SMALL_SPACING, Y = at[1] * SMALL_SPACING;
        const double x = X + ((at[0] + at[1] + at[2]) % 2 ? -amplitude : amplitude);
        small->body.u[0][site] = turned ? -Y - X : x - X;
        small->body.u[1][site] = turned ? x - Y : 0;
        small->body.u[2][site] = 0;
    }
}

static bool is_inner(const struct small_body *small, int64_t site)
{
    int at[3];
    if (!small_body_has(small, site)) return false;
    small_body_position(small, site, at);
    for (int a = 0; a < 3; a++)
        if (at[a] < 3 || at[a] >= SIDE - 3) return false;
    return true;
}

/* Inner nodes are three layers from the surface: with neighbours that have no gradient, and no
 * stress of springs, either. Of all six bonds of such a node |z| = 2 amplitude; beyond z_c the
 * force grows by 0.001/1.001 of the elastic one. */
static void test_force_beyond_the_cap(void **state)
{
    (void)state;
    const double limit = cap * yield / young * SMALL_SPACING;
    struct small_body small;
    start(&small, NULL);
    int64_t site = 0;
    while (!is_inner(&small, site)) site++;
    alternate(&small, 0.25 * limit, false);
    small_body_force(&small, false, false);
    const double elastic = small.body.f[0][site] / (0.5 * limit); /* by |z| */
    static const double ways[] = {0.9, 1.1, 3, 20};               /* |z|/z_c */
    for (int k = 0; k < 4; k++) {
        const double z = ways[k] * limit;
        alternate(&small, 0.5 * z, false);
        small_body_force(&small, false, false);
        const double held = z <= limit ? z : limit + 0.001 / 1.001 * (z - limit);
        /* the tables' 1e-9 of the flow stress */
        assert_relative(small.body.f[0][site], elastic * held, 1e-8);
    }
    small_body_free(&small);
}

static uint8_t halves(const int size[3], const int at[3])
{
    return at[0] >= size[0] / 2;
}

/* Of two halves, the second with a ninth of the stiffness, one is moved off by d.  The layers
 * beside the interface have H_xx = d/(2 dx), so that |z| is d/2 of a bond across it and d/4 of
 * those behind either layer: the springs store M_AB/4 + (M_A + M_B)/16, with M_AB = 2 (1/9)/(1 +
 * 1/9) = 0.2 of halves in series, where their mean would be 0.56.  Strains of 5e-7 are linear to
 * that. */
static void test_springs_between_phases(void **state)
{
    (void)state;
    const double d = 1e-6 * SMALL_SPACING, nu = 0.31, ninth = 1. / 9,
                 modulus = young * (1 - nu) / (1 + nu) / (1 - 2 * nu),
                 nodes = 2 * SIDE * SIDE * pow(SMALL_SPACING, 3) * 0.5 * modulus * 0.25 * 1e-12;
    double springs[2];
    for (int k = 0; k < 2; k++) {
        char text[400];
        snprintf(text, sizeof text,
                 "{A: {model: correspondence_elastic, density: 8900, youngs_modulus: 210 GPa, "
                 "poissons_ratio: 0.31}, B: {model: correspondence_elastic, density: 8900, "
                 "youngs_modulus: %.17g, poissons_ratio: 0.31}}",
                 k ? young * ninth : young);
        struct small_body small;
        small_body_new(&small, &(struct small_case){.size = {SIDE, SIDE, SIDE},
                                                    .horizon = 1,
                                                    .stabilisation = small_capped,
                                                    .n_phases = 2,
                                                    .phase = halves,
                                                    .materials = text});
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&small, site)) continue;
            small_body_position(&small, site, at);
            small.body.u[0][site] = at[0] >= SIDE / 2 ? d : 0;
        }
        small_body_force(&small, false, false);
        springs[k] = small_body_elastic_energy(&small) - (k ? 0.5 * (1 + ninth) : 1) * nodes;
        small_body_free(&small);
    }
    assert_relative(springs[1] / springs[0], (0.2 / 4 + (1 + ninth) / 16) / (1. / 4 + 2. / 16),
                    1e-5);
}

/* A slip that came about in a turned body is the same slip: forces turn with the body, and back
 * again. */
static void test_slip_turns(void **state)
{
    (void)state;
    const double amplitude = 5 * cap * yield / young * SMALL_SPACING;
    struct small_body upright, turned;
    start(&upright, NULL);
    start(&turned, NULL);
    alternate(&upright, amplitude, false);
    alternate(&turned, amplitude, true);
    small_body_force(&upright, true, false);
    small_body_force(&turned, true, false);
    for (int back = 0; back < 2; back++) {
        alternate(&upright, 0.9 * amplitude, false);
        alternate(&turned, 0.9 * amplitude, !back);
        small_body_force(&upright, false, false);
        small_body_force(&turned, false, false);
        const double most = small_body_largest(&upright, upright.body.f);
        for (int64_t site = 0; site < upright.body.grid.n_sites; site++) {
            if (!is_inner(&upright, site)) continue;
            double *const *f = upright.body.f, *const *g = turned.body.f;
            /* differences of displacements as large as the body: 1e-16 * 8 spacings over the
             * amplitude of 3.6e-4 of one */
            assert_near(g[0][site], back ? f[0][site] : -f[1][site], 1e-10 * most);
            assert_near(g[1][site], back ? f[1][site] : f[0][site], 1e-10 * most);
        }
        assert_true(most > 0);
    }
    small_body_free(&upright);
    small_body_free(&turned);
}

/* stored + plastic + stabilisation after a committed force [J] */
static double energy_of(struct small_body *small)
{
    const struct exact_sum zero = exact_sum_new(1e-3);
    struct force_energy energy = {zero, zero, zero};
    double values[3];
    model_force(small->model, &small->body, (struct force_mode){.commit = true, .energy = true},
                &energy);
    exact_sum_finish(
        (const struct exact_sum[]){energy.stored, energy.plastic, energy.stabilisation}, 3, values);
    return values[0] + values[1] + values[2];
}

/* Where nothing moves, what nodes that degrade store no more has been dissipated: the sum stays, to
 * rounding.  Below the cap and below yield, so that nothing else dissipates. */
static void test_degrading_turns_stored_energy_into_dissipated(void **state)
{
    (void)state;
    struct small_body small;
    start(&small, "damage: [{phase: A, law: ductile, onset: 0.1, full: 0.2}]");
    assert_non_null(small.body.integrity);
    alternate(&small, 0.3 * cap * yield / young * SMALL_SPACING, false);
    const double before = energy_of(&small);
    assert_true(before > 0);
    for (int step = 1; step <= 3; step++) {
        for (int64_t site = 0; site < small.body.grid.n_sites; site++)
            small.body.integrity->node[site] = 1 - 0.25 * step;
        small.body.integrity->whole = false;
        assert_relative(energy_of(&small), before, 1e-10);
    }
    small_body_free(&small);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_force_beyond_the_cap),
        cmocka_unit_test(test_springs_between_phases),
        cmocka_unit_test(test_slip_turns),
        cmocka_unit_test(test_degrading_turns_stored_energy_into_dissipated),
    };
    return cmocka_run_group_tests_name("capped", tests, small_ranks_start, small_ranks_stop);
}
