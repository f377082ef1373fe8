/* calibrate.h - the test of a material made from a curve, run by hsgen and hssolve, beside that
 * curve. */
#ifndef HS_CALIBRATE_H
#define HS_CALIBRATE_H

#include "material_block.h"

/* A curve, with all that was measured on it, and by which choices. */
struct measured {
    const struct curve *curve;
    const struct analysis *analysis;
    const struct choices *choices;
};

/* Runs, in the directory (made where it is not there), the test of a homogeneous plate of the
 * material to the maximum force, and writes to file the section of material_print with the
 * misfit: root mean square and largest difference of stress over Rm.  Where the specimen broke,
 * bars with damage of law ductile are run, too, and onset is found by bisection on the
 * elongation at fracture; the section "damage" names the spacing it belongs to.  Decks,
 * histories, logs and misfit.csv stay in the directory.  hsgen and hssolve are those beside
 * hspost, else on the path.  Dies (exit 1) where a run fails. */
void calibrate(FILE *file, const char *directory, const struct material *material,
               const struct measured *measured);

#endif
