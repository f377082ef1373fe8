#include "cells.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

static const double parted = 2.5; /* distance of neighbours now over that at rest */

/* The layer as a table of its sites. */
struct layer {
    const struct snapshot *snapshot;
    const int *axes;
    const int64_t *nodes;
    double edge[2], low[2];
    int64_t size[2];
    int64_t *at;              /* [size] index of nodes; -1: none */
    double (*gradient)[2][2]; /* of the displacement, [count] */
};

static double rest(const struct layer *layer, int64_t k, int a)
{
    return snapshot_axis(layer->snapshot, layer->axes[a])[layer->nodes[k]];
}

static double moved(const struct layer *layer, int64_t k, int a)
{
    const double *u = layer->snapshot->displacement[layer->axes[a]];
    return u ? u[layer->nodes[k]] : 0;
}

static int64_t site_of(const struct layer *layer, int64_t k, int a)
{
    return (int64_t)llround((rest(layer, k, a) - layer->low[a]) / layer->edge[a]);
}

static int64_t at(const struct layer *layer, int64_t i, int64_t j)
{
    if (i < 0 || j < 0 || i >= layer->size[0] || j >= layer->size[1]) return -1;
    return layer->at[j * layer->size[0] + i];
}

static bool joined(const struct layer *layer, int64_t k, int64_t other)
{
    double now = 0, before = 0;
    if (other < 0 || k < 0) return false;
    for (int a = 0; a < 2; a++) {
        const double x = rest(layer, other, a) - rest(layer, k, a);
        const double u = moved(layer, other, a) - moved(layer, k, a);
        before += x * x;
        now += (x + u) * (x + u);
    }
    return now < parted * parted * before;
}

/* Differences to the neighbours on both sides, or on the one where there is one. */
static void find_gradient(struct layer *layer, int64_t k)
{
    const int64_t i = site_of(layer, k, 0), j = site_of(layer, k, 1);
    for (int b = 0; b < 2; b++) {
        const int64_t before = at(layer, i - (b == 0), j - (b == 1));
        const int64_t after = at(layer, i + (b == 0), j + (b == 1));
        const int64_t from = joined(layer, k, before) ? before : k;
        const int64_t to = joined(layer, k, after) ? after : k;
        for (int a = 0; a < 2; a++)
            layer->gradient[k][a][b] = from == to ? 0
                                                  : (moved(layer, to, a) - moved(layer, from, a)) /
                                                        (rest(layer, to, b) - rest(layer, from, b));
    }
}

/* Whether two of the four sites around a corner are together, directly or by one of the others. */
static bool together(const struct layer *layer, const int64_t around[4], int k, int other)
{
    if (around[other] < 0) return false;
    if (k == other) return true;
    if (k + other != 3) return joined(layer, around[k], around[other]);
    for (int by = 0; by < 4; by++)
        if (by != k && by != other && joined(layer, around[k], around[by]) &&
            joined(layer, around[by], around[other]))
            return true;
    return false;
}

/* Upper right corner of the site (i, j) as the cell around[mine] has it. */
static void put_corner(const struct layer *layer, int64_t i, int64_t j, int mine, double factor,
                       double corner[2])
{
    const int64_t around[4] = {at(layer, i, j), at(layer, i + 1, j), at(layer, i, j + 1),
                               at(layer, i + 1, j + 1)};
    double sum[2] = {0, 0};
    int count = 0;
    for (int s = 0; s < 4; s++) {
        if (!together(layer, around, mine, s)) continue;
        const int64_t k = around[s];
        const double to[2] = {(s % 2 ? -0.5 : 0.5) * layer->edge[0],
                              (s / 2 ? -0.5 : 0.5) * layer->edge[1]};
        count++;
        for (int a = 0; a < 2; a++)
            sum[a] += rest(layer, k, a) + to[a] +
                      factor * (moved(layer, k, a) + layer->gradient[k][a][0] * to[0] +
                                layer->gradient[k][a][1] * to[1]);
    }
    for (int a = 0; a < 2; a++) corner[a] = sum[a] / count;
}

static void put_cell(const struct layer *layer, int64_t k, double factor, struct cell *cell)
{
    const int64_t i = site_of(layer, k, 0), j = site_of(layer, k, 1);
    put_corner(layer, i - 1, j - 1, 3, factor, cell->corner[0]);
    put_corner(layer, i, j - 1, 2, factor, cell->corner[1]);
    put_corner(layer, i, j, 0, factor, cell->corner[2]);
    put_corner(layer, i - 1, j, 1, factor, cell->corner[3]);
}

/* False where the particles are no lattice of a size that fits them. */
static bool find_layer(struct layer *layer, int64_t count)
{
    enum { ROOM = 16, MORE = 1000000 };
    double high[2] = {-INFINITY, -INFINITY}, sites = 1;
    for (int a = 0; a < 2; a++) {
        layer->edge[a] = layer->snapshot->edge[layer->axes[a]];
        layer->low[a] = INFINITY;
        for (int64_t k = 0; k < count; k++) {
            layer->low[a] = fmin(layer->low[a], rest(layer, k, a));
            high[a] = fmax(high[a], rest(layer, k, a));
        }
        if (!(layer->edge[a] > 0)) return false;
        sites *= (high[a] - layer->low[a]) / layer->edge[a] + 1.5;
    }
    if (!(sites < (double)(ROOM * count + MORE))) return false;
    for (int a = 0; a < 2; a++)
        layer->size[a] = (int64_t)llround((high[a] - layer->low[a]) / layer->edge[a]) + 1;
    const int64_t all = layer->size[0] * layer->size[1];
    layer->at = memory_new((size_t)all, sizeof *layer->at);
    for (int64_t s = 0; s < all; s++) layer->at[s] = -1;
    for (int64_t k = 0; k < count; k++)
        layer->at[site_of(layer, k, 1) * layer->size[0] + site_of(layer, k, 0)] = k;
    return true;
}

static void put_square(const struct layer *layer, int64_t k, double factor, struct cell *cell)
{
    const double half = 0.5 * layer->snapshot->side[layer->nodes[k]];
    for (int c = 0; c < 4; c++) {
        const double to[2] = {c == 1 || c == 2 ? half : -half, c >= 2 ? half : -half};
        for (int a = 0; a < 2; a++)
            cell->corner[c][a] = rest(layer, k, a) + factor * moved(layer, k, a) + to[a];
    }
}

struct cell *cells_make(const struct snapshot *snapshot, const int axes[2], const int64_t nodes[],
                        int64_t count, double factor)
{
    struct layer layer = {.snapshot = snapshot, .axes = axes, .nodes = nodes};
    struct cell *cells = memory_new((size_t)count, sizeof *cells);
    const bool lattice = find_layer(&layer, count);
    if (lattice) layer.gradient = memory_new((size_t)count, sizeof *layer.gradient);
    for (int64_t k = 0; lattice && k < count; k++) find_gradient(&layer, k);
    for (int64_t k = 0; k < count; k++)
        if (lattice)
            put_cell(&layer, k, factor, &cells[k]);
        else
            put_square(&layer, k, factor, &cells[k]);
    free(layer.at);
    free(layer.gradient);
    return cells;
}
