/* Plasticity of the linear peridynamic solid: the yield of a node deep inside a body in uniform
 * strain, hardening, energy, and what finite strain does to it. */
#include "check.h"

#include "memory.h"
#include "small_body.h"
#include "verlet.h"

#include <stdlib.h>
#include <string.h>

#define ELASTIC "density: 7800, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
static const double E = 210e9, nu = 0.31, mu = 210e9 / 2.62, yield = 200e6;
static const char hard[] = "{A: {model: ordinary_plastic, " ELASTIC
                           ", hardening: {law: linear, yield: 200 MPa, modulus: 5 GPa}}}";
static const char perfect[] = "{A: {model: ordinary_plastic, " ELASTIC
                              ", hardening: {law: linear, yield: 200 MPa, modulus: 0 Pa}}}";
static const char two_phases[] =
    "{A: {model: ordinary_plastic, " ELASTIC
    ", hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}}, "
    "B: {model: ordinary_plastic, " ELASTIC
    ", hardening: {law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}}}";

static void body_of(struct small_body *small, const char *materials, const char *influence)
{
    small_body_new(
        small, &(struct small_case){
                   {7, 7, 7}, 3.015, family_influence(influence), NULL, materials, .n_phases = 1});
}

/* q of a pure shear: sqrt(3 mu (15 mu/m) sum w e^2) with e = 2 gamma x y/r, over a family of three
 * spacings, all of whose bonds weigh one; of a continuum 2 sqrt(3) mu gamma. */
static double shear_stress(double gamma)
{
    double m = 0, square = 0;
    for (int z = -3; z <= 3; z++)
        for (int y = -3; y <= 3; y++)
            for (int x = -3; x <= 3; x++) {
                const double r2 = x * x + y * y + z * z;
                if (r2 == 0 || r2 > 3.015 * 3.015) continue;
                m += r2;
                square += 4 * gamma * gamma * x * x * y * y / r2;
            }
    return sqrt(45 * mu * mu / m * square);
}

/* Pure shear, of amplitudes so small that what is of second order does not count, 1e-5 of them; in
 * units of the yield strain. */
static void shear(struct small_body *small, double gamma)
{
    small_body_deform(small, (const double[]){0, gamma, 0, gamma, 0, 0, 0, 0, 0});
}

static double plastic_strain(struct small_body *small)
{
    struct node_state node;
    const int i = small_body_observe(small, small_body_middle(small), &node);
    return node.plastic[i];
}

/* Yield at q = sigma_y: a millionth of it below, nothing; a hundred thousandth above, flow. */
static void test_yields_at_the_yield_stress(void **state)
{
    (void)state;
    struct small_body small;
    body_of(&small, hard, "constant");
    /* Finite strain: e is larger than 2 gamma x y/r by some gamma/2. */
    const double gamma = yield / shear_stress(1), second = 3 * gamma;
    double P[9];
    shear(&small, gamma * (1 - second));
    small_body_force(&small, true, false);
    assert_true(plastic_strain(&small) == 0);
    small_body_stress(&small, small_body_middle(&small), P);
    shear(&small, gamma * (1 + second));
    small_body_force(&small, true, false);
    assert_true(plastic_strain(&small) > 0);
    assert_true(plastic_strain(&small) < 4 * second * yield / (3 * mu));
    small_body_free(&small);
}

/* Proportional shear to five times the yield strain in one step and in twenty: 3 mu (p_all - p) = Y
 * + H p with 3 mu p_all = q of the strain.  What finite strain adds is of the order of the strain
 * itself, 5e-3 at most. */
static void check_hardening(const char *materials, double modulus, int steps)
{
    struct small_body small;
    double P[9], elastic[9];
    const double gamma = 5 * yield / shear_stress(1), all = shear_stress(gamma);
    const double p = (all - yield) / (3 * mu + modulus);
    body_of(&small, materials, "constant");
    shear(&small, 1e-4 * gamma);
    small_body_stress(&small, small_body_middle(&small), elastic);
    for (int n = 1; n <= steps; n++) {
        shear(&small, gamma * n / steps);
        small_body_force(&small, true, false);
    }
    assert_relative(plastic_strain(&small), p, 1e-2);
    small_body_stress(&small, small_body_middle(&small), P);
    assert_relative(P[1], 1e4 * elastic[1] * (yield + modulus * p) / all, 1e-2);
    /* held, nothing moves: the second time nothing but rounding lies beyond yield */
    const double before = plastic_strain(&small);
    for (int n = 0; n < 20; n++) small_body_force(&small, true, false);
    assert_relative(plastic_strain(&small), before, 1e-12);
    small_body_free(&small);
}

