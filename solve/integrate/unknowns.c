#include "unknowns.h"

#include "checkpoint.h"
#include "memory.h"
#include "simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct unknowns unknowns_new(struct body *body, const struct boundary *boundary)
{
    struct unknowns unknowns = {.body = body, .n_nodes = body->grid.n_owned};
    unknowns.macroscopic = boundary->macroscopic;
    for (int k = 0; unknowns.macroscopic && k < COMPONENTS; k++)
        if (!unknowns.macroscopic->component[k].given) unknowns.mean[unknowns.n_mean++] = k;
    unknowns.length = 3 * unknowns.n_nodes + (body->ranks.rank == 0 ? unknowns.n_mean : 0);
    unknowns.free = memory_new((size_t)unknowns.length, 1);
    int64_t node = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++, node++)
            for (int a = 0; a < 3; a++) {
                const int held = boundary->held[body->owned.items[s].site + i] >> a & 1;
                unknowns.free[a * unknowns.n_nodes + node] = held ? 0 : 1;
            }
    for (int64_t i = 3 * unknowns.n_nodes; i < unknowns.length; i++) unknowns.free[i] = 1;
    return unknowns;
}

void unknowns_free(struct unknowns *unknowns)
{
    free(unknowns->free);
    *unknowns = (struct unknowns){0};
}

double *vector_new(const struct unknowns *unknowns)
{
    return memory_new((size_t)unknowns->length, sizeof(double));
}

HS_SIMD static void scale_masked(int count, const double *restrict field, double scale,
                                 const uint8_t *restrict mask, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] = mask[i] > 0 ? scale * field[i] : 0;
}
HS_SIMD static void choose(int count, const double *restrict x, const uint8_t *restrict mask,
                           double *restrict field)
{
    for (int i = 0; i < count; i++) field[i] = mask[i] > 0 ? x[i] : field[i];
}
HS_SIMD static void add(int64_t count, double a, const double *restrict x, double *restrict y)
{
    for (int64_t i = 0; i < count; i++) y[i] += a * x[i];
}

void vector_take(const struct unknowns *unknowns, double *const fields[3], double scale,
                 double *vector)
{
    const struct strips *owned = &unknowns->body->owned;
    for (int a = 0; a < 3; a++) {
        int64_t at = a * unknowns->n_nodes;
        for (int64_t s = 0; s < owned->count; at += owned->items[s++].count)
            scale_masked(owned->items[s].count, fields[a] + owned->items[s].site, scale,
                         unknowns->free + at, vector + at);
    }
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++) vector[i] = 0;
}

void vector_put(const struct unknowns *unknowns, const double *vector, double *const fields[3])
{
    const struct strips *owned = &unknowns->body->owned;
    for (int a = 0; a < 3; a++) {
        int64_t at = a * unknowns->n_nodes;
        for (int64_t s = 0; s < owned->count; at += owned->items[s++].count)
            choose(owned->items[s].count, vector + at, unknowns->free + at,
                   fields[a] + owned->items[s].site);
    }
}

void vector_take_mean(const struct unknowns *unknowns, const double mean_gradient[COMPONENTS],
                      double *vector)
{
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++) {
        const int k = unknowns->mean[i - 3 * unknowns->n_nodes];
        vector[i] = unknowns->macroscopic->period[k % 3] * mean_gradient[k];
    }
}

void vector_put_mean(const struct unknowns *unknowns, const double *vector,
                     double mean_gradient[COMPONENTS])
{
    double values[COMPONENTS] = {0};
    if (unknowns->n_mean == 0) return;
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++)
        values[i - 3 * unknowns->n_nodes] = vector[i];
    ranks_share(values, (size_t)unknowns->n_mean * sizeof *values);
    for (int i = 0; i < unknowns->n_mean; i++) {
        const int k = unknowns->mean[i];
        mean_gradient[k] = values[i] / unknowns->macroscopic->period[k % 3];
    }
}

struct places {
    double *vector;
    int64_t n_nodes, *first; /* [strips] number of its first node */
};

static bool place_of(void *owner, int64_t strip, int point, bool make, double *places[])
{
    const struct places *at = owner;
    (void)make;
    for (int a = 0; a < 3; a++) places[a] = at->vector + a * at->n_nodes + at->first[strip] + point;
    return true;
}

void vector_visit(const struct unknowns *unknowns, struct checkpoint *checkpoint, const char *name,
                  double *vector)
{
    const struct strips *owned = &unknowns->body->owned;
    const size_t bytes = (size_t)(unknowns->length - 3 * unknowns->n_nodes) * sizeof *vector;
    struct places places = {vector, unknowns->n_nodes,
                            memory_new((size_t)owned->count + 1, sizeof *places.first)};
    for (int64_t s = 0; s < owned->count; s++)
        places.first[s + 1] = places.first[s] + owned->items[s].count;
    checkpoint_points(checkpoint, name, owned, 3, place_of, &places);
    free(places.first);
    double mean[COMPONENTS] = {0};
    memcpy(mean, vector + 3 * unknowns->n_nodes, bytes);
    ranks_share(mean, sizeof mean);
    checkpoint_numbers(checkpoint, "its mean gradient", mean, COMPONENTS);
    memcpy(vector + 3 * unknowns->n_nodes, mean, bytes);
}

