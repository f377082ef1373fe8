/* law.h - hardening laws: true stress against true plastic strain, and their fit to a curve.
 *
 * A law is linear in its first parameters: sigma = sum_k a_k f_k(p; shape).  To add one: a row of the
 * table in law.c and its two functions. */
#ifndef HS_LAW_H
#define HS_LAW_H

#include <stdbool.h>

enum { LAW_LINEAR = 3, LAW_SHAPES = 2, LAW_PARAMETERS = LAW_LINEAR + LAW_SHAPES };

struct law_parameter {
    const char *name, *symbol;
    double low, high; /* of a shape: where the first search looks */
};

struct law {
    const char *name, *formula;
    int n_linear, n_shapes;
    struct law_parameter parameters[LAW_PARAMETERS]; /* linear ones first, in Pa */
    /* f_k and df_k/dp at plastic strain p, into [n_linear] */
    void (*basis)(const double shape[], double p, double value[]);
    void (*slope)(const double shape[], double p, double value[]);
};

enum law_index {
    LAW_HOLLOMON,
    LAW_LUDWIK,
    LAW_SWIFT,
    LAW_VOCE,
    LAW_TWO_VOCE,
    LAW_STRAIGHT,
    LAW_COUNT
};
const struct law *law_of(enum law_index index);

struct law_fit {
    const struct law *law;
    bool done; /* false: too few points */
    bool converged;
    double parameter[LAW_PARAMETERS]; /* linear ones in Pa, then shapes */
    double error[LAW_PARAMETERS];     /* standard errors; NAN where there are none */
    double root_mean_square, largest; /* Pa, residuals */
    double akaike;                    /* n ln(sum of squares / n) + 2 (parameters + 1), in MPa */
    long count;
    double first, last; /* plastic strain, range of the points used */
};

/* Least squares of the law to n points (p, stress [Pa]): a search over the shapes on a grid, the rest
 * linear, polished by Levenberg-Marquardt in all parameters (GSL). */
struct law_fit law_fit(const struct law *law, const double p[], const double stress[], long n);

/* Stress [Pa] and slope [Pa] of a fitted law. */
double law_stress(const struct law_fit *fit, double p);
double law_slope(const struct law_fit *fit, double p);

/* Plastic strain where the slope falls to the stress (Considere 1885): Hollomon n; Swift n - e0;
 * linear 1 - Y/H; Voce ln(Q (1 + b) / (Y + Q)) / b.  NAN where it does not within p <= 10. */
double law_uniform_strain(const struct law_fit *fit);

#endif
