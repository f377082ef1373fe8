/* Loads, prescribed motions and initial values: exact motions, and a closed energy balance. */
#include "check.h"

#include "scene_body.h"

#include <stdio.h>

static const double density = 8900, modulus = 210e9, ratio = 0.31; /* of small_elastic */
static const struct small_case bar = {
    .size = {24, 3, 3}, .horizon = 1, .stabilisation = small_mix, .materials = small_elastic};
/* The same as particles that lie anywhere. */
static const struct small_case heap = {
    .size = {24, 3, 3},
    .horizon = 2,
    .materials = "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}}",
    .scattered = true,
    .jitter = 0.2};
static const double dt = 2e-9; /* half of the critical step */

/* Largest difference of a component from a number over the body. */
static double spread(const struct scene_body *it, const double *field, double expected)
{
    double most = 0;
    for (int64_t site = 0; site < it->small.body.grid.n_sites; site++)
        if (small_body_has(&it->small, site)) most = fmax(most, fabs(field[site] - expected));
    return most;
}

/* A body that falls as a whole moves as one node of the scheme does: v += dt/2 b/rho, u += dt v. */
static void check_fall(const struct small_case *wanted, const char *load,
                       double (*force)(double time), double tolerance)
{
    struct scene_body it;
    double u = 0, v = 0;
    enum { STEPS = 200 };
    scene_body_new(&it, wanted, load, 0, dt);
    for (int n = 0; n < STEPS; n++) {
        scene_body_step(&it);
        v += 0.5 * dt * force(n * dt) / density;
        u += dt * v;
        v += 0.5 * dt * force((n + 1) * dt) / density;
        assert_near(energy_drift(&it.integration.balance), 0, tolerance);
    }
    assert_near(spread(&it, it.small.body.u[1], u), 0, 1e-12 * fabs(u));
    assert_near(spread(&it, it.small.body.v[1], v), 0, 1e-12 * fabs(v));
    scene_body_free(&it);
}

static double constant(double time)
{
    (void)time;
    return 1e13; /* N/m^3: 1e9 m/s^2, as the run lasts 400 ns */
}
static double swinging(double time)
{
    return 1e13 * cos(1e7 * time);
}
/* 24 x 3 x 3 nodes of (25 um)^3 hold 3.375e-12 m^3. */
static double total(double time)
{
    (void)time;
    return 33.75 / 3.375e-12;
}
static double rising(double time)
{
    return value_rise(time / 0.3e-6) * 1e13;
}

/* Steps of the scheme keep the energy of a force, whatever its course, to round-off: some 1e-16 a
 * step, and what the sums cut off: of the energies that a ramp begins with 1e-8. */
static void test_free_fall(void **state)
{
    (void)state;
    check_fall(&bar, "boundary: [{block: A, direction: y, body_force: 1e13}]", constant, 1e-12);
    check_fall(&bar, "boundary: [{block: A, direction: y, force: 33.75 N}]", total, 1e-12);
    check_fall(&bar,
               "boundary: [{block: A, direction: y, body_force: 4e12},"
               " {where: 'x >= 0', direction: y, body_force: 6e12 N/m3}]",
               constant, 1e-12);
    check_fall(&bar, "boundary: [{block: A, direction: y, body_force: '1e13*cos(1e7*t)'}]",
               swinging, 1e-12);
    check_fall(&bar, "boundary: [{block: A, direction: y, body_force: {ramp: 0.3 us, to: 1e13}}]",
               rising, 1e-7);
}

/* A force spread over scattered particles of equal volume, chosen by place, is the same on each. */
static void test_free_fall_of_scattered_particles(void **state)
{
    (void)state;
    check_fall(&heap, "boundary: [{block: A, direction: y, force: 33.75 N}]", total, 1e-12);
    check_fall(&heap, "boundary: [{where: 'x > -1', direction: y, body_force: '1e13*cos(1e7*t)'}]",
               swinging, 1e-12);
}

/* Mean displacement along x of a layer of nodes. */
static double layer(const struct scene_body *it, int x)
{
    double sum = 0;
    int count = 0;
    for (int64_t site = 0; site < it->small.body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&it->small, site)) continue;
        small_body_position(&it->small, site, at);
        if (at[0] != x) continue;
        sum += it->small.body.u[0][site];
        count++;
    }
    return sum / count;
}

/* A bar held along x at its left and pulled at its right comes to rest stretched by F/(E A).  One
 * layer carries either end force, which disturbs the strain there and decays within the width; the
 * middle third is 8 layers off.  Strains of 1e-5 make the law linear within 1e-5; damping leaves
 * exp(-0.5 c t) = 1e-7 of the waves, of which the fundamental needs some 20 periods. */
