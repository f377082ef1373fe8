/* The radial return is exact: against closed forms in uniaxial strain, and against an independent
 * solution of the scalar equation for each hardening law.
 *
 * In uniaxial strain F = (lambda, 1, 1), L = ln lambda, the deviator of the logarithmic strain is
 * L (2/3, -1/3, -1/3) and flow has one unknown, so that q = 3 mu |2/3 L - e| with de = +-dp in the
 * direction of q: closed forms to the end of any path, however it is cut into steps. */
#include "check.h"

#include "deck.h"
#include "flow_curve.h"
#include "j2.h"
#include "memory.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TWO_VOCE                                                                                   \
    "{law: two_voce, yield: 182.1 MPa, saturation: 300 MPa, rate: 5, saturation_2: 100 MPa, "      \
    "rate_2: 80}"

static const char *const laws[] = {
    "{law: linear, yield: 182.1 MPa, modulus: 850 MPa}",
    "{law: linear, yield: 150 MPa, modulus: 0}",
    "{law: swift, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.4}",
    "{law: ludwik, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.5}",
    "{law: hollomon, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.4}",
    "{law: voce, yield: 182.1 MPa, saturation: 513 MPa, rate: 5.32}",
    "{law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}",
    TWO_VOCE,
    "{law: tabulated, points: [[0, 180 MPa], [0.05, 300 MPa], [0.2, 500 MPa], [1, 800 MPa]]}",
};
enum { LAWS = sizeof laws / sizeof *laws };

static struct hardening read_law(const char *text)
{
    struct deck *deck = deck_parse(text, strlen(text), "test");
    struct hardening law = hardening_read(deck_root(deck));
    deck_free(deck);
    return law;
}

/* One point of a material. */
struct point {
    struct hardening law;
    struct flow_curves curves;
    struct j2_strip strip; /* point 0 */
    double state[J2_STATE];
};

static void point_new(struct point *point, const char *law, double youngs_modulus,
                      double poissons_ratio)
{
    *point = (struct point){.law = read_law(law), .state = {1, 1, 1}};
    const struct hardening *const laws_of[] = {&point->law};
    point->curves = flow_curves_new(1, laws_of, laws_of);
    point->strip.count = 1;
    point->strip.mu[0] = youngs_modulus / (2 * (1 + poissons_ratio));
    point->strip.bulk[0] = youngs_modulus / (3 * (1 - 2 * poissons_ratio));
}

static void point_free(struct point *point)
{
    flow_curves_free(&point->curves);
    hardening_free(&point->law);
}

static void deform(struct point *point, const double H[9], bool commit)
{
    for (int k = 0; k < TENSOR; k++) point->strip.H[k][0] = H[k];
    j2_update(&point->strip, point->state, 1, point->curves.table,
              (struct j2_mode){.commit = commit, .energy = true});
}

static void stretch(struct point *point, double lambda)
{
    deform(point, (const double[9]){lambda - 1}, true);
}

static double von_mises(const struct point *point, double lambda)
{
    /* tau = P F^T; the pressure drops out */
    return fabs(point->strip.P[0][0] * lambda - point->strip.P[4][0]);
}

/* e = (ln b)/2 is a series with an error below 1e-10 for strains up to 10 %; against plastic strains
 * of 1e-2 and more that is 1e-8 in one large step.  In small steps the elastic strains stay below 3 %
 * (of volume), error 1e-14, against plastic strains of 1e-3. */
static const double one_step = 1e-8, many_steps = 1e-11;

/* Linear hardening, E = 211 GPa, nu = 0: p = (2G ln F - Y)/(3G + H), q = Y + H p. */
static void test_linear_hardening_in_closed_form(void **state)
{
    (void)state;
    static const double lambda[] = {1.025, 1.05, 1.075, 1.1};
    static const double p[] = {0.0147749339, 0.0305901233, 0.0460331558, 0.0611211444};
    static const double q[] = {533874669.6, 612950616.5, 690165779.1, 765605722.2};
    for (int steps = 1; steps <= 200; steps *= 200)
        for (int k = 0; k < 4; k++) {
            struct point point;
            point_new(&point, "{law: linear, yield: 460 MPa, modulus: 5 GPa}", 211e9, 0);
            for (int n = 1; n <= steps; n++) stretch(&point, 1 + (lambda[k] - 1) * n / steps);
            const double G = 211e9 / 2, exact = (2 * G * log(lambda[k]) - 460e6) / (3 * G + 5e9);
            const double tolerance = steps == 1 ? one_step : many_steps;
            assert_relative(exact, p[k], 1e-8); /* the figures have nine digits */
            assert_relative(point.state[6], exact, tolerance);
            assert_relative(von_mises(&point, lambda[k]), q[k], tolerance + 1e-9);
            assert_relative(von_mises(&point, lambda[k]), 460e6 + 5e9 * exact, tolerance);
            point_free(&point);
        }
}

