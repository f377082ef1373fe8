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

/* Dies where a box of the deck, which has the layers low to high of the whole body along an axis,
 * is not above the plane across it nor its own image: the part's nodes are not all that it asks
 * for. */
void symmetry_check_layers(struct deck_node where, const struct specimen *specimen, int axis,
                           int64_t low, int64_t high);

#endif
