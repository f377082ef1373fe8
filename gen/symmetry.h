/* symmetry.h - planes of symmetry through the middle of a specimen: of each the part above is made.
 */
#ifndef HS_SYMMETRY_H
#define HS_SYMMETRY_H

#include "specimen.h"

/* Reads the key `symmetry` of the section domain, a list of axes, into the specimen, and dies where
 * the plane across one is none of it: of a turned body, of a periodic axis, across a sheet.  After
 * specimen_read. */
void symmetry_read(struct deck_node domain, struct specimen *specimen);

/* Whether a point (m, from the middle) lies in the part that is made. */
bool symmetry_keeps(const struct specimen *specimen, const double point[3]);

#endif
