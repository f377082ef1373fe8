/* direction.h - vectors (unknowns.h) in single precision, for ways that need not be exact
 * themselves; what is found with them is: their products with vectors have the same bits on any
 * number of ranks, too. */
#ifndef HS_DIRECTION_H
#define HS_DIRECTION_H

#include "exact_sum.h"
#include "unknowns.h"

float *direction_new(const struct unknowns *unknowns);

/* Largest magnitude, not a number where one is not, and that of nodes alone.  Collective. */
double direction_largest(const struct unknowns *unknowns, const float *d, double *of_nodes);
/* d = x - d */
void direction_subtract_from(const struct unknowns *unknowns, const float *x, float *d);
/* y += a d */
void direction_add(const struct unknowns *unknowns, double a, const float *d, double *y);

/* This rank's part of d . y, of which no number is beyond largest, and the norm not beyond norm. */
struct exact_sum direction_sum(const struct unknowns *unknowns, const float *d, double largest,
                               const double *y, double norm);
/* d . y.  Collective. */
double direction_product(const struct unknowns *unknowns, const float *d, const double *y);

#endif
