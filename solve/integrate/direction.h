/* direction.h - vectors (unknowns.h) in single precision, for ways that need not be exact
 * themselves; what is found with them is: their products with vectors have the same bits on any
 * number of ranks, too. */
#ifndef HS_DIRECTION_H
#define HS_DIRECTION_H

#include "unknowns.h"

float *direction_new(const struct unknowns *unknowns);

/* d = sum of a[k] x[k], k < count, and its largest magnitude; not a number where one is not.
 * Collective. */
double direction_combine(const struct unknowns *unknowns, int count, const double a[],
                         float *const x[], float *d);
/* d *= a */
void direction_scale(const struct unknowns *unknowns, double a, float *d);
/* y += a d */
void direction_add(const struct unknowns *unknowns, double a, const float *d, double *y);

/* products[k] = d[k] . y, whose norms are not beyond norms[k] and norm.  Collective. */
void direction_products(const struct unknowns *unknowns, int count, float *const d[],
                        const double norms[], const double *y, double norm, double products[]);
/* d . y.  Collective. */
double direction_product(const struct unknowns *unknowns, float *d, const double *y);

#endif
