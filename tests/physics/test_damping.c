/* Energy balance of a damped bar between grips; what damping takes, and what it leaves alone. */
#include "check.h"

#include "damping.h"
#include "memory.h"
#include "scene_body.h"
#include "small_body.h"
#include "verlet.h"

enum { LONG = 20, WIDE = 4, GRIP = 2 };
static const double speed = 10, ramp = 0.2e-6; /* m/s, s */

static uint8_t chequered(const int size[3], const int at[3])
{
    (void)size;
    return (uint8_t)((at[0] / 2 + at[1] / 2 + at[2] / 2) % 2);
}

/* The nodes of GRIP layers from the first; inner is the one next to the middle. */
static struct boundary_set grip(const struct small_body *small, int first, int inner,
                                double velocity)
{
    struct boundary_set set = {.sense = 1,
                               .value = {.kind = VALUE_RAMP, .ramp = ramp, .number = velocity},
                               .inner = inner * SMALL_SPACING};
    set.members.sites = memory_new(GRIP * WIDE * WIDE, sizeof *set.members.sites);
    set.members.n_all = GRIP * WIDE * WIDE;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        if (at[0] >= first && at[0] < first + GRIP) set.members.sites[set.members.count++] = site;
    }
    assert_int_equal(set.members.count, set.members.n_all);
    set.zero = exact_sum_new((double)set.members.n_all * 211e9 * SMALL_SPACING * SMALL_SPACING);
    return set;
}

static struct boundary grips_of(const struct small_body *small)
{
    struct boundary boundary = {
        .count = 2, .sets = memory_new(2, sizeof *boundary.sets), .left = 0, .right = 1};
    boundary.sets[0] = grip(small, 0, GRIP - 1, -speed);
    boundary.sets[1] = grip(small, LONG - GRIP, LONG - GRIP, speed);
    boundary_mark(&boundary, &small->body);
    return boundary;
}

struct pull {
    double drift;  /* largest |energy_drift| of a step */
    double damped; /* share of the grips' work that damping has taken */
};

/* Pulls the bar from rest for 1 microsecond, 5 % of strain. */
static struct pull pull(const char *stabilisation, double damping, double dt)
{
    struct small_body small;
    small_body_new(&small, &(struct small_case){{LONG, WIDE, WIDE},
                                                1,
                                                0,
                                                stabilisation,
                                                small_two_phases,
                                                .n_phases = 2,
                                                .phase = chequered});
    struct boundary boundary = grips_of(&small);
    struct integration integration =
        integration_new(true, dt, damping, &small.materials, &small.body, &boundary, small.model);
    struct pull pull = {0, 0};
    while (integration.time < 1e-6) {
        verlet_step(&integration, &small.body, &boundary, small.model, true, false);
        pull.drift = fmax(pull.drift, fabs(energy_drift(&integration.balance)));
    }
    pull.damped = integration.balance.damping / integration.balance.work;
    integration_free(&integration);
    boundary_free(&boundary);
    small_body_free(&small);
    return pull;
}

/* What is left is the error of the work's trapezia, of second order where nodes begin to flow; what
 * damping takes is known exactly, so that the drift does not grow with it. */
static void check_pull(const char *stabilisation, double c_dt)
{
    const double dt = 2e-9;
    const struct pull result = pull(stabilisation, c_dt / dt, dt);
    if (c_dt > 0) assert_true(result.damped > 0.02);
    assert_near(result.drift, 0, 2e-4);
}

static void test_energy_of_a_damped_pull(void **state)
{
    (void)state;
    static const double c_dt[] = {0, 0.03, 0.1};
    for (int k = 0; k < 3; k++) {
        check_pull(small_mix, c_dt[k]);
        check_pull(small_capped, c_dt[k]);
    }
}

static const struct small_case free_bar = {
    .size = {12, 4, 4}, .horizon = 1, .stabilisation = small_mix, .materials = small_elastic};

/* A body that flies as a whole, and turns not, decays as exp(-c t); two halves of a step are the
 * whole of it, to rounding.  Of local damping nothing comes, as no force acts. */
static void test_flight_decays(void **state)
{
    (void)state;
    enum { STEPS = 50 };
    const double c = 1e7, dt = 2e-9;
    struct scene_body it;
    scene_body_new(&it, &free_bar, "initial: [{block: A, direction: y, velocity: 5 m/s}]", c, dt);
    const double start = it.integration.balance.kinetic;
    for (int n = 0; n < STEPS; n++) scene_body_step(&it);
    const double left = exp(-c * STEPS * dt);
    assert_true(left < 0.5);
    for (int64_t site = 0; site < it.small.body.grid.n_sites; site++)
        if (small_body_has(&it.small, site))
            assert_relative(it.small.body.v[1][site], 5 * left, 1e-12);
    assert_relative(it.integration.balance.kinetic, start * left * left, 1e-12);
    assert_relative(it.integration.balance.damping, start * (1 - left * left), 1e-12);
    scene_body_free(&it);
}

/* Uniform stretching between grips, which contracts by half as in plastic flow, is no motion that
 * damping knows. */
static void test_affine_motion_is_left_alone(void **state)
{
    (void)state;
    static const char sections[] =
        "boundary: [{where: 'x < 30e-6', direction: x, velocity: -2 m/s},"
        " {where: 'x > 240e-6', direction: x, velocity: 3 m/s}]";
    struct scene_body it;
    scene_body_new(&it, &free_bar, sections, 1e7, 2e-9);
    struct body *body = &it.small.body;
    const double inner = SMALL_SPACING, length = 9 * SMALL_SPACING, rate = 5 / length;
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&it.small, site)) continue;
        small_body_position(&it.small, site, at);
        const double along = fmin(fmax(at[0] * SMALL_SPACING - inner, 0), length);
        body->v[0][site] = -2 + rate * along;
        for (int a = 1; a < 3; a++) body->v[a][site] = -0.5 * rate * (at[a] - 1.5) * SMALL_SPACING;
    }
    struct exact_sum lost = it.integration.kinetic_zero;
    double energy;
    damping_apply(&it.integration, body, &it.boundary, 0, 0, &lost);
    exact_sum_finish(&lost, 1, &energy);
    const double kinetic = it.integration.balance.kinetic;
    assert_true(kinetic > 0);
    assert_near(energy, 0, 1e-12 * kinetic);
    /* 1e-16 of the velocities, squared */
    assert_near(damping_unsteady_energy(&it.integration, body, &it.boundary), 0, 1e-24 * kinetic);
    scene_body_free(&it);
}

/* The reference of the drift is m (v_right - v_left)^2/24 of a bar that is stretched uniformly
 * about its middle. */
static void test_reference_of_the_drift(void **state)
{
    (void)state;
    static const char sections[] =
        "boundary: [{where: 'x < 30e-6', direction: x, velocity: -2 m/s},"
        " {where: 'x > 240e-6', direction: x, velocity: 3 m/s}]";
    struct scene_body it;
    scene_body_new(&it, &free_bar, sections, 0, 2e-9);
    const double mass = 8900 * 12 * 4 * 4 * pow(SMALL_SPACING, 3);
    assert_relative(it.integration.balance.reference, mass * 25 / 24, 1e-12);
    scene_body_free(&it);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_energy_of_a_damped_pull),
        cmocka_unit_test(test_flight_decays),
        cmocka_unit_test(test_affine_motion_is_left_alone),
        cmocka_unit_test(test_reference_of_the_drift),
    };
    return cmocka_run_group_tests_name("damping", tests, small_ranks_start, small_ranks_stop);
}