static void test_bar_under_a_force(void **state)
{
    (void)state;
    struct scene_body it;
    const double area = 9 * SMALL_SPACING * SMALL_SPACING, strain = 1e-5,
                 force = strain * modulus * area;
    char sections[256];
    snprintf(sections, sizeof sections,
             "boundary: [{where: 'x < 1e-6', direction: x, displacement: 0},"
             " {where: 'x > 574e-6', direction: x, force: %.17g}]",
             force);
    scene_body_new(&it, &bar, sections, 4e6, dt);
    while (it.integration.time < 10e-6) scene_body_step(&it);
    assert_relative(it.boundary.sets[0].reaction, -force, 1e-6);
    assert_relative((layer(&it, 16) - layer(&it, 8)) / (8 * SMALL_SPACING), strain, 1e-3);
    assert_near(spread(&it, it.small.body.b[0], 0), force / (9 * pow(SMALL_SPACING, 3)),
                1e-12 * force / (9 * pow(SMALL_SPACING, 3)));
    scene_body_free(&it);
}

/* A load on nodes that are held moves nothing, does no work, and is what holds them feels. */
static void test_load_on_held_nodes(void **state)
{
    (void)state;
    struct scene_body it;
    scene_body_new(
        &it, &bar,
        "boundary: [{where: 'x < 1e-6', direction: x, velocity: 0},"
        " {where: 'x < 1e-6', direction: x, force: {initial: 3, increment: 2, every: 5 steps}}]",
        0, dt);
    for (int n = 1; n <= 12; n++) {
        scene_body_step(&it);
        assert_relative(it.boundary.sets[0].reaction, -3 - 2 * (n / 5), 1e-14);
    }
    assert_true(it.integration.balance.work == 0);
    assert_true(spread(&it, it.small.body.u[0], 0) == 0);
    scene_body_free(&it);
}

/* Loads grow by steps after the step that makes them due. */
static void test_steps(void **state)
{
    (void)state;
    struct scene_body it;
    scene_body_new(&it, &bar,
                   "boundary: [{block: A, direction: z, body_force: {initial: 1e13, increment: "
                   "2e13, every: 7 steps}}]",
                   0, dt);
    assert_true(spread(&it, it.small.body.b[2], 1e13) == 0);
    for (int n = 1; n <= 30; n++) {
        scene_body_step(&it);
        assert_true(spread(&it, it.small.body.b[2], 1e13 + n / 7 * 2e13) == 0);
    }
    assert_near(energy_drift(&it.integration.balance), 0, 1e-12);
    scene_body_free(&it);
}

/* The same motion asked for as a velocity and as a displacement: differences are roundings, 1e-16
 * of the displacement each step, over a few hundred steps, not amplified in an elastic body. */
static void test_displacement_is_velocity(void **state)
{
    (void)state;
    struct scene_body a, b;
    scene_body_new(&a, &bar,
                   "boundary: [{where: 'x < 1e-6', direction: x, velocity: -2 m/s},"
                   " {where: 'x > 574e-6', direction: x, velocity: 3 m/s}]",
                   0, dt);
    scene_body_new(&b, &bar,
                   "boundary: [{where: 'x < 1e-6', direction: x, displacement: '-2*t'},"
                   " {where: 'x > 574e-6', direction: x, displacement: '3*t'}]",
                   0, dt);
    assert_true(boundary_has_grips(&a.boundary) && boundary_has_grips(&b.boundary));
    for (int n = 0; n < 300; n++) {
        scene_body_step(&a);
        scene_body_step(&b);
    }
    const double most = small_body_largest(&a.small, a.small.body.u);
    for (int64_t site = 0; site < a.small.body.grid.n_sites; site++)
        for (int c = 0; c < 3; c++)
            assert_near(a.small.body.u[c][site], b.small.body.u[c][site], 1e-12 * most);
    assert_relative(a.boundary.sets[1].reaction, b.boundary.sets[1].reaction, 1e-10);
    assert_relative(a.integration.balance.work, b.integration.balance.work, 1e-10);
    scene_body_free(&a);
    scene_body_free(&b);
}

