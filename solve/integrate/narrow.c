#include "narrow.h"

#include "direction.h"
#include "memory.h"
#include "simd.h"

#include <math.h>
#include <stdlib.h>

/* Nodes of a block, and bits of the two parts of a vector's numbers: B^1/2 2^HIGH and B 2^(LOW - 1)
 * times 2^15 are below 2^31. */
enum { BLOCK = 512, HIGH = 11, LOW = 7 };

struct narrow narrow_new(const struct unknowns *unknowns)
{
    return (struct narrow){.numbers = memory_new((size_t)(3 * unknowns->n_nodes), sizeof(int16_t))};
}

void narrow_free(struct narrow *narrow)
{
    free(narrow->numbers);
}

HS_SIMD static void cut(int64_t count, const float *restrict d, float inverse,
                        int16_t *restrict numbers)
{
    static const float to_integers = 0x1.8p23f;
    for (int64_t i = 0; i < count; i++)
        numbers[i] = (int16_t)(int)((d[i] * inverse + to_integers) - to_integers);
}

void narrow_take(const struct unknowns *unknowns, const float *d, double largest,
                 struct narrow *narrow)
{
    const int64_t n = 3 * unknowns->n_nodes;
    narrow->unit = largest > 0 ? largest / INT16_MAX : 1;
    cut(n, d, (float)(1 / narrow->unit), narrow->numbers);
    for (int64_t i = n; i < unknowns->length; i++) narrow->mean[i - n] = d[i];
}

void narrow_scale(double a, struct narrow *d)
{
    d->unit *= a;
    for (int i = 0; i < COMPONENTS; i++) d->mean[i] *= (float)a;
}

HS_SIMD static void start(int64_t count, float b, const float *restrict w, float *restrict d)
{
    for (int64_t i = 0; i < count; i++) d[i] = b * w[i];
}
HS_SIMD static void add_two(int64_t count, float a, const int16_t *restrict x, float b,
                            const int16_t *restrict y, float *restrict d)
{
    for (int64_t i = 0; i < count; i++) d[i] += a * (float)x[i] + b * (float)y[i];
}

uint32_t narrow_combine(const struct unknowns *unknowns, double b, const float *w, int count,
                        const double a[], const struct narrow *const x[], float *d)
{
    const int64_t n = 3 * unknowns->n_nodes;
    uint32_t most = 0;
    for (int64_t from = 0; from < n; from += 3 * (int64_t)BLOCK) {
        const int64_t numbers = n - from < 3 * BLOCK ? n - from : 3 * BLOCK;
        start(numbers, (float)b, w + from, d + from);
        for (int k = 0; k < count; k += 2)
            add_two(numbers, (float)(a[k] * x[k]->unit), x[k]->numbers + from,
                    (float)(a[k + 1] * x[k + 1]->unit), x[k + 1]->numbers + from, d + from);
        const uint32_t bits = direction_bits(numbers, d + from);
        most = bits > most ? bits : most;
    }
    for (int64_t i = n; i < unknowns->length; i++) {
        d[i] = (float)b * w[i];
        for (int k = 0; k < count; k++) d[i] += (float)a[k] * x[k]->mean[i - n];
    }
    return most;
}

/* The numbers of a vector as integers, in two parts. */
struct block {
    int16_t high[3][BLOCK], low[3][BLOCK];
};

HS_SIMD static void split(int count, const double *restrict y, double inverse,
                          int16_t *restrict high, int16_t *restrict low)
{
    static const double to_integers = 0x1.8p52;
    for (int i = 0; i < count; i++) {
        const int all = (int)((y[i] * inverse + to_integers) - to_integers),
                  part = (all + (1 << (LOW - 1))) >> LOW;
        high[i] = (int16_t)part;
        low[i] = (int16_t)(all - part * (1 << LOW));
    }
}

/* Products of a block of nodes, which doubles hold. */
HS_SIMD static double multiply(int nodes, int64_t stride, const int16_t *restrict d,
                               const struct block *restrict y)
{
    const int16_t *restrict d_y = d + stride, *restrict d_z = d_y + stride;
    int32_t h_x = 0, h_y = 0, h_z = 0, l_x = 0, l_y = 0, l_z = 0;
    for (int i = 0; i < nodes; i++) {
        h_x += d[i] * y->high[0][i];
        h_y += d_y[i] * y->high[1][i];
        h_z += d_z[i] * y->high[2][i];
        l_x += d[i] * y->low[0][i];
        l_y += d_y[i] * y->low[1][i];
        l_z += d_z[i] * y->low[2][i];
    }
    const int64_t high = (int64_t)h_x + h_y + h_z, low = (int64_t)l_x + l_y + l_z;
    return (double)(high * (1 << LOW) + low);
}

void narrow_products(const struct unknowns *unknowns, int count, const struct narrow *const d[],
                     const float *w, double largest, const double *y, double norm,
                     double products[])
{
    const int64_t n = unknowns->n_nodes;
    struct exact_sum sums[NARROW_MOST + 1] = {0};
    int exponent;
    frexp(norm > 0 ? norm : 1, &exponent);
    const double unit = ldexp(1, exponent - HIGH - LOW);
    struct block block;
    sums[count] = direction_sum_new(unknowns, largest, norm);
    for (int64_t from = 0; from < n; from += BLOCK) {
        const int nodes = n - from < BLOCK ? (int)(n - from) : BLOCK;
        for (int a = 0; a < 3; a++)
            split(nodes, y + a * n + from, 1 / unit, block.high[a], block.low[a]);
        direction_add_nodes(unknowns, nodes, w + from, y + from, &sums[count]);
        for (int k = 0; k < count; k++) {
            for (int a = 0; a < 3 && k + 1 < count; a++)
                prefetch(d[k + 1]->numbers + a * n + from, (size_t)nodes * sizeof(int16_t));
            sums[k].top += multiply(nodes, n, d[k]->numbers + from, &block);
        }
    }
    direction_add_mean(unknowns, w, y, &sums[count]);
    for (int64_t i = 3 * n; i < unknowns->length; i++)
        for (int k = 0; k < count; k++)
            sums[k].bottom += (double)d[k]->mean[i - 3 * n] * y[i] / (unit * d[k]->unit);
    exact_sum_finish(sums, count + 1, products);
    for (int k = 0; k < count; k++) products[k] *= unit * d[k]->unit;
}
