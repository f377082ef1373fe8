#include "exact_sum.h"

#include "memory.h"
#include "ranks.h"
#include "simd.h"

#include <math.h>
#include <stdlib.h>

struct exact_sum exact_sum_new(double bound)
{
    int exponent;
    frexp(bound > 0 ? bound : 1, &exponent);
    struct exact_sum sum = {.high = ldexp(1.5, exponent + 1)};
    sum.low = sum.high * 0x1p-24;
    return sum;
}

HS_SIMD static void extract(int count, const double *restrict terms, double scale, double high,
                            double low, double *restrict sums)
{
    double top = 0, bottom = 0;
#pragma omp simd reduction(+ : top, bottom)
    for (int i = 0; i < count; i++) {
        double term = scale * terms[i];
        double first = (term + high) - high;
        top += first;
        bottom += ((term - first) + low) - low;
    }
    sums[0] += top;
    sums[1] += bottom;
}

void exact_sum_add_strip(struct exact_sum *sum, int count, const double *terms, double scale)
{
    double sums[2] = {sum->top, sum->bottom};
    extract(count, terms, scale, sum->high, sum->low, sums);
    sum->top = sums[0];
    sum->bottom = sums[1];
}

void exact_sum_finish(const struct exact_sum *sums, int count, double *values)
{
    enum { FEW = 32 }; /* of what is asked for at each force */
    double room[2 * FEW],
        *parts = count <= FEW ? room : memory_new(2 * (size_t)count, sizeof *parts);
    for (int i = 0; i < count; i++) {
        parts[2 * i] = sums[i].top;
        parts[2 * i + 1] = sums[i].bottom;
    }
    ranks_sum(parts, 2 * count);
    for (int i = 0; i < count; i++) values[i] = parts[2 * i] + parts[2 * i + 1];
    if (parts != room) free(parts);
}