/* A prescribed displacement is kept to round-off, in place and time. */
static void test_displacement_is_kept(void **state)
{
    (void)state;
    struct scene_body it;
    scene_body_new(&it, &bar,
                   "boundary: [{where: 'x < 100e-6', direction: y,"
                   " displacement: '1e-7 + 1e-3*x*sin(1e7*t)'}]",
                   0, dt);
    for (int n = 0; n < 100; n++) {
        scene_body_step(&it);
        for (int64_t site = 0; site < it.small.body.grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&it.small, site)) continue;
            small_body_position(&it.small, site, at);
            const double x = at[0] * SMALL_SPACING;
            if (at[0] < 4)
                assert_near(it.small.body.u[1][site],
                            1e-7 + 1e-3 * x * sin(1e7 * it.integration.time), 1e-21);
        }
    }
    scene_body_free(&it);
}

/* A free bar that starts stretched holds the energy of that strain, (lambda + 2 mu)/2 eps^2 V,
 * exact for the linear law and to some eps for this one; and swings with it. */
static void test_initial_displacement(void **state)
{
    (void)state;
    struct scene_body it;
    const double strain = 1e-5, volume = 24 * 9 * pow(SMALL_SPACING, 3),
                 stiffness = modulus * (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio));
    double kinetic = 0;
    scene_body_new(&it, &bar, "initial: [{block: A, direction: x, displacement: '1e-5*x'}]", 0, dt);
    assert_relative(it.integration.balance.initial - it.integration.balance.staggered,
                    0.5 * stiffness * strain * strain * volume, 3 * strain);
    while (it.integration.time < 0.3e-6) { /* a wave's way there and back */
        scene_body_step(&it);
        kinetic = fmax(kinetic, it.integration.balance.kinetic);
    }
    assert_true(kinetic > 0.5 * it.integration.balance.initial);
    scene_body_free(&it);
}

/* Largest imbalance of a run of a fifth of a microsecond over the largest energy; drift: by the
 * program's own measure. */
static double imbalance_of(const char *sections, double step, double *drift)
{
    struct scene_body it;
    double most = 0, energy = 0;
    *drift = 0;
    scene_body_new(&it, &bar, sections, 0, step);
    while (it.integration.time < 0.2e-6) {
        scene_body_step(&it);
        const struct energy_balance *balance = &it.integration.balance;
        most = fmax(most, fabs(energy_total(balance) - balance->initial - balance->work));
        energy = fmax(energy, energy_total(balance));
        *drift = fmax(*drift, fabs(energy_drift(balance)));
    }
    scene_body_free(&it);
    return most / energy;
}

/* Whatever drives the body, the balance closes but for what the steps miss, (omega dt)^2: the drift
 * stays below the 1 % that stop a run, from the first step, and the imbalance falls to a quarter at
 * half the step.  A stretched body that is let go strikes all its modes at once: only the order is
 * checked there.  An error of work of first order would leave half. */
static void test_energy_of_each_kind(void **state)
{
    (void)state;
    static const char *const kinds[] = {
        "boundary: [{where: 'x < 60e-6', direction: x, velocity: '3*sin(2e7*t)'}]",
        "boundary: [{where: 'x < 60e-6', direction: y, displacement: '1e-7*(1 - cos(2e7*t))'}]",
        "boundary: [{where: 'x < 160e-6', direction: x, velocity: '2e4*x*sin(2e7*t)'}]",
        "boundary: [{where: 'x < 160e-6', direction: z, displacement: '1e-3*x*(1 - cos(2e7*t))'}]",
        "boundary: [{where: 'x > 500e-6', direction: x, force: '0.5*sin(2e7*t)'}]",
        "boundary: [{block: A, direction: y, body_force: '1e16*x*sin(2e7*t)'}]",
        "boundary: [{where: 'x > 500e-6', direction: x, force: {ramp: 0.1 us, to: 0.5 N}},"
        " {where: 'x < 60e-6', direction: x, displacement: '-1e-8*sin(2e7*t)'}]",
        "boundary: [{where: 'x < 100e-6', direction: x, velocity: '2e4*x*sin(2e7*t)'},"
        " {where: 'x < 200e-6', direction: x, body_force: '1e17*x*sin(2e7*t)'}]",
        "initial: [{block: A, direction: y, velocity: '10*sin(1e4*x)'}]",
        "initial: [{block: A, direction: x, displacement: '1e-5*x'}]"};
    enum { KINDS = sizeof kinds / sizeof *kinds, LET_GO = KINDS - 1 };
    for (int k = 0; k < KINDS; k++) {
        double drift, less;
        const double coarse = imbalance_of(kinds[k], dt, &drift),
                     fine = imbalance_of(kinds[k], 0.5 * dt, &less);
        assert_true(k == LET_GO || (drift < 0.01 && less < 0.01));
        assert_true(fine < coarse / 3);
    }
}