void vector_add(const struct unknowns *unknowns, double a, const double *x, double *y)
{
    add(unknowns->length, a, x, y);
}

HS_SIMD static void scale(int64_t count, double a, double *restrict y)
{
    for (int64_t i = 0; i < count; i++) y[i] *= a;
}

void vector_scale(const struct unknowns *unknowns, double a, double *y)
{
    scale(unknowns->length, a, y);
}

HS_SIMD static void divide_difference(int64_t count, const double *restrict x,
                                      const double *restrict before, double dt,
                                      double *restrict rate)
{
    for (int64_t i = 0; i < count; i++) rate[i] = (x[i] - before[i]) / dt;
}

void vector_rate(const struct unknowns *unknowns, const double *x, const double *before, double dt,
                 double *rate)
{
    divide_difference(unknowns->length, x, before, dt, rate);
}

/* Vectors are walked over in blocks that stay in the nearest cache. */
enum { BLOCK = 512 };

static int block_length(const struct unknowns *unknowns, int64_t from)
{
    const int64_t remaining = unknowns->length - from;
    return (int)(remaining < BLOCK ? remaining : BLOCK);
}

/* Largest magnitude, and 0, or not a number where one is not finite; in lanes of their own. */
HS_SIMD static void find_largest(int64_t count, const double *restrict x, double *restrict largest,
                                 double *restrict nothing)
{
    enum { WIDTH = 8 };
    double most[WIDTH] = {0}, sum[WIDTH] = {0};
    for (int64_t i = 0; i < count; i += WIDTH) {
        const int lanes = count - i < WIDTH ? (int)(count - i) : WIDTH;
        for (int k = 0; k < lanes; k++) {
            const double size = fabs(x[i + k]);
            most[k] = size > most[k] ? size : most[k];
            sum[k] += 0 * size;
        }
    }
    *largest = *nothing = 0;
    for (int k = 0; k < WIDTH; k++) {
        *largest = most[k] > *largest ? most[k] : *largest;
        *nothing += sum[k];
    }
}

double vector_largest(const struct unknowns *unknowns, const double *x)
{
    double largest, nothing;
    find_largest(unknowns->length, x, &largest, &nothing);
    double least[] = {nothing == 0 ? 0 : -1, -largest};
    ranks_minimum(least, 2);
    return least[0] < 0 ? NAN : -least[1];
}

/* The sums of exact_sum.h in two chains of additions at a time, which hide the delay of one; exact
 * sums do not mind the order. */
HS_SIMD static void extract(int count, const double *restrict x, const double *restrict y,
                            double high, double low, double *restrict sums)
{
    const int half = count / 2;
    double top = 0, bottom = 0, second_top = 0, second_bottom = 0;
#pragma omp simd reduction(+ : top, bottom, second_top, second_bottom)
    for (int i = 0; i < half; i++) {
        const double term = x[i] * y[i], second = x[half + i] * y[half + i];
        const double part = (term + high) - high, second_part = (second + high) - high;
        top += part;
        second_top += second_part;
        bottom += ((term - part) + low) - low;
        second_bottom += ((second - second_part) + low) - low;
    }
    if (count % 2) {
        const double term = x[count - 1] * y[count - 1], part = (term + high) - high;
        top += part;
        bottom += ((term - part) + low) - low;
    }
    sums[0] += top + second_top;
    sums[1] += bottom + second_bottom;
}

static void add_products(struct exact_sum *sum, int count, const double *x, const double *y)
{
    double sums[2] = {sum->top, sum->bottom};
    extract(count, x, y, sum->high, sum->low, sums);
    sum->top = sums[0];
    sum->bottom = sums[1];
}

/* Numbers of a vector on all ranks, and a little more. */
static double count_all(const struct unknowns *unknowns)
{
    return 1.000001 * (3 * (double)unknowns->body->n_nodes + unknowns->n_mean);
}

double vector_bound(const struct unknowns *unknowns, double largest)
{
    return sqrt(count_all(unknowns)) * largest;
}

double vector_norm(const struct unknowns *unknowns, const double *x)
{
    const double largest = vector_largest(unknowns, x);
    if (!(largest > 0)) return largest;
    struct exact_sum sum = exact_sum_new(count_all(unknowns) * largest * largest);
    for (int64_t from = 0; from < unknowns->length; from += BLOCK)
        add_products(&sum, block_length(unknowns, from), x + from, x + from);
    double square;
    exact_sum_finish(&sum, 1, &square);
    return sqrt(square);
}

double vector_product(const struct unknowns *unknowns, const double *x, const double *y)
{
    /* Cauchy and Schwarz bound the sum of the magnitudes. */
    struct exact_sum sum =
        exact_sum_new(1.000001 * vector_norm(unknowns, x) * vector_norm(unknowns, y));
    for (int64_t from = 0; from < unknowns->length; from += BLOCK)
        add_products(&sum, block_length(unknowns, from), x + from, y + from);
    double product;
    exact_sum_finish(&sum, 1, &product);
    return product;
}