/* Perfect plasticity, E = 200 GPa, nu = 0: p = (2G ln F - Y)/3G, and the axial Cauchy stress. */
static void test_perfect_plasticity_in_closed_form(void **state)
{
    (void)state;
    static const double lambda[] = {1.002, 1.004, 1.006, 1.008};
    static const double p[] = {8.32001775e-4, 2.16134751e-3, 3.48804779e-3, 4.81211310e-3};
    struct point point;
    point_new(&point, "{law: linear, yield: 150 MPa, modulus: 0}", 200e9, 0);
    for (int k = 0; k < 4; k++) {
        stretch(&point, lambda[k]);
        assert_relative(point.state[6], p[k], 1e-8); /* nine digits */
        assert_relative(von_mises(&point, lambda[k]), 150e6, 1e-12);
    }
    /* tau = 2/3 Y + K ln F: of a Kirchhoff stress, so over J = F for the Cauchy stress. */
    double cauchy[SYMMETRIC][LANES];
    j2_cauchy(&point.strip, cauchy);
    assert_relative(cauchy[0][0], (100e6 + 200e9 / 3 * log(1.008)) / 1.008, 1e-12);
    point_free(&point);
}

/* The same bar with a yield stress of its own at each point: reduced by 0.2 exp(-r^2/0.751^2). */
static void test_each_point_by_its_own_curve(void **state)
{
    enum { POINTS = 16 };
    (void)state;
    struct hardening law[POINTS];
    const struct hardening *pointer[POINTS];
    struct j2_strip strip = {.count = POINTS};
    double states[J2_STATE * POINTS] = {0}, yield[POINTS];
    for (int i = 0; i < POINTS; i++) {
        yield[i] = 460e6 * (1 - 0.2 * exp(-pow(0.125 * i / 0.751, 2)));
        char *text = memory_print("{law: linear, yield: %.17g, modulus: 5 GPa}", yield[i]);
        law[i] = read_law(text);
        free(text);
        pointer[i] = &law[i];
        strip.mu[i] = 211e9 / 2;
        strip.bulk[i] = 211e9 / 3;
        strip.curve[i] = i;
        for (int k = 0; k < 3; k++) states[k * POINTS + i] = 1;
    }
    struct flow_curves curves = flow_curves_new(POINTS, pointer, pointer);
    for (int n = 1; n <= 50; n++) {
        for (int i = 0; i < POINTS; i++) strip.H[4][i] = 0.002 * n;
        j2_update(&strip, states, POINTS, curves.table, (struct j2_mode){.commit = true});
    }
    for (int i = 0; i < POINTS; i++) {
        double exact = (211e9 * log(1.1) - yield[i]) / (1.5 * 211e9 + 5e9);
        assert_relative(states[6 * POINTS + i], exact, many_steps);
        hardening_free(&law[i]);
    }
    flow_curves_free(&curves);
}

/* Flow stress of the law itself, not of its table. */
static long double law_stress(const struct hardening *law, long double p)
{
    return (long double)hardening_stress(law, (double)p);
}

/* The table's error, as flow_curve.h states it: 1e-9 for smooth laws; where the slope has a kink or is
 * infinite at first yield, what a cell's width does to it. */
static double table_error(const struct hardening *law)
{
    const char *name = hardening_name(law);
    bool kinked = strcmp(name, "hollomon") == 0 || strcmp(name, "tabulated") == 0;
    return kinked ? 1e-4 : 1e-9;
}

/* Axial plastic strain and p after the path of 2/3 ln lambda, by bisection of
 * 3 mu (|2/3 L - e| - g) = sigma_y(p + g). */
struct uniaxial {
    long double e, p;
};

static void follow(struct uniaxial *u, const struct hardening *law, long double modulus,
                   long double strain)
{
    long double trial = modulus * fabsl(strain - u->e), low = 0, high = trial / modulus;
    if (trial <= law_stress(law, u->p)) return;
    for (int k = 0; k < 120; k++) {
        long double g = (low + high) / 2;
        *(trial - modulus * g > law_stress(law, u->p + g) ? &low : &high) = g;
    }
    u->e += strain > u->e ? low : -low;
    u->p += low;
}

