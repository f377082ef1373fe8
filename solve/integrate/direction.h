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
/* The same where passes over the numbers find it by the way: each gives a bound of its own part,
 * the bits of its largest magnitude, of which the largest of all nodes counts.  Collective. */
uint32_t direction_bits(int64_t count, const float *d);
double direction_largest_of(const struct unknowns *unknowns, const float *d, uint32_t bits,
                            double *of_nodes);
/* d = x - d, and its largest magnitudes.  Collective. */
double direction_subtract_from(const struct unknowns *unknowns, const float *x, float *d,
                               double *of_nodes);
/* y += a d */
void direction_add(const struct unknowns *unknowns, double a, const float *d, double *y);
/* The fields at owned nodes += a d, which is 0 at held components. */
void direction_add_to_fields(const struct unknowns *unknowns, double a, const float *d,
                             double *const fields[3]);

/* This rank's part of d . y, of which no number is beyond largest, and the norm not beyond norm:
 * nothing yet, and what so many nodes from one on give, and the mean gradient. */
struct exact_sum direction_sum_new(const struct unknowns *unknowns, double largest, double norm);
void direction_add_nodes(const struct unknowns *unknowns, int64_t count, const float *d,
                         const double *y, struct exact_sum *sum);
void direction_add_mean(const struct unknowns *unknowns, const float *d, const double *y,
                        struct exact_sum *sum);
/* d . y.  Collective. */
double direction_product(const struct unknowns *unknowns, const float *d, const double *y);

#endif
