/* Nodes whose stress is degraded by their plastic strain, and which then are removed. */
#include "check.h"
#include "dies.h"

#include "integrity.h"
#include "memory.h"
#include "small_body.h"

#include <stdlib.h>
#include <string.h>

static const double young = 210e9, poisson = 0.31, onset = 0.2, full = 0.35;
#define DUCTILE "damage: [{phase: A, law: ductile, onset: 0.2, full: 0.35}]"

static const char ordinary[] =
    "{A: {model: ordinary_plastic, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31, "
    "hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}}}";

/* The law of small_nickel, by its formula. */
static double yield_stress(double p)
{
    return 182.1e6 + 513.0e6 * (1 - exp(-5.320 * p));
}

/* Plastic strain of a bar of the logarithmic strain e under uniaxial stress: e = p + sigma_y(p)/E.
 */
static double plastic_strain(double e)
{
    double low = 0, high = e;
    for (int k = 0; k < 100; k++) {
        const double p = 0.5 * (low + high);
        *(p + yield_stress(p) / young < e ? &low : &high) = p;
    }
    return 0.5 * (low + high);
}

static double damage_of(double p)
{
    return fmin(fmax((p - onset) / (full - onset), 0), 1);
}

static void start(struct small_body *small, const char *stabilisation, double horizon,
                  const char *breaking)
{
    small_body_new(small, &(struct small_case){.size = {4, 3, 3},
                                               .horizon = horizon,
                                               .stabilisation = stabilisation,
                                               .materials = stabilisation ? small_nickel : ordinary,
                                               .breaking = breaking});
}

/* Stretched to 1 + strain, at the contraction of uniaxial stress. */
static void stretch(struct small_body *small, double strain)
{
    const double e = log(1 + strain), p = plastic_strain(e);
    const double lateral = expm1(-poisson * (e - p) - 0.5 * p);
    small_body_deform(small, (double[9]){strain, 0, 0, 0, lateral, 0, 0, 0, lateral});
}

/* Energies of a force [J], and the nominal stress of the middle node, share of the bonds included
 * [Pa]. */
struct answer {
    double held, axial;
};

/* Nominal stress xx of a node, as of the last force to be recorded. */
static double nominal_stress(struct small_body *small, int64_t site)
{
    struct node_state node;
    const int i = small_body_observe(small, site, &node);
    return node.nominal[i];
}

static struct answer force(struct small_body *small, bool commit)
{
    const struct exact_sum zero =
        exact_sum_new(young * (double)small->lattice.n_nodes * small->body.volume);
    struct force_energy energy = {zero, zero, zero};
    double values[3];
    model_force(small->model, &small->body,
                (struct force_mode){.commit = commit, .energy = true, .record = true}, &energy);
    exact_sum_finish(
        (const struct exact_sum[]){energy.stored, energy.plastic, energy.stabilisation}, 3, values);
    return (struct answer){values[0] + values[1] + values[2],
                           nominal_stress(small, small_body_middle(small))};
}

/* A state that is accepted: the largest growth of damage. */
static double accept(struct small_body *small, double strain)
{
    stretch(small, strain);
    force(small, true);
    return damage_grow(small->damage);
}

static const struct {
    const char *stabilisation;
    double horizon;
} cases[] = {{small_mix, 1}, {small_mix, 2}, {small_capped, 2}};

/* Uniform tension against 1 - D(p) times the sound material's stress, both by formulas; the tables
 * of the law are good to 1e-9.  At full all nodes go at once and nothing is left. */
static void test_uniform_tension(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct small_body small;
        double most = 0;
        start(&small, cases[k].stabilisation, cases[k].horizon, DUCTILE);
        double *index = memory_new((size_t)small.body.grid.n_sites, sizeof *index);
        for (double strain = 0.01; plastic_strain(log(1 + strain)) < full; strain += 0.01) {
            const double p = plastic_strain(log(1 + strain)), D = damage_of(p);
            const double grown = accept(&small, strain);
            assert_near(grown, D - most, 1e-9);
            assert_near(damage_grow(small.damage), 0, 0);
            assert_false(damage_find(small.damage));
            assert_relative(force(&small, false).axial, (1 - D) * yield_stress(p) / (1 + strain),
                            2e-9);
            damage_index(small.damage, index);
            assert_near(index[small_body_middle(&small)], D, 1e-9);
            most = D;
        }
        assert_true(most > 0.9 && most < 1);
        accept(&small, 0.45);
        assert_true(damage_find(small.damage));
        damage_break(small.damage);
        assert_near(damage_removed_nodes(small.damage), 36, 0);
        assert_near(force(&small, true).axial, 0, 0);
        assert_near(small_body_largest(&small, small.body.f), 0, 0);
        free(index);
        small_body_free(&small);
    }
}

