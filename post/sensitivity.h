/* sensitivity.h - what changes of one key at a time do to the properties of a study. */
#ifndef HS_SENSITIVITY_H
#define HS_SENSITIVITY_H

#include "extrapolation.h"

/* CSV: group, what varied, property, symbol, unit, changed, value, change, change_percent,
 * error_of_spacing, standard_deviation, deviation_of_change, curves, left_out.  Means over the
 * scatter, at the finest spacing; of each property the row "none", nothing changed, comes first,
 * which has Roache's error of the spacing where there are several.  A change is of the curves alone
 * whose scatter the unchanged have, too; its deviation is that of their differences. */
void sensitivities_write(FILE *file, const struct extrapolation extrapolations[], int count,
                         const struct group groups[], int n_groups, const struct properties lists[],
                         const struct label labels[], int n_labels, double order);

#endif
