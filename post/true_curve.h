/* true_curve.h - true stress and strain up to the maximum force, and what follows from them. */
#ifndef HS_TRUE_CURVE_H
#define HS_TRUE_CURVE_H

#include "law_fit.h"
#include "strength.h"

/* Fills true_strain = ln(1 + e - toe), true_stress = s (1 + e - toe), plastic_strain and the
 * hardening rate theta = d sigma / d eps_p of the curve, up to row last.  modulus [Pa] is the E of the
 * plastic strain; NAN leaves plastic strain and theta open.  theta is that of a quadratic fitted over a
 * width of window [true strain] and at least five points, from 0.1 % of plastic strain on. */
void true_curve_fill(struct curve *curve, const struct elastic_line *line, double modulus,
                     long last, double window);

/* Blanks what lies behind the maximum force, where the deformation is no longer uniform. */
void true_curve_cut(struct curve *curve, long maximum);

/* The row to which a slope at the maximum needs the curve: the stress is still 0.98 Rm there. */
long true_curve_reach(const struct curve *curve, long maximum);

/* Where d sigma / d eps first falls to sigma (Considere 1885), on a curve filled up to row last; NAN, NAN
 * where it does not. */
struct considere {
    double strain, stress; /* -, Pa; true */
};
struct considere true_curve_considere(const struct curve *curve, double modulus, long last);

/* sigma = K eps_p^n by regression of the logarithms over rows whose engineering plastic strain lies in
 * [low, high] (ISO 10275, ASTM E646 in kind); at least three points. */
struct power_law {
    double exponent, error, strength, strength_error; /* -, -, Pa, Pa; NAN: too few points */
    double r_squared;
    double low, high;
    long count;
};
struct power_law true_curve_power_law(const struct curve *curve, const struct elastic_line *line,
                                      long last, double low, double high);

/* One law fitted to the rows up to last whose true plastic strain lies in range. */
struct law_fit true_curve_fit(const struct curve *curve, const struct hardening_law *law, long last,
                              const double range[2]);

#endif