/* Forces of states that are tried and not accepted, as an equilibrium's search needs them, leave no
 * trace in what is held or dissipated: to the last bit that of a body that was never there. */
static void test_states_that_are_tried_leave_no_trace(void **state)
{
    (void)state;
    static const double strains[] = {0.1, 0.25, 0.3, 0.34};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct small_body tried, straight;
        start(&tried, cases[k].stabilisation, cases[k].horizon, DUCTILE);
        start(&straight, cases[k].stabilisation, cases[k].horizon, DUCTILE);
        for (size_t n = 0; n < sizeof strains / sizeof *strains; n++) {
            stretch(&tried, 1.3 * strains[n]);
            force(&tried, false);
            stretch(&tried, strains[n]);
            stretch(&straight, strains[n]);
            const struct answer one = force(&tried, true), other = force(&straight, true);
            assert_near(one.held, other.held, 0);
            assert_near(one.axial, other.axial, 0);
            damage_grow(tried.damage);
            damage_grow(straight.damage);
        }
        assert_false(straight.body.integrity->whole);
        small_body_free(&tried);
        small_body_free(&straight);
    }
}

/* Energies held and dissipated since damage began, against the work of the formulas' stress by the
 * trapezoidal rule, damage being that of the state before: relative. */
static double energy_error(const char *stabilisation, double horizon, int steps)
{
    struct small_body small;
    double work = 0, stress = 0, D = 0, before = 0, held = 0;
    start(&small, stabilisation, horizon, DUCTILE);
    const double end = expm1(0.34), volume = 36 * small.body.volume;
    for (int n = 1; n <= steps; n++) {
        const double strain = end * n / steps, p = plastic_strain(log(1 + strain));
        const double now = (1 - D) * yield_stress(p) / (1 + strain);
        stretch(&small, strain);
        held = force(&small, true).held;
        damage_grow(small.damage);
        if (D > 0)
            work += 0.5 * (stress + now) * (end / steps) * volume;
        else
            before = held;
        stress = now;
        D = damage_of(p);
    }
    assert_true(D > 0.9);
    small_body_free(&small);
    return (held - before) / work - 1;
}

/* Displacements of the uniform stretch and a share of a noise. */
static void deform(struct small_body *small, double strain, double *const noise[3], double share)
{
    stretch(small, strain);
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < small->body.grid.n_sites; i++)
            small->body.u[a][i] += share * noise[a][i];
}

static double *copy(const struct small_body *small, const double *field)
{
    const size_t n = (size_t)small->body.grid.n_sites;
    return memcpy(memory_new(n, sizeof(double)), field, n * sizeof(double));
}

/* Energies held and dissipated since damage began against the work of the inner forces by the
 * trapezoidal rule, the nodes moving by a noise, so that the springs, which never slip, hold a good
 * part of the energy: relative. */
static double energy_error_of_springs(int steps)
{
    struct small_body small;
    double *noise[3], *u[3], *f[3], work = 0, before = 0, held = 0, damage = 0;
    start(&small, "{law: capped, stiffness: 0.3, cap: 1000}", 2, DUCTILE);
    const double end = expm1(0.33);
    small_body_shake(&small, 0.03, 7);
    for (int a = 0; a < 3; a++) noise[a] = copy(&small, small.body.u[a]);
    for (int n = 0; n <= steps; n++) {
        for (int a = 0; a < 3; a++) {
            u[a] = copy(&small, small.body.u[a]);
            f[a] = copy(&small, small.body.f[a]);
        }
        deform(&small, end * n / steps, noise, (double)n / steps);
        held = force(&small, true).held;
        for (int a = 0; a < 3; a++)
            for (int64_t i = 0; i < small.body.grid.n_sites; i++) {
                u[a][i] = small.body.u[a][i] - u[a][i];
                f[a][i] += small.body.f[a][i];
            }
        if (damage > 0)
            work -= 0.5 * small.body.volume * small_body_product(&small, f, u);
        else
            before = held;
        damage += damage_grow(small.damage);
        for (int a = 0; a < 3; a++) {
            free(u[a]);
            free(f[a]);
        }
    }
    for (int a = 0; a < 3; a++) free(noise[a]);
    small_body_free(&small);
    assert_true(damage > 0.5);
    return (held - before) / work - 1;
}

/* What a spring releases is booked at the end of the step, by which the error is of first order:
 * half at half the step.  Twice the release would be off by a quarter of the work, whatever the
 * step. */
static void test_energy_of_springs(void **state)
{
    (void)state;
    const double coarse = energy_error_of_springs(300), fine = energy_error_of_springs(600);
    print_message("springs: %.3g, %.3g\n", coarse, fine);
    assert_near(coarse, 0, 2e-3);
    assert_near(fine, 0, 0.55 * fabs(coarse));
}

