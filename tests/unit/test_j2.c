/* The radial return is exact: against closed forms in uniaxial strain, and against an independent
 * solution of the scalar equation for each hardening law.
 *
 * In uniaxial strain F = (lambda, 1, 1), L = ln lambda, the deviator of the logarithmic strain is
 * L (2/3, -1/3, -1/3) and flow has one unknown, so that q = 3 mu |2/3 L - e| with de = +-dp in the
 * direction of q: closed forms to the end of any path, however it is cut into steps. */
#include "one_point.h"

#include "memory.h"

#include <stdlib.h>

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

static double von_mises(const struct point *point, double lambda)
{
    /* tau = P F^T; the pressure drops out */
    return fabs(point->strip.P[0][0] * lambda - point->strip.P[4][0]);
}

/* e = (ln b)/2 is a series with an error below 1e-10 for strains up to 10 %; against plastic
 * strains of 1e-2 and more that is 1e-8 in one large step.  In small steps the elastic strains stay
 * below 3 % (of volume), error 1e-14, against plastic strains of 1e-3. */
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
    assert_relative(point.strip.P[0][0], /* P F^T/J with J = F */
                    (100e6 + 200e9 / 3 * log(1.008)) / 1.008, 1e-12);
    point_free(&point);
}

/* The same bar with a yield stress of its own at each point: reduced by 0.2 exp(-r^2/0.751^2). */
static void test_each_point_by_its_own_curve(void **state)
{
    enum { POINTS = 16 };
    (void)state;
    struct hardening law[POINTS];
    const struct hardening *pointer[POINTS];
    struct points strip = {.count = POINTS};
    double states[J2_STATE * POINTS] = {0}, yield[POINTS];
    for (int i = 0; i < POINTS; i++) {
        yield[i] = 460e6 * (1 - 0.2 * exp(-pow(0.125 * i / 0.751, 2)));
        char *text = memory_print("{law: linear, yield: %.17g, modulus: 5 GPa}", yield[i]);
        law[i] = read_law(text);
        free(text);
        pointer[i] = &law[i];
        strip.mu[i] = 211e9 / 2;
        strip.bulk[i] = 211e9 / 3;
        strip.pair[i] = i;
    }
    double *curves = flow_curves_new(POINTS, pointer, pointer);
    law_start(&law_j2, curves, &strip, states, POINTS);
    for (int n = 1; n <= 50; n++) {
        for (int i = 0; i < POINTS; i++) strip.H[4][i] = 0.002 * n;
        law_j2.update(curves, &strip, states, POINTS, (struct step){.commit = true});
    }
    for (int i = 0; i < POINTS; i++) {
        double exact = (211e9 * log(1.1) - yield[i]) / (1.5 * 211e9 + 5e9);
        assert_relative(states[6 * POINTS + i], exact, many_steps);
        hardening_free(&law[i]);
    }
    free(curves);
}

/* Flow stress of the law itself, not of its table. */
static long double law_stress(const struct hardening *law, long double p)
{
    return (long double)hardening_stress(law, (double)p);
}

/* The table's error, as flow_curve.h states it: 1e-9 for smooth laws; where the slope has a kink or
 * is infinite at first yield, what a cell's width does to it. */
static double table_error(const struct hardening *law)
{
    const char *name = law->law->variant.name;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_linear_hardening_in_closed_form),
        cmocka_unit_test(test_perfect_plasticity_in_closed_form),
        cmocka_unit_test(test_each_point_by_its_own_curve),
        cmocka_unit_test(test_every_law_in_one_step_and_many),
        cmocka_unit_test(test_every_law_in_cycles),
    };
    return cmocka_run_group_tests_name("j2, radial return", tests, NULL, NULL);
}
