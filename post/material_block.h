/* material_block.h - a section "materials" of the deck from a measured curve. */
#ifndef HS_MATERIAL_BLOCK_H
#define HS_MATERIAL_BLOCK_H

#include "analysis.h"

#include <stdio.h>

/* The row of first yield on the envelope: the last one whose plastic strain is below 1e-4,
 * behind an upper yield point the first one on the plateau. */
long material_first_row(const struct analysis *analysis);

struct material {
    const char *name;
    double density, youngs_modulus, poissons_ratio; /* kg/m^3, Pa, - */
    bool is_slope;                                  /* the modulus is the slope of the curve */
    struct hardening hardening;
    double root_mean_square; /* Pa, of the law from its points */
    double first, last;      /* plastic strain of the points used */
    long count;              /* of these points */
    char *reason;            /* why this law, in words */
};

/* The law that the deck knows with the least AIC, of those whose parameters are determined and
 * allowed, over the plastic strain from 1e-4 to the maximum force, where its root mean square is
 * below 0.5 % of Rm and there is no yield plateau; else tabulated: the stresses made not to fall
 * (means of those that do, least squares), thinned to as few points as stay within 0.1 % of Rm.
 * law: NULL, or the name of the one to take.  s (1 + e) is the Kirchhoff stress of which the
 * deck speaks, ln(1 + e) less its elastic part the strain.  Dies (exit 2) where there is no
 * modulus or are too few points. */
struct material material_make(const char *name, const struct curve *curve,
                              const struct analysis *analysis, const char *law);
void material_free(struct material *material);

/* "materials:", under comments that say where it comes from, for this model. */
void material_print(FILE *file, const struct material *material, const struct curve *curve,
                    const char *model);

#endif