/* The error of the trapezoidal rule is a quarter at half the step.  A lag of one step in the damage
 * of what is dissipated would make an error of some 1/(steps of the damage), 0.6 and 0.3 %; the
 * energy that damage sets free is 1.7 % of the work. */
static void test_energy_of_uniform_tension(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const double coarse = energy_error(cases[k].stabilisation, cases[k].horizon, 400),
                     fine = energy_error(cases[k].stabilisation, cases[k].horizon, 800);
        print_message("%s, horizon %g: %.3g, %.3g\n", cases[k].stabilisation, cases[k].horizon,
                      coarse, fine);
        assert_near(coarse, 0, 1e-5);
        assert_near(fine, 0, 0.3 * fabs(coarse));
    }
}

/* Damage stands still until it is told to grow: a force that commits nothing depends on u alone. */
static void test_forces_between_growths(void **state)
{
    (void)state;
    struct small_body small;
    start(&small, small_mix, 1, DUCTILE);
    for (int n = 1; n <= 8; n++) accept(&small, 0.04 * n);
    small_body_shake(&small, 1e-2, 1);
    small_body_force(&small, false, false);
    const size_t bytes = (size_t)small.body.grid.n_sites * sizeof(double);
    double *first = memory_new(bytes, 1), *left = memory_new(bytes, 1);
    memcpy(first, small.body.f[0], bytes);
    memcpy(left, small.body.integrity->node, bytes);
    small_body_shake(&small, 0.1, 2);
    small_body_force(&small, false, false);
    assert_true(memcmp(first, small.body.f[0], bytes) != 0);
    stretch(&small, 0.32);
    small_body_shake(&small, 1e-2, 1);
    small_body_force(&small, false, false);
    assert_memory_equal(first, small.body.f[0], bytes);
    assert_near(damage_grow(small.damage), 0, 0);
    assert_memory_equal(left, small.body.integrity->node, bytes);
    assert_true(left[small_body_middle(&small)] < 0.7);
    free(first);
    free(left);
    small_body_free(&small);
}

static uint8_t two_halves(const int size[3], const int at[3])
{
    return at[0] >= size[0] / 2;
}

/* Force between two particles whose integrities are 0.8 and other, over that of sound ones; it is
 * as large at both ends. */
static double share_left(struct small_body *small, double other)
{
    const int64_t a = small_body_middle(small) - 1;
    stretch(small, 1e-5);
    small_body_force(small, false, false);
    const double sound = small->body.f[0][a];
    small->body.integrity->whole = false;
    small->body.integrity->node[a] = 0.8;
    small->body.integrity->node[a + 1] = other;
    small_body_force(small, false, false);
    assert_relative(small->body.f[0][a + 1], -small->body.f[0][a], 1e-14);
    return small->body.f[0][a] / sound;
}

/* Of particles of either phase with integrities of 0.8 and 0.2.  Alone they have no deformation
 * gradient: it is that of the bond. */
static double bond_share(const char *stabilisation, const char *rule)
{
    struct small_body small;
    char *breaking = memory_print("damage: [{phase: A, law: ductile, onset: 0.2, full: 0.4}, "
                                  "{phase: B, law: ductile, onset: 0.1, full: 0.2}%s]",
                                  rule);
    small_body_new(&small, &(struct small_case){.size = {2, 1, 1},
                                                .horizon = 1,
                                                .stabilisation = stabilisation,
                                                .materials = small_two_phases,
                                                .n_phases = 2,
                                                .phase = two_halves,
                                                .breaking = breaking});
    const double share = share_left(&small, 0.2);
    small_body_free(&small);
    free(breaking);
    return share;
}

static void test_bonds_between_phases(void **state)
{
    (void)state;
    static const struct {
        const char *rule;
        double share;
    } rules[] = {{"", 0.2},
                 {", {pair: [A, B], rule: min}", 0.2},
                 {", {pair: [B, A], rule: max}", 0.8},
                 {", {pair: [A, B], rule: mean}", 0.5},
                 {", {pair: [A, B], rule: harmonic}", 0.32}};
    for (size_t k = 0; k < sizeof rules / sizeof *rules; k++) {
        assert_relative(bond_share(small_mix, rules[k].rule), rules[k].share, 1e-14);
        assert_relative(bond_share(small_capped, rules[k].rule), rules[k].share, 1e-14);
    }
    for (int c = 0; c < COMBINATIONS; c++) assert_near(combine((enum combination)c, 0, 0), 0, 0);
}

/* Of an ordinary material each end's force state is scaled by what is left of that end. */
static void test_ordinary_bonds(void **state)
{
    (void)state;
    struct small_body small;
    small_body_new(
        &small, &(struct small_case){
                    .size = {2, 1, 1}, .horizon = 1, .materials = ordinary, .breaking = DUCTILE});
    assert_relative(share_left(&small, 0.3), 0.55, 1e-14);
    small_body_free(&small);
}

