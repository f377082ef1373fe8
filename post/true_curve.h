/* true_curve.h - true stress and strain up to the maximum force, and what follows from them. */
#ifndef HS_TRUE_CURVE_H
#define HS_TRUE_CURVE_H

#include "law_fit.h"
#include "strength.h"

/* Fills true_strain = ln(1 + e - toe), true_stress = s (1 + e - toe), plastic_strain and the
 * hardening rate theta = d sigma / d eps_p of the curve, up to row last.  modulus [Pa] is the E
 * of the plastic strain; NAN leaves plastic strain and theta open.  theta is that of a quadratic
 * fitted over a width of window [true strain] and at least five points, from 0.1 % of plastic
 * strain on, at rows a hundredth of the window apart at least, and linear between. */
void true_curve_fill(struct curve *curve, const struct elastic_line *line, double modulus,
                     long last, double window);

/* Blanks what lies behind the maximum force, where the deformation is no longer uniform. */
void true_curve_cut(struct curve *curve, long maximum);

/* The row to which a slope at the maximum needs the curve: the stress is still 0.98 Rm there. */
long true_curve_reach(const struct curve *curve, long maximum);

/* Width [true strain] over which the slope at the last row is known to 2 % of the stress there:
 * window, or wider, by steps of a half, where noise [Pa] asks for it, up to a fifth of the
 * strain there. */
double true_curve_window(const struct curve *curve, long last, double window, double noise);

/* Where slopes are looked at, on a curve filled up to row last. */
struct slopes {
    double modulus;   /* Pa */
    long first, last; /* rows; first: 0, or the end of a yield plateau */
    double noise;     /* Pa */
    double window;    /* true strain of each slope */
};

/* Where d sigma / d eps falls to sigma (Considere 1885), of several such places that with most
 * of the strain above on its left and below on its right; NAN where there is none.  error: what
 * the noise does to the strain, from the error of a slope over the window. */
struct considere {
    double strain, stress, error; /* -, Pa, -; true */
};
struct considere true_curve_considere(const struct curve *curve, const struct slopes *slopes);

/* sigma = K eps_p^n by regression of the logarithms over rows whose engineering plastic strain
 * lies in [low, high] (ISO 10275, ASTM E646 in kind); at least three points.  modulus [Pa]: of
 * the true plastic strain, INFINITY for the total one. */
struct power_law {
    double exponent, error, strength, strength_error; /* -, -, Pa, Pa; NAN: too few points */
    double r_squared;
    double low, high;
    long count;
};
struct power_law true_curve_power_law(const struct curve *curve, const struct elastic_line *line,
                                      double modulus, long last, double low, double high);

/* r = -m/(1 + m), m the slope of the true plastic strain across the specimen on that along it
 * (ISO 10113), over rows whose engineering plastic strain lies in [low, high]; the elastic part
 * across is that of the rows of the line.  ratio NAN where the curve has no column
 * transverse_strain, or too few points. */
struct strain_ratio {
    double ratio, error;
    long count;
};
struct strain_ratio true_curve_ratio(const struct curve *curve, const struct elastic_line *line,
                                     double modulus, long last, double low, double high);

/* One law fitted to the rows up to last whose true plastic strain lies in range. */
struct law_fit true_curve_fit(const struct curve *curve, const struct hardening_law *law, long last,
                              const double range[2]);

#endif