static void check_path(const char *text, const double *lambda, int corners, int steps)
{
    struct point point;
    struct uniaxial exact = {0, 0};
    point_new(&point, text, 210e9, 0.31);
    const double modulus = 3 * point.strip.mu[0];
    double before = 1;
    for (int c = 0; c < corners; c++) {
        for (int n = 1; n <= steps; n++) stretch(&point, before + (lambda[c] - before) * n / steps);
        before = lambda[c];
        const long double strain = 2.0L / 3 * logl((long double)before);
        follow(&exact, &point.law, modulus, strain);
        const double q = (double)(modulus * fabsl(strain - exact.e));
        const double tolerance = table_error(&point.law) + (steps == 1 ? one_step : many_steps);
        assert_relative(von_mises(&point, before), q, tolerance);
        /* p follows with the error of q over 3 mu, 1e-3 of the strain, and of the series */
        assert_relative(point.state[6], (double)exact.p, tolerance);
    }
    point_free(&point);
}

static void test_every_law_in_one_step_and_many(void **state)
{
    (void)state;
    static const double reached[] = {1.002, 1.006, 1.02, 1.1};
    for (int law = 0; law < LAWS; law++)
        for (int k = 0; k < 4; k++) {
            check_path(laws[law], &reached[k], 1, 1);
            check_path(laws[law], &reached[k], 1, 20);
        }
}

static void test_every_law_in_cycles(void **state)
{
    (void)state;
    static const double corners[] = {1.02, 0.99, 1.03, 1.03, 0.95, 1.05};
    for (int law = 0; law < LAWS; law++) {
        check_path(laws[law], corners, 6, 1);
        check_path(laws[law], corners, 6, 25);
    }
}

/* c = a b */
static void multiply(const double a[9], const double b[9], double c[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            c[3 * i + j] = 0;
            for (int k = 0; k < 3; k++) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
        }
}