static void test_hardening_and_perfect_plasticity(void **state)
{
    (void)state;
    static const int steps[] = {1, 20};
    for (int n = 0; n < 2; n++) {
        check_hardening(hard, 5e9, steps[n]);
        check_hardening(perfect, 0, steps[n]);
    }
}

/* What bonds hold after a step of flow is what the same state, found again, says: only rounding is
 * between them. */
static void test_energy_of_bonds_after_flow(void **state)
{
    (void)state;
    struct small_body small;
    double flowing[BOND_LANES], again[BOND_LANES];
    int64_t compared = 0;
    body_of(&small, hard, "constant");
    shear(&small, 3 * yield / shear_stress(1));
    const struct formulation *formulation = small.model->formulation;
    for (int64_t s = 0; s < small.bonds->count; s += 7) {
        const struct bond_strip *strip = &small.bonds->strips[s];
        /* Each strip is seen after a flow of its own. */
        shear(&small, (3 + 0.01 * (double)s) * yield / shear_stress(1));
        small_body_force(&small, true, false);
        formulation->bond_energy(small.model->self, &small.body, strip, flowing);
        small_body_force(&small, false, false);
        formulation->bond_energy(small.model->self, &small.body, strip, again);
        for (int k = 0; k < strip->count; k++, compared++)
            assert_relative(flowing[k], again[k], 1e-9);
        if (s > 70) break;
    }
    assert_true(compared > 20);
    small_body_free(&small);
}

/* A node that has flowed, unloaded, then loses its most stretched bonds: what is left of its family
 * has flowed, but holds nothing, so that no pressure comes of it.  What finite strain leaves is of
 * the order of 4 gamma, the stress of a dilatation by flow would be a tenth of (K - 5 mu/3) gamma
 * or more. */
static void test_lost_bonds_of_what_has_flowed(void **state)
{
    (void)state;
    struct small_body small;
    const double gamma = 5 * yield / shear_stress(1);
    double low = 0, high = gamma, P[9];
    char *breaking = memory_print("damage: [{pair: [A, A], law: critical_stretch, value: %g}]",
                                  0.6 * (gamma - yield / shear_stress(1)));
    small_body_new(&small, &(struct small_case){{7, 7, 7},
                                                3.015,
                                                family_influence("constant"),
                                                NULL,
                                                hard,
                                                .n_phases = 1,
                                                .breaking = breaking});
    for (int n = 1; n <= 20; n++) {
        shear(&small, gamma * n / 20);
        small_body_force(&small, true, false);
    }
    for (int n = 0; n < 45; n++) {
        shear(&small, 0.5 * (low + high));
        small_body_stress(&small, small_body_middle(&small), P);
        *(P[1] < 0 ? &low : &high) = 0.5 * (low + high);
    }
    small_body_force(&small, false, false);
    assert_true(damage_find(small.damage));
    damage_break(small.damage);
    assert_true(damage_broken_bonds(small.damage) > 100);
    small_body_stress(&small, small_body_middle(&small), P);
    for (int k = 0; k < 9; k++) assert_near(P[k], 0, 8 * gamma * mu * gamma);
    small_body_free(&small);
    free(breaking);
}

/* Flow has no change of volume: after shear and stretch into plastic flow, a hydrostatic strain
 * added to it changes the mean stress of the node by 3 K times it, as in the elastic body: to
 * second order of the strains. */
static void test_flow_keeps_the_volume(void **state)
{
    (void)state;
    struct small_body small;
    double P[9], Q[9];
    const double H[9] = {0.004, 0.002, 0, 0.002, -0.001, 0, 0, 0, -0.003}, e = 1e-6;
    double more[9];
    for (int k = 0; k < 9; k++) more[k] = H[k] + (k % 4 == 0 ? e : 0);
    body_of(&small, hard, "linear");
    small_body_deform(&small, H);
    small_body_force(&small, true, false);
    assert_true(plastic_strain(&small) > 1e-3);
    small_body_stress(&small, small_body_middle(&small), P);
    small_body_deform(&small, more);
    small_body_stress(&small, small_body_middle(&small), Q);
    const double K = E / (3 * (1 - 2 * nu));
    assert_relative(Q[0] + Q[4] + Q[8] - P[0] - P[4] - P[8], 9 * K * e, 0.02);
    small_body_free(&small);
}

static uint8_t rugged(const int size[3], const int at[3])
{
    bool notch = at[0] > 3 && at[0] < 6 && at[1] < 3;
    bool step = at[2] > size[2] - 3 && at[1] > size[1] - 4;
    return notch || step ? ABSENT : (uint8_t)((at[0] / 3 + at[1] / 2 + at[2]) % 2);
}

