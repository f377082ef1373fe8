/* strength.h - slope, proof strengths and the marked points of an engineering curve.
 *
 * Definitions after ISO 6892-1 and ASTM E8/E111 as textbooks give them (Dieter, Mechanical
 * Metallurgy, 1988, chapter 8); where a standard leaves a choice, docs/tensile.md says what is
 * done here. */
#ifndef HS_STRENGTH_H
#define HS_STRENGTH_H

#include "curve.h"

/* The straight part s = slope (e - toe). */
struct elastic_line {
    double slope, error; /* Pa; standard error of the slope, NAN where there is none */
    double toe;          /* strain at zero stress */
    double r_squared;
    long first, last, count; /* rows of the fit from 0; -1, -1, 0 where nothing was fitted */
    const char *flag;        /* NULL, or what is wrong with it */
};

/* Least squares of s on e, or of e on s where the strain is the noisier, over the rows given;
 * else the line that a curve file of hspost carries, where no range is given; else over the part
 * between two shares of Rp0.2, found by iteration.  Fewer than three points there: the modulus
 * that is chosen or that the history knows, without a fit; without one, a fit from the first
 * point on as far as the points lie on a line within 1 %.  Where a soft phase yields below or
 * within that part, what lies before (docs/tensile.md).  Where the part between the shares is bent,
 * as a toe is, the steepest straight part of the rise.  slope = NAN where none of these will do. */
struct elastic_line strength_line(const struct curve *curve, const struct choices *choices);

/* R2 of a slope below which it is none. */
extern const double straight_limit;

/* Stress [Pa] where the curve first meets s = slope (e - toe - offset), linear between the points;
 * NAN where it does not, or only while the specimen breaks. */
double strength_proof(const struct curve *curve, const struct elastic_line *line, double offset);

/* Stress [Pa] at a total extension from the toe on; NAN as above. */
double strength_total(const struct curve *curve, const struct elastic_line *line, double extension);

/* The plateau: what lies within this share of Rm below it, so flat that the noise of a digitised or
 * computed curve decides where its maximum is. */
extern const double strength_plateau_share;

/* Maximum force from row first on, of a specimen that broke behind the last row, or did not. strain
 * is that of the middle of the plateau of smooth, the stress without most of its noise, which is
 * also what lies within three standard deviations of the noise that is left below the highest. */
struct strength_maximum {
    long row;
    double stress, strain, plateau; /* Pa, -, - */
    bool reached;                   /* false: the maximum is the last point, not of a broken one */
};
struct strength_maximum strength_maximum(const struct curve *curve, const double smooth[],
                                         double noise, long first, bool broken);

/* Integral of s de [J/m^3] by trapezia from the toe to a row. */
double strength_energy(const struct curve *curve, const struct elastic_line *line, long last);

/* The plastic strain of a machine's curve put right: e becomes (e - toe - s / slope) + s / modulus.
 * Dies (exit 2) where the slope is not known. */
void strength_correct(struct curve *curve, const struct elastic_line *line, double modulus);

#endif
