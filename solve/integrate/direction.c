#include "direction.h"

#include "memory.h"
#include "simd.h"

#include <math.h>
#include <string.h>

float *direction_new(const struct unknowns *unknowns)
{
    return memory_new((size_t)unknowns->length, sizeof(float));
}

/* The bits of magnitudes are in the order of these, infinity and what is no number at the end. */
HS_SIMD uint32_t direction_bits(int64_t count, const float *d)
{
    uint32_t largest = 0;
    for (int64_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &d[i], sizeof bits);
        bits &= INT32_MAX;
        largest = bits > largest ? bits : largest;
    }
    return largest;
}

double direction_largest_of(const struct unknowns *unknowns, const float *d, uint32_t bits,
                            double *of_nodes)
{
    const int64_t n = 3 * unknowns->n_nodes;
    const uint32_t both[] = {bits, direction_bits(unknowns->length - n, d + n)};
    float largest[2];
    memcpy(largest, both, sizeof largest);
    const bool finite = isfinite(largest[0]) && isfinite(largest[1]);
    double least[] = {finite ? 0 : -1, -largest[0], -largest[1]};
    ranks_minimum(least, 3);
    *of_nodes = -least[1];
    return least[0] < 0 ? NAN : fmax(-least[1], -least[2]);
}

double direction_largest(const struct unknowns *unknowns, const float *d, double *of_nodes)
{
    return direction_largest_of(unknowns, d, direction_bits(3 * unknowns->n_nodes, d), of_nodes);
}

HS_SIMD static void subtract(int64_t count, const float *restrict x, float *restrict d)
{
    for (int64_t i = 0; i < count; i++) d[i] = x[i] - d[i];
}

double direction_subtract_from(const struct unknowns *unknowns, const float *x, float *d,
                               double *of_nodes)
{
    enum { BLOCK = 2048 };
    const int64_t n = 3 * unknowns->n_nodes;
    uint32_t most = 0;
    for (int64_t from = 0; from < n; from += BLOCK) {
        const int64_t count = n - from < BLOCK ? n - from : BLOCK;
        subtract(count, x + from, d + from);
        const uint32_t bits = direction_bits(count, d + from);
        most = bits > most ? bits : most;
    }
    subtract(unknowns->length - n, x + n, d + n);
    return direction_largest_of(unknowns, d, most, of_nodes);
}

HS_SIMD static void add_to(int64_t count, double a, const float *restrict d, double *restrict y)
{
    for (int64_t i = 0; i < count; i++) y[i] += a * (double)d[i];
}

void direction_add(const struct unknowns *unknowns, double a, const float *d, double *y)
{
    add_to(unknowns->length, a, d, y);
}

void direction_add_to_fields(const struct unknowns *unknowns, double a, const float *d,
                             double *const fields[3])
{
    const struct strips *owned = &unknowns->body->owned;
    for (int c = 0; c < 3; c++) {
        const float *at = d + c * unknowns->n_nodes;
        for (int64_t s = 0; s < owned->count; at += owned->items[s++].count)
            add_to(owned->items[s].count, a, at, fields[c] + owned->items[s].site);
    }
}

/* The sums of exact_sum.h: a node's three terms, added up in their order, count as one.  In two
 * chains of additions at a time, which hide the delay of one; exact sums do not mind the order. */
HS_SIMD static void add_products(int64_t count, int64_t stride, const float *restrict d,
                                 const double *restrict y, struct exact_sum *sum)
{
    const float *restrict d_y = d + stride, *restrict d_z = d_y + stride;
    const double *restrict y_y = y + stride, *restrict y_z = y_y + stride;
    const double high = sum->high, low = sum->low;
    double top = 0, bottom = 0;
#pragma omp simd reduction(+ : top, bottom)
    for (int64_t i = 0; i < count; i++) {
        const double term = (double)d[i] * y[i] + (double)d_y[i] * y_y[i] + (double)d_z[i] * y_z[i];
        const double part = (term + high) - high;
        top += part;
        bottom += ((term - part) + low) - low;
    }
    sum->top += top;
    sum->bottom += bottom;
}

struct exact_sum direction_sum_new(const struct unknowns *unknowns, double largest, double norm)
{
    /* Cauchy and Schwarz bound the sum of the magnitudes. */
    return exact_sum_new(1.000001 * vector_bound(unknowns, largest) * norm);
}

void direction_add_nodes(const struct unknowns *unknowns, int64_t count, const float *d,
                         const double *y, struct exact_sum *sum)
{
    add_products(count, unknowns->n_nodes, d, y, sum);
}

void direction_add_mean(const struct unknowns *unknowns, const float *d, const double *y,
                        struct exact_sum *sum)
{
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++)
        exact_sum_add(sum, (double)d[i] * y[i]);
}

double direction_product(const struct unknowns *unknowns, const float *d, const double *y)
{
    double of_nodes, product;
    const double largest = direction_largest(unknowns, d, &of_nodes);
    struct exact_sum sum = direction_sum_new(unknowns, largest, vector_norm(unknowns, y));
    direction_add_nodes(unknowns, unknowns->n_nodes, d, y, &sum);
    direction_add_mean(unknowns, d, y, &sum);
    exact_sum_finish(&sum, 1, &product);
    return product;
}