/* A body of two phases with surfaces, strained unevenly into flow and held: each node returns in
 * one step, so that forces and plastic strain stay what they are, but for rounding of the trial
 * norm, 1e-15 of it a step. */
static void test_held_body_settles(void **state)
{
    (void)state;
    struct small_body small;
    double range[2], held[2], worst = 0;
    small_body_new(&small, &(struct small_case){{11, 8, 7},
                                                3.015,
                                                family_influence("constant"),
                                                NULL,
                                                two_phases,
                                                .n_phases = 2,
                                                .phase = rugged,
                                                .surface_correction = "energy"});
    small_body_deform(&small, (const double[]){0.03, 0.01, 0, 0.002, -0.012, 0, 0.004, 0, -0.015});
    small_body_shake(&small, 0.01, 1);
    small_body_force(&small, true, false);
    small_body_plastic_range(&small, range);
    assert_true(range[1] > 0.01);
    const size_t n = (size_t)small.body.grid.n_sites;
    double *before = memory_new(n, sizeof *before);
    memcpy(before, small.body.f[0], n * sizeof *before);
    const double most = small_body_largest(&small, small.body.f);
    for (int step = 0; step < 50; step++) small_body_force(&small, true, false);
    small_body_plastic_range(&small, held);
    for (size_t i = 0; i < n; i++) worst = fmax(worst, fabs(small.body.f[0][i] - before[i]));
    assert_near(held[0], range[0], 1e-12 * range[1]);
    assert_near(held[1], range[1], 1e-12 * range[1]);
    assert_near(worst, 0, 1e-12 * most);
    free(before);
    small_body_free(&small);
}

static double total(const struct energy_balance *b)
{
    return b->kinetic + b->stored + b->plastic + b->stabilisation;
}

struct flight {
    double drift, plastic;
};

static struct flight fly(double dt, int steps)
{
    struct small_body small;
    struct boundary nothing = small_free_boundary();
    struct flight flight = {0, 0};
    small_body_new(&small, &(struct small_case){{11, 8, 7},
                                                2.015,
                                                family_influence("linear"),
                                                NULL,
                                                two_phases,
                                                .n_phases = 2,
                                                .phase = rugged});
    small_body_strike(&small, 60);
    struct integration integration =
        integration_new(true, dt, 0, &small.materials, &small.body, &nothing, small.model);
    const double initial = total(&integration.balance);
    for (int n = 0; n < steps; n++) {
        verlet_step(&integration, &small.body, &nothing, small.model, true, false);
        flight.drift = fmax(flight.drift, fabs(total(&integration.balance) - initial) / initial);
    }
    flight.plastic = integration.balance.plastic / initial;
    integration_free(&integration);
    boundary_free(&nothing);
    small_body_free(&small);
    return flight;
}

/* A body of two phases, struck so that much of its energy goes into plastic flow: the energy that
 * velocity Verlet keeps differs from this one by (omega dt)^2, and so does what is left at half the
 * step. */
static void test_energy_of_plastic_vibration(void **state)
{
    (void)state;
    struct flight coarse = fly(1e-9, 1000), fine = fly(0.5e-9, 2000);
    assert_true(coarse.drift < 2e-3);
    assert_true(fine.drift < coarse.drift / 3);
    assert_true(fine.plastic > 0.2 && fine.plastic < 0.9);
}

/* The node in the middle under uniaxial stress along x: lateral strain by bisection, then
 * committed. */
static double pull(struct small_body *small, double strain, double *lateral)
{
    const int64_t middle = small_body_middle(small);
    double low = *lateral - 0.002, high = *lateral + 0.002, P[9];
    for (int n = 0; n < 45; n++) {
        *lateral = 0.5 * (low + high);
        small_body_deform(small, (const double[]){strain, 0, 0, 0, *lateral, 0, 0, 0, *lateral});
        small_body_stress(small, middle, P);
        *(P[4] < 0 ? &low : &high) = *lateral;
    }
    small_body_force(small, true, false);
    return P[0];
}

/* Limits of the model, which its documentation states: bonds measure an engineering strain, so that
 * a pull of 16 % loses volume and hardens by geometry where the exact stress, of J2 plasticity in
 * logarithmic strain, falls. */
