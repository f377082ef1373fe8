/* narrow.h - directions (direction.h) in sixteen bits, of which many are kept: multiples of a unit,
 * 2^-15 of the largest of their nodes' numbers.
 *
 * The products of such with a vector, which is cut to 2^-18 of its norm, are sums of integers: they
 * have no rounding, whatever their order.  Of a component of B nodes no sum of magnitudes is beyond
 * B^1/2 2^15 times the vector's norm (Cauchy, Schwarz), so that 32 bits hold it. */
#ifndef HS_NARROW_H
#define HS_NARROW_H

#include "exact_sum.h"
#include "unknowns.h"

enum { NARROW_MOST = 16 }; /* directions at once */

struct narrow {
    double unit;
    int16_t *numbers;       /* [3 n_nodes] */
    float mean[COMPONENTS]; /* those of the mean gradient, on rank 0 */
};

struct narrow narrow_new(const struct unknowns *unknowns);
void narrow_free(struct narrow *narrow);

/* Of a direction, of which no node's number is beyond largest. */
void narrow_take(const struct unknowns *unknowns, const float *d, double largest,
                 struct narrow *narrow);

/* d *= a */
void narrow_scale(double a, struct narrow *d);
/* d = b w + sum of a[k] x[k], k < count, which is even; bits of the largest (direction.h). */
uint32_t narrow_combine(const struct unknowns *unknowns, double b, const float *w, int count,
                        const double a[], const struct narrow *const x[], float *d);

/* products[k] = d[k] . y, k < count <= NARROW_MOST, whose norm is not beyond this; products[count]
 * = w . y, of which no number is beyond largest.  Collective. */
void narrow_products(const struct unknowns *unknowns, int count, const struct narrow *const d[],
                     const float *w, double largest, const double *y, double norm,
                     double products[]);

#endif
