/* curve.h - one tensile curve: engineering stress against strain, and what was recorded with it.
 *
 * Engineering stress s = F / S0 with F half the difference of the two grip forces, engineering
 * strain e = dL / L0 between the gauge planes.  The force that the left grip exerts on the
 * specimen is negative in tension. */
#ifndef HS_CURVE_H
#define HS_CURVE_H

#include "choices.h"
#include "input.h"

#include <stdio.h>

enum { CURVE_PHASES = 16 };

/* Volume means over one phase in the gauge. */
struct curve_phase {
    char *name;
    double fraction;           /* of the volume; NAN where it is not known */
    const double *stress;      /* [n] Pa, nominal axial; NULL where not recorded, as below */
    const double *true_stress; /* [n] Pa, Cauchy, axial */
    const double *strain;      /* [n] F_xx - 1 */
};

struct curve {
    char *title;
    bool measured;          /* an experimental table: no grip forces */
    bool strain_is_noisier; /* than the stress over the elastic slope */
    long n;
    double *strain, *stress;           /* [n] -, Pa; engineering, in the table */
    double *true_strain, *true_stress; /* [n] -, Pa; up to Rm, toe removed, else NAN */
    double *plastic_strain;            /* [n] true strain - true stress / E */
    double *hardening_rate;            /* [n] Pa, d true stress / d plastic strain */
    double section, gauge_length;      /* m^2, m; NAN where not known */
    double youngs_modulus;             /* Pa, that the simulation was given; NAN where not known */
    int n_phases;
    struct curve_phase phases[CURVE_PHASES];
    struct table table;           /* all columns in the order they are written, SI */
    struct attributes provenance; /* "# key: value" lines */
};

/* An empty curve of n points with the columns every curve file has. */
struct curve curve_new(long n, const char *title);

/* Forces to stresses, extension to strain, which a table gets as columns; dies (exit 2) where a
 * column or a size is missing. */
struct curve curve_make(struct input *input, const struct choices *choices);

/* Some of its rows [n] as a curve of their own, with all columns and facts. */
struct curve curve_rows(const struct curve *curve, long n, const long rows[]);

void curve_free(struct curve *curve);

/* Provenance and columns. */
void curve_write(FILE *file, const struct curve *curve);

/* max |F_right + F_left| up to a row, over max |F|; NAN without forces. */
double curve_force_imbalance(const struct curve *curve, long last);

#endif
