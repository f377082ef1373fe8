/* law_fit.h - a hardening law (lib/hardening.h) fitted to a curve of true stress against true
 * plastic strain. */
#ifndef HS_LAW_FIT_H
#define HS_LAW_FIT_H

#include "hardening.h"

struct law_fit {
    struct hardening hardening; /* the law and its parameters; NAN: too few points */
    bool done;                  /* false: too few points */
    bool converged;
    double error[HARDENING_PARAMETERS]; /* standard errors; NAN where there are none */
    double root_mean_square, largest;   /* Pa, residuals */
    double akaike;                      /* n ln(sum of squares / n) + 2 (parameters + 1), in MPa */
    long count;
    double first, last; /* plastic strain, range of the points used */
};

/* Least squares of the law to n points (p, stress [Pa]): a search over the shapes on a grid, the
 * rest linear, polished by Levenberg-Marquardt in all parameters (GSL). */
struct law_fit law_fit(const struct hardening_law *law, const double p[], const double stress[],
                       long n);

/* NULL, or why its numbers are not to be trusted: too_few_points, not_converged, ill_determined
 * (a parameter below its error, or a shape out of the range where such laws are found). */
const char *law_fit_flag(const struct law_fit *fit);

/* Plastic strain where the slope falls to the stress (Considere 1885): Hollomon n; Swift n - e0;
 * linear 1 - Y/H; Voce ln(Q (1 + b) / (Y + Q)) / b.  NAN where it does not within p <= 10. */
double law_uniform_strain(const struct hardening *law);

#endif