static void rotation(double angle, double R[9])
{
    const double n[3] = {2.0 / 7, -3.0 / 7, 6.0 / 7}, c = cos(angle), s = sin(angle);
    const double cross[9] = {0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
    for (int i = 0; i < 9; i++)
        R[i] = (i % 4 == 0) * c + (1 - c) * n[i / 3] * n[i % 3] + s * cross[i];
}

/* A path of general deformations; with turned != 0 each of them is followed by another rotation. */
static void general_path(struct point *point, double turned, double P[9])
{
    for (int n = 1; n <= 20; n++) {
        const double t = n / 20.0;
        const double F[9] = {1 + 0.05 * t, 0.06 * t * t, 0.01 * t,
                             -0.03 * t,    1 - 0.03 * t, 0.02 * sin(5 * t),
                             0.04 * t,     -0.01 * t,    1 - 0.02 * t * t};
        double R[9], RF[9], back[9], unturned[9];
        rotation(turned * n, R);
        multiply(R, F, RF);
        for (int k = 0; k < 9; k++) RF[k] -= k % 4 == 0;
        deform(point, RF, true);
        for (int k = 0; k < 9; k++) {
            back[k] = R[3 * (k % 3) + k / 3];
            unturned[k] = point->strip.P[k][0];
        }
        multiply(back, unturned, P);
    }
}

/* F -> R F gives P -> R P and the same state, with another rotation in each step. */
static void test_turns_with_the_frame(void **state)
{
    (void)state;
    struct point still, turned;
    double P[9], Q[9];
    point_new(&still, laws[5], 210e9, 0.31);
    point_new(&turned, laws[5], 210e9, 0.31);
    general_path(&still, 0, P);
    general_path(&turned, 0.7, Q);
    assert_true(still.state[6] > 0.05);
    /* E times the rounding of 20 steps' strains */
    for (int k = 0; k < 9; k++) assert_near(Q[k], P[k], 1e-14 * 210e9);
    for (int k = 0; k < J2_STATE; k++) assert_near(turned.state[k], still.state[k], 1e-13);
    point_free(&still);
    point_free(&turned);
}

/* Plastic flow keeps the volume: det Cp = 1. */
static void test_flow_keeps_the_volume(void **state)
{
    (void)state;
    struct point point;
    double P[9];
    point_new(&point, laws[5], 210e9, 0.31);
    general_path(&point, 0.3, P);
    const double *C = point.state;
    double determinant = C[0] * (C[1] * C[2] - C[4] * C[4]) - C[3] * (C[3] * C[2] - C[4] * C[5]) +
                         C[5] * (C[3] * C[4] - C[1] * C[5]);
    assert_near(determinant, 1, 1e-10); /* 20 steps of the series for strains of 1 %: 1e-12 each */
    point_free(&point);
}

/* P = d psi/dF by differences of the stored energy, elastic at 5 % of strain. */
static void test_stress_is_the_gradient_of_the_energy(void **state)
{
    (void)state;
    struct point point;
    const double H[9] = {0.05, 0.02, -0.01, 0.03, -0.02, 0.01, 0.02, -0.03, 0.01}, h = 1e-5;
    point_new(&point, "{law: linear, yield: 1000 GPa, modulus: 0}", 210e9, 0.31);
    deform(&point, H, false);
    double P[9];
    for (int k = 0; k < 9; k++) P[k] = point.strip.P[k][0];
    for (int k = 0; k < 9; k++) {
        double side[2];
        for (int s = 0; s < 2; s++) {
            double moved[9];
            memcpy(moved, H, sizeof moved);
            moved[k] += s ? -h : h;
            deform(&point, moved, false);
            side[s] = point.strip.stored[0];
        }
        /* third derivative ~ 10 E times h^2; rounding 1e-16 of the energy over h */
        assert_near((side[0] - side[1]) / (2 * h), P[k], 1e-8 * 210e9);
    }
    point_free(&point);
}

/* A point that does not flow keeps its state to the last bit; nothing is written without commit. */
static void test_state_is_kept(void **state)
{
    (void)state;
    struct point point;
    double before[J2_STATE];
    point_new(&point, laws[5], 210e9, 0.31);
    stretch(&point, 1.01);
    memcpy(before, point.state, sizeof before);
    deform(&point, (const double[9]){0.02}, false);
    assert_memory_equal(before, point.state, sizeof before);
    stretch(&point, 1.0095); /* unloads */
    assert_memory_equal(before, point.state, sizeof before);
    point_free(&point);
}

/* stored + plastic energy = work of the stress along the path, in steps of 1e-4 by the trapezoidal
 * rule: error (1e-4)^2 of the curvature, 1e-6 at first yield. */
static void test_work_is_stored_or_plastic(void **state)
{
    (void)state;
    struct point point;
    point_new(&point, laws[5], 210e9, 0.31);
    double work = 0, before = 0;
    for (int n = 1; n <= 500; n++) {
        stretch(&point, 1 + 1e-4 * n);
        work += 0.5 * (before + point.strip.P[0][0]) * 1e-4;
        before = point.strip.P[0][0];
    }
    assert_relative(point.strip.stored[0] + point.strip.plastic[0], work, 1e-5);
    assert_true(point.strip.plastic[0] > 0.01 * point.strip.stored[0]);
    point_free(&point);
}

/* The answer does not depend on the other points of the strip, nor on its place: the same bits. */
static void test_points_are_independent(void **state)
{
    (void)state;
    struct point point;
    point_new(&point, laws[6], 210e9, 0.31);
    struct j2_strip all = {.count = LANES};
    double *states = memory_new(J2_STATE * LANES, sizeof *states);
    struct random_stream *stream = random_new(1, "points");
    for (int i = 0; i < LANES; i++) {
        all.mu[i] = point.strip.mu[0];
        all.bulk[i] = point.strip.bulk[0];
        for (int k = 0; k < TENSOR; k++) all.H[k][i] = 0.04 * random_uniform(stream) - 0.02;
        for (int k = 0; k < 3; k++) states[k * LANES + i] = 1;
    }
    random_free(stream);
    struct j2_strip copy = all;
    j2_update(&all, states, LANES, point.curves.table, (struct j2_mode){.commit = true});
    for (int i = 0; i < LANES; i++) {
        double H[9];
        for (int k = 0; k < TENSOR; k++) H[k] = copy.H[k][i];
        memcpy(point.state, (const double[J2_STATE]){1, 1, 1}, sizeof point.state);
        deform(&point, H, true);
        for (int k = 0; k < TENSOR; k++) assert_true(point.strip.P[k][0] == all.P[k][i]);
        for (int k = 0; k < J2_STATE; k++) assert_true(point.state[k] == states[k * LANES + i]);
    }
    free(states);
    point_free(&point);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_linear_hardening_in_closed_form),
        cmocka_unit_test(test_perfect_plasticity_in_closed_form),
        cmocka_unit_test(test_each_point_by_its_own_curve),
        cmocka_unit_test(test_every_law_in_one_step_and_many),
        cmocka_unit_test(test_every_law_in_cycles),
        cmocka_unit_test(test_turns_with_the_frame),
        cmocka_unit_test(test_flow_keeps_the_volume),
        cmocka_unit_test(test_stress_is_the_gradient_of_the_energy),
        cmocka_unit_test(test_state_is_kept),
        cmocka_unit_test(test_work_is_stored_or_plastic),
        cmocka_unit_test(test_points_are_independent),
    };
    return cmocka_run_group_tests_name("j2", tests, NULL, NULL);
}