/* Velocities count in the middle of a step: one that grows evenly is integrated exactly, to
 * rounding of the sums. */
static void test_even_growth_of_a_velocity(void **state)
{
    (void)state;
    struct scene_body it;
    scene_body_new(&it, &bar,
                   "boundary: [{where: 'x < 60e-6', direction: x, velocity: '1e9*t'},"
                   " {where: 'x < 60e-6', direction: y, velocity: '2e13*x*t'}]",
                   0, dt);
    for (int n = 0; n < 60; n++) scene_body_step(&it);
    const double time = 60 * dt;
    for (int64_t site = 0; site < it.small.body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&it.small, site)) continue;
        small_body_position(&it.small, site, at);
        if (at[0] > 2) continue;
        assert_relative(it.small.body.u[0][site], 0.5e9 * time * time, 1e-12);
        assert_relative(it.small.body.u[1][site], 1e13 * at[0] * SMALL_SPACING * time * time,
                        1e-12);
    }
    scene_body_free(&it);
}

/* At the start the body contracts with nu times the rate; what the grips hold does not, and beside
 * them it grows over half of the width, a spacing here. */
static void test_affine_start(void **state)
{
    (void)state;
    struct scene_body it;
    scene_body_new(&it, &bar,
                   "boundary: [{where: 'x < 30e-6', direction: x, velocity: -2 m/s},"
                   " {where: 'x > 540e-6', direction: x, velocity: 3 m/s}]",
                   0, dt);
    boundary_affine_start(&it.boundary, &it.small.body, 0.31, dt);
    const double length = 21 * SMALL_SPACING, rate = 5 / length;
    for (int64_t site = 0; site < it.small.body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&it.small, site)) continue;
        small_body_position(&it.small, site, at);
        const double share = fmin(fmax(fmin(at[0] - 1, 22 - at[0]), 0), 1);
        const double along = fmin(fmax((at[0] - 1) * SMALL_SPACING, 0), length);
        assert_near(it.small.body.v[0][site], -2 + rate * along, 1e-14);
        for (int a = 1; a < 3; a++)
            assert_near(it.small.body.v[a][site],
                        -0.31 * rate * (at[a] - 1) * SMALL_SPACING * share, 1e-14);
    }
    scene_body_free(&it);
}

/* A force on some particles of unequal volume: its density is F over their volume, not over their
 * number, and each of them moves as F/(rho sum V) asks, since none is near another. */
static void test_force_on_unequal_particles(void **state)
{
    (void)state;
    double x[4] = {0, 1e-3, 2e-3, 3e-3}, none[4] = {0}, volume[4] = {1e-14, 2e-14, 3e-14, 6e-14};
    uint8_t phase[4] = {0};
    struct domain points = {
        .n_nodes = 4, .x = x, .y = none, .z = none, .volume = volume, .phase = phase};
    attributes_set_number(&points.attributes, "mean_spacing_m", SMALL_SPACING);
    struct small_case apart = heap;
    apart.points = &points;
    struct scene_body it;
    scene_body_new(&it, &apart, "boundary: [{where: 'x > 1.5e-3', direction: z, force: 0.2 N}]", 0,
                   dt);
    for (int n = 0; n < 10; n++) scene_body_step(&it);
    double fastest = 0;
    for (int64_t site = 0; site < it.small.body.grid.n_sites; site++) {
        double at[3];
        if (!small_body_has(&it.small, site)) continue;
        body_position(&it.small.body, site, at);
        const double expected = at[0] > 1.5e-3 ? 0.2 / (density * 9e-14) * 10 * dt : 0;
        assert_near(it.small.body.v[2][site], expected, 1e-12 * fabs(expected));
        fastest = fmax(fastest, it.small.body.v[2][site]);
    }
    assert_true(fastest > 0);
    scene_body_free(&it);
    attributes_free(&points.attributes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_free_fall),
        cmocka_unit_test(test_free_fall_of_scattered_particles),
        cmocka_unit_test(test_bar_under_a_force),
        cmocka_unit_test(test_load_on_held_nodes),
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_displacement_is_velocity),
        cmocka_unit_test(test_displacement_is_kept),
        cmocka_unit_test(test_initial_displacement),
        cmocka_unit_test(test_energy_of_each_kind),
        cmocka_unit_test(test_even_growth_of_a_velocity),
        cmocka_unit_test(test_affine_start),
        cmocka_unit_test(test_force_on_unequal_particles),
    };
    return cmocka_run_group_tests_name("boundary", tests, small_ranks_start, small_ranks_stop);
}
