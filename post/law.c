#include "law.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>

/* Hollomon (1945): K p^n. */
static void hollomon_basis(const double shape[], double p, double value[])
{
    value[0] = pow(p, shape[0]);
}
static void hollomon_slope(const double shape[], double p, double value[])
{
    value[0] = shape[0] * pow(p, shape[0] - 1);
}

/* Ludwik (1909): Y + K p^n. */
static void ludwik_basis(const double shape[], double p, double value[])
{
    value[0] = 1;
    value[1] = pow(p, shape[0]);
}
static void ludwik_slope(const double shape[], double p, double value[])
{
    value[0] = 0;
    value[1] = shape[0] * pow(p, shape[0] - 1);
}

/* Swift (1952): K (e0 + p)^n. */
static void swift_basis(const double shape[], double p, double value[])
{
    value[0] = pow(shape[0] + p, shape[1]);
}
static void swift_slope(const double shape[], double p, double value[])
{
    value[0] = shape[1] * pow(shape[0] + p, shape[1] - 1);
}

/* Voce (1948): Y + Q (1 - exp(-b p)). */
static void voce_basis(const double shape[], double p, double value[])
{
    value[0] = 1;
    value[1] = -expm1(-shape[0] * p);
}
static void voce_slope(const double shape[], double p, double value[])
{
    value[0] = 0;
    value[1] = shape[0] * exp(-shape[0] * p);
}

/* Y + Q1 (1 - exp(-b1 p)) + Q2 (1 - exp(-b2 p)). */
static void two_voce_basis(const double shape[], double p, double value[])
{
    voce_basis(shape, p, value);
    value[2] = -expm1(-shape[1] * p);
}
static void two_voce_slope(const double shape[], double p, double value[])
{
    voce_slope(shape, p, value);
    value[2] = shape[1] * exp(-shape[1] * p);
}

/* Y + H p. */
static void straight_basis(const double shape[], double p, double value[])
{
    (void)shape;
    value[0] = 1;
    value[1] = p;
}
static void straight_slope(const double shape[], double p, double value[])
{
    (void)shape, (void)p;
    value[0] = 0;
    value[1] = 1;
}

static const struct law laws[LAW_COUNT] = {
    [LAW_HOLLOMON] = {"hollomon",
                      "K p^n",
                      1,
                      1,
                      {{"strength", "K", 0, 0}, {"exponent", "n", 0.01, 2}},
                      hollomon_basis,
                      hollomon_slope},
    [LAW_LUDWIK] = {"ludwik",
                    "Y + K p^n",
                    2,
                    1,
                    {{"yield", "Y", 0, 0}, {"strength", "K", 0, 0}, {"exponent", "n", 0.01, 2}},
                    ludwik_basis,
                    ludwik_slope},
    [LAW_SWIFT] = {"swift",
                   "K (e0 + p)^n",
                   1,
                   2,
                   {{"strength", "K", 0, 0}, {"offset", "e0", 1e-6, 1}, {"exponent", "n", 0.01, 2}},
                   swift_basis,
                   swift_slope},
    [LAW_VOCE] = {"voce",
                  "Y + Q (1 - exp(-b p))",
                  2,
                  1,
                  {{"yield", "Y", 0, 0}, {"saturation", "Q", 0, 0}, {"rate", "b", 0.1, 1e4}},
                  voce_basis,
                  voce_slope},
    [LAW_TWO_VOCE] = {"two_voce",
                      "Y + Q1 (1 - exp(-b1 p)) + Q2 (1 - exp(-b2 p))",
                      3,
                      2,
                      {{"yield", "Y", 0, 0},
                       {"saturation", "Q1", 0, 0},
                       {"saturation_2", "Q2", 0, 0},
                       {"rate", "b1", 0.1, 1e4},
                       {"rate_2", "b2", 0.1, 1e4}},
                      two_voce_basis,
                      two_voce_slope},
    [LAW_STRAIGHT] = {"linear",
                      "Y + H p",
                      2,
                      0,
                      {{"yield", "Y", 0, 0}, {"modulus", "H", 0, 0}},
                      straight_basis,
                      straight_slope},
};

const struct law *law_of(enum law_index index)
{
    return &laws[index];
}

static double combine(const struct law_fit *fit, const double value[])
{
    double sum = 0;
    for (int k = 0; k < fit->law->n_linear; k++) sum += fit->parameter[k] * value[k];
    return sum;
}

double law_stress(const struct law_fit *fit, double p)
{
    double value[LAW_LINEAR];
    fit->law->basis(fit->parameter + fit->law->n_linear, p, value);
    return combine(fit, value);
}

double law_slope(const struct law_fit *fit, double p)
{
    double value[LAW_LINEAR];
    fit->law->slope(fit->parameter + fit->law->n_linear, p, value);
    return combine(fit, value);
}

static double instability(double p, void *fit)
{
    return law_slope(fit, p) - law_stress(fit, p);
}

double law_uniform_strain(const struct law_fit *fit)
{
    const double first = 1e-12, most = 10; /* power laws have no slope at zero */
    struct law_fit copy = *fit;
    gsl_function f = {instability, &copy};
    double low = first, high = most;
    if (!(instability(low, &copy) > 0) || !(instability(high, &copy) < 0)) return NAN;
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &f, low, high);
    for (int i = 0; i < 200; i++) {
        gsl_root_fsolver_iterate(solver);
        low = gsl_root_fsolver_x_lower(solver);
        high = gsl_root_fsolver_x_upper(solver);
        if (gsl_root_test_interval(low, high, 0, 1e-12) == GSL_SUCCESS) break;
    }
    double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return root;
}