static struct damage_rules read_rules(struct small_body *small, const char *materials,
                                      const char *breaking)
{
    const bool two = strstr(materials, "B:") != NULL;
    small_body_new(small,
                   &(struct small_case){.size = {2, 2, 2},
                                        .horizon = 1,
                                        .stabilisation =
                                            strstr(materials, "correspondence") ? small_mix : NULL,
                                        .materials = materials,
                                        .n_phases = two ? 2 : 1,
                                        .phase = two ? two_halves : NULL,
                                        .breaking = breaking});
    const struct damage_view see = {small->model, &small->materials, &small->body, small->bonds,
                                    .series = true};
    return damage_rules_read(deck_get(deck_root(small->deck), "damage"), &see);
}

/* What a band of one spacing lengthens by between onset and the end, e^p being its stretch, is what
 * one of the length would between onset and full. */
static void test_length_scales_the_interval(void **state)
{
    (void)state;
    static const double lengths[] = {12.5e-6, 25e-6, 60e-6};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        struct small_body small;
        char *breaking = memory_print(
            "damage: [{phase: A, law: ductile, onset: 0.3, full: 0.5, length: %.17g m}]",
            lengths[k]);
        struct damage_rules rules = read_rules(&small, small_nickel, breaking);
        const struct node_rule *rule = &rules.node[0];
        assert_near(rule->least, 0.3, 0);
        assert_relative(SMALL_SPACING * (exp(rule->law->limit(rule->own, NULL)) - exp(0.3)),
                        lengths[k] * (exp(0.5) - exp(0.3)), 1e-13);
        damage_rules_free(&rules);
        small_body_free(&small);
        free(breaking);
    }
}

struct wrong {
    const char *materials, *breaking, *text;
};

static void read_wrong(const void *of)
{
    const struct wrong *wrong = of;
    struct small_body small;
    note_set_quiet(1);
    struct damage_rules rules = read_rules(&small, wrong->materials, wrong->breaking);
    damage_rules_free(&rules);
}

#define WRONG(entries) "damage: [" entries "]"
#define OF_A           "{phase: A, law: ductile, onset: 0.2, full: 0.4}"

static void test_errors_are_told(void **state)
{
    (void)state;
    static const char elastic[] = "{A: {model: ordinary, density: 8900, youngs_modulus: 210 GPa, "
                                  "poissons_ratio: 0.31}}";
    static const struct wrong wrongs[] = {
        {small_nickel, WRONG("{phase: A, law: ductile, onset: 0.4, full: 0.4}"),
         "more than 'onset'"},
        {small_nickel, WRONG("{phase: A, law: ductile, full: 0.4}"), "onset"},
        {small_nickel, WRONG("{phase: A, law: ductile, onset: 0.4}"), "full"},
        {small_nickel, WRONG("{phase: A, law: ductile, onset: 0.1, full: 0.4, length: 0}"),
         "0 m is out of range"},
        {small_nickel, WRONG("{phase: A, law: ductile, onset: 0.1, full: 0.4, value: 1}"), "value"},
        {small_nickel, WRONG("{pair: [A, A], law: ductile, value: 0.4}"),
         "belongs to law: critical_stretch or bond_energy, not to law: ductile"},
        {small_nickel, WRONG(OF_A ", {phase: A, law: plastic_strain, value: 1}"), "named twice"},
        {small_elastic, WRONG(OF_A), "does not yield"},
        {elastic, WRONG(OF_A), "does not yield"},
        {small_two_phases, WRONG(OF_A ", {pair: [A, A], rule: min}"), "two different phases"},
        {small_two_phases, WRONG(OF_A ", {pair: [A, B], rule: min}, {pair: [B, A], rule: max}"),
         "named twice"},
        {small_two_phases,
         WRONG("{phase: A, law: plastic_strain, value: 1}, {pair: [A, B], rule: min}"),
         "with the same law"},
    };
    for (size_t k = 0; k < sizeof wrongs / sizeof *wrongs; k++)
        assert_dies(EXIT_USER, wrongs[k].text, read_wrong, &wrongs[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uniform_tension),
        cmocka_unit_test(test_states_that_are_tried_leave_no_trace),
        cmocka_unit_test(test_energy_of_uniform_tension),
        cmocka_unit_test(test_energy_of_springs),
        cmocka_unit_test(test_forces_between_growths),
        cmocka_unit_test(test_bonds_between_phases),
        cmocka_unit_test(test_ordinary_bonds),
        cmocka_unit_test(test_length_scales_the_interval),
        cmocka_unit_test(test_errors_are_told),
    };
    return cmocka_run_group_tests_name("ductile", tests, small_ranks_start, small_ranks_stop);
}
