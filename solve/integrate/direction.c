#include "direction.h"

#include "memory.h"
#include "simd.h"

#include <math.h>
#include <stdlib.h>

enum { BLOCK = 512 }; /* nodes whose numbers stay in the nearest cache */

float *direction_new(const struct unknowns *unknowns)
{
    return memory_new((size_t)unknowns->length, sizeof(float));
}

HS_SIMD static void start(int count, float a, const float *restrict x, float *restrict d)
{
    for (int i = 0; i < count; i++) d[i] = a * x[i];
}
HS_SIMD static void add(int count, float a, const float *restrict x, float *restrict d)
{
    for (int i = 0; i < count; i++) d[i] += a * x[i];
}

/* Largest magnitude so far, and 0, or not a number where one is not finite; in lanes of their own.
 */
HS_SIMD static void find_largest(int count, const float *restrict d, float *restrict largest,
                                 float *restrict nothing)
{
    enum { WIDTH = 16 };
    float most[WIDTH] = {0}, sum[WIDTH] = {0};
    for (int i = 0; i < count; i += WIDTH) {
        const int lanes = count - i < WIDTH ? count - i : WIDTH;
        for (int k = 0; k < lanes; k++) {
            const float size = fabsf(d[i + k]);
            most[k] = size > most[k] ? size : most[k];
            sum[k] += 0 * size;
        }
    }
    for (int k = 0; k < WIDTH; k++) {
        *largest = most[k] > *largest ? most[k] : *largest;
        *nothing += sum[k];
    }
}

double direction_combine(const struct unknowns *unknowns, int count, const double a[],
                         float *const x[], float *d)
{
    float largest = 0, nothing = 0;
    for (int64_t from = 0; from < unknowns->length; from += BLOCK) {
        const int64_t left = unknowns->length - from;
        const int n = left < BLOCK ? (int)left : BLOCK;
        start(n, (float)a[0], x[0] + from, d + from);
        for (int k = 1; k < count; k++) add(n, (float)a[k], x[k] + from, d + from);
        find_largest(n, d + from, &largest, &nothing);
    }
    double least[] = {nothing == 0 ? 0 : -1, -largest};
    ranks_minimum(least, 2);
    return least[0] < 0 ? NAN : -least[1];
}

HS_SIMD static void scale(int64_t count, float a, float *restrict d)
{
    for (int64_t i = 0; i < count; i++) d[i] *= a;
}

void direction_scale(const struct unknowns *unknowns, double a, float *d)
{
    scale(unknowns->length, (float)a, d);
}

HS_SIMD static void add_to(int64_t count, double a, const float *restrict d, double *restrict y)
{
    for (int64_t i = 0; i < count; i++) y[i] += a * (double)d[i];
}

void direction_add(const struct unknowns *unknowns, double a, const float *d, double *y)
{
    add_to(unknowns->length, a, d, y);
}

/* The sums of exact_sum.h: a node's three terms, added up in their order, count as one.  In two
 * chains of additions at a time, which hide the delay of one; exact sums do not mind the order. */
HS_SIMD static void add_products(int count, int64_t stride, const float *restrict d,
                                 const double *restrict y, struct exact_sum *sum)
{
    const float *restrict d_y = d + stride, *restrict d_z = d_y + stride;
    const double *restrict y_y = y + stride, *restrict y_z = y_y + stride;
    const double high = sum->high, low = sum->low;
    double top = 0, bottom = 0;
#pragma omp simd reduction(+ : top, bottom)
    for (int i = 0; i < count; i++) {
        const double term = (double)d[i] * y[i] + (double)d_y[i] * y_y[i] + (double)d_z[i] * y_z[i];
        const double part = (term + high) - high;
        top += part;
        bottom += ((term - part) + low) - low;
    }
    sum->top += top;
    sum->bottom += bottom;
}

void direction_products(const struct unknowns *unknowns, int count, float *const d[],
                        const double norms[], const double *y, double norm, double products[])
{
    struct exact_sum *sums = memory_new((size_t)count, sizeof *sums);
    /* Cauchy and Schwarz bound the sum of the magnitudes. */
    for (int k = 0; k < count; k++) sums[k] = exact_sum_new(1.000001 * norms[k] * norm);
    for (int64_t from = 0; from < unknowns->n_nodes; from += BLOCK) {
        const int64_t left = unknowns->n_nodes - from;
        for (int k = 0; k < count; k++)
            add_products(left < BLOCK ? (int)left : BLOCK, unknowns->n_nodes, d[k] + from, y + from,
                         &sums[k]);
    }
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++)
        for (int k = 0; k < count; k++) exact_sum_add(&sums[k], (double)d[k][i] * y[i]);
    exact_sum_finish(sums, count, products);
    free(sums);
}

double direction_product(const struct unknowns *unknowns, float *d, const double *y)
{
    float largest = 0, nothing = 0;
    for (int64_t from = 0; from < unknowns->length; from += BLOCK) {
        const int64_t left = unknowns->length - from;
        find_largest(left < BLOCK ? (int)left : BLOCK, d + from, &largest, &nothing);
    }
    double least = -largest;
    ranks_minimum(&least, 1);
    const double norm = vector_bound(unknowns, -least);
    double product;
    direction_products(unknowns, 1, &d, &norm, y, vector_norm(unknowns, y), &product);
    return product;
}