static void test_limits_at_finite_strain(void **state)
{
    (void)state;
    static const double wanted[] = {0.01, 0.05, 0.10, 0.1575};
    static const struct {
        const char *materials, *exact;
    } laws[] = {{"{A: {model: ordinary_plastic, " ELASTIC
                 ", hardening: {law: linear, yield: 185 MPa, modulus: 898 MPa}}}",
                 "{A: {model: correspondence, " ELASTIC
                 ", hardening: {law: linear, yield: 185 MPa, modulus: 898 MPa}}}"},
                {perfect, "{A: {model: correspondence, " ELASTIC
                          ", hardening: {law: linear, yield: 200 MPa, modulus: 0 Pa}}}"}};
    for (int law = 0; law < 2; law++) {
        struct small_body small, exact;
        double strain = 0, lateral = 0, excess[4], volume[4], stress[4];
        body_of(&small, laws[law].materials, "linear");
        small_body_new(&exact, &(struct small_case){
                                   {2, 2, 2}, 1, 0, small_mix, laws[law].exact, .n_phases = 1});
        struct small_point point = small_point_new(&exact.materials);
        for (int n = 0; n < 4; n++) {
            const int steps = (int)ceil((wanted[n] - strain) / 0.00251);
            const double from = strain;
            for (int k = 1; k <= steps; k++) {
                strain = from + (wanted[n] - from) * k / steps;
                stress[n] = pull(&small, strain, &lateral);
                small_point_stretch(&point, &exact.materials, strain);
            }
            excess[n] = stress[n] / point.stress - 1;
            volume[n] = (1 + strain) * (1 + lateral) * (1 + lateral);
        }
        assert_near(excess[0], 0, 0.03);
        for (int n = 1; n < 4; n++) {
            assert_true(excess[n] > excess[n - 1] && volume[n] < volume[n - 1]);
            assert_true(stress[n] > stress[n - 1]); /* no maximum of force */
        }
        /* The figures of docs/theory.md, rounded. */
        assert_near(excess[3], law ? 0.25 : 0.31, 0.01);
        assert_near(volume[3], 0.971, 0.001);
        small_body_free(&small);
        small_body_free(&exact);
    }
}

/* Blocks beyond each other's horizon. */
enum { BLOCK = 6, GAP = 4 };
static uint8_t two_blocks(const int size[3], const int at[3])
{
    (void)size;
    return at[0] >= BLOCK && at[0] < BLOCK + GAP ? ABSENT : 0;
}

/* Both blocks sheared, the right one by another amplitude. */
static void shear_blocks(struct small_body *small, double left, double right)
{
    shear(small, left);
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        for (int a = 0; a < 2 && at[0] >= BLOCK; a++) small->body.u[a][site] *= right / left;
    }
}

/* What is left out of the work before anything yields changes no bit: the forces on a block are the
 * same whether or not another one has yielded long before. */
static void test_nothing_is_lost_before_yield(void **state)
{
    (void)state;
    static const double left[] = {0.2, 0.6, 0.9, 1.3, 2, 0.5};
    struct small_body small[2];
    double range[2];
    int64_t compared = 0;
    const double gamma = yield / shear_stress(1);
    for (int n = 0; n < 2; n++)
        small_body_new(&small[n],
                       &(struct small_case){
                           {2 * BLOCK + GAP, 5, 5}, 3.015, .materials = hard, .phase = two_blocks});
    for (size_t step = 0; step < sizeof left / sizeof *left; step++) {
        for (int n = 0; n < 2; n++) {
            shear_blocks(&small[n], left[step] * gamma, n ? 5 * gamma : 0.1 * gamma);
            small_body_force(&small[n], true, false);
        }
        if (step == 0) {
            body_need_gradient(&small[0].body);
            body_need_gradient(&small[1].body);
            small_body_plastic_range(&small[0], range);
            assert_true(range[1] == 0);
            small_body_plastic_range(&small[1], range);
            assert_true(range[1] > 0);
        }
        for (int64_t site = 0; site < small[0].body.grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&small[0], site)) continue;
            small_body_position(&small[0], site, at);
            for (int a = 0; a < 3 && at[0] < BLOCK; a++, compared++)
                assert_true(small[0].body.f[a][site] == small[1].body.f[a][site]);
        }
    }
    small_body_plastic_range(&small[0], range);
    assert_true(range[1] > 0);
    assert_true(compared == 6 * 3 * BLOCK * 5 * 5);
    for (int n = 0; n < 2; n++) small_body_free(&small[n]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_yields_at_the_yield_stress),
        cmocka_unit_test(test_hardening_and_perfect_plasticity),
        cmocka_unit_test(test_energy_of_bonds_after_flow),
        cmocka_unit_test(test_lost_bonds_of_what_has_flowed),
        cmocka_unit_test(test_flow_keeps_the_volume),
        cmocka_unit_test(test_held_body_settles),
        cmocka_unit_test(test_energy_of_plastic_vibration),
        cmocka_unit_test(test_limits_at_finite_strain),
        cmocka_unit_test(test_nothing_is_lost_before_yield),
    };
    return cmocka_run_group_tests_name("ordinary_plastic", tests, small_ranks_start,
                                       small_ranks_stop);
}
