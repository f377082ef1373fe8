#include "neighbours.h"

#include "domain.h"
#include "lattice.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

/* The reach, or so much more that the bins of a loose set take no more room than its particles. */
static double bin_width(const double length[3], int64_t n, double reach)
{
    for (double width = reach;; width *= 2) {
        double bins = 1;
        for (int a = 0; a < 3; a++) bins *= length[a] / width + 1;
        if (bins <= 4 * (double)n + 64) return width;
    }
}

static int64_t bin_of(const struct neighbours *b, double *const x[3], int64_t i, int64_t at[3])
{
    for (int a = 0; a < 3; a++) {
        at[a] = (int64_t)floor((x[a][i] - b->origin[a]) / b->width[a]);
        if (b->period[a] > 0) at[a] = (at[a] % b->size[a] + b->size[a]) % b->size[a];
        at[a] = at[a] < 0 ? 0 : at[a] >= b->size[a] ? b->size[a] - 1 : at[a];
    }
    return (at[2] * b->size[1] + at[1]) * b->size[0] + at[0];
}

/* As many nodes as the 27 bins around any node may have. */
static int64_t most_candidates(const struct neighbours *b, int64_t bins, int64_t n)
{
    int64_t most = 0;
    for (int64_t bin = 0; bin < bins; bin++) {
        const int64_t members = b->start[bin + 1] - b->start[bin];
        if (members > most) most = members;
    }
    return 27 * most < n ? 27 * most : n;
}

struct neighbours neighbours_new(double *const x[3], const double period[3], int64_t n,
                                 double reach)
{
    struct neighbours b = {.reach = reach};
    double length[3];
    int64_t bins = 1, at[3];
    for (int a = 0; a < 3; a++) {
        b.period[a] = period ? period[a] : 0;
        b.origin[a] = domain_smallest(x[a], n);
        length[a] = b.period[a] > 0 ? b.period[a] : domain_largest(x[a], n) - b.origin[a];
    }
    const double width = bin_width(length, n, reach);
    for (int a = 0; a < 3; a++) {
        const int64_t whole = (int64_t)(length[a] / width);
        b.width[a] = width;
        b.size[a] = b.period[a] > 0 && whole > 0 ? whole : whole + 1;
        if (b.period[a] > 0) b.width[a] = b.period[a] / (double)b.size[a];
        bins *= b.size[a];
    }
    b.start = memory_new((size_t)bins + 2, sizeof *b.start);
    b.nodes = memory_new((size_t)n, sizeof *b.nodes);
    for (int64_t i = 0; i < n; i++) b.start[bin_of(&b, x, i, at) + 2]++;
    for (int64_t k = 2; k <= bins + 1; k++) b.start[k] += b.start[k - 1];
    for (int64_t i = 0; i < n; i++) b.nodes[b.start[bin_of(&b, x, i, at) + 1]++] = i;
    b.found = memory_new((size_t)most_candidates(&b, bins, n), sizeof *b.found);
    return b;
}

void neighbours_free(struct neighbours *neighbours)
{
    free(neighbours->start);
    free(neighbours->nodes);
    free(neighbours->found);
    *neighbours = (struct neighbours){0};
}

static int ascending(const void *a, const void *b)
{
    const int64_t i = *(const int64_t *)a, j = *(const int64_t *)b;
    return (i > j) - (i < j);
}

/* The bins beside one along an axis, itself among them; how many. */
static int beside(const struct neighbours *b, int axis, int64_t at, int64_t bins[3])
{
    const int64_t size = b->size[axis];
    int count = 0;
    for (int64_t bin = at - 1; bin <= at + 1; bin++) {
        const bool around = b->period[axis] > 0 && size > 2;
        if (around || (bin >= 0 && bin < size)) bins[count++] = (bin + size) % size;
    }
    return count;
}

/* Adds what lies within reach among the nodes of a bin. */
static int64_t look_into(const struct neighbours *b, double *const x[3], int64_t i, int64_t bin,
                         int64_t count)
{
    const double limit = b->reach * (1 + 1e-9);
    for (int64_t k = b->start[bin]; k < b->start[bin + 1]; k++) {
        const int64_t j = b->nodes[k];
        double square = 0;
        for (int a = 0; a < 3; a++) {
            const double way = lattice_shortest(x[a][j] - x[a][i], b->period[a]);
            square += way * way;
        }
        if (j != i && square <= limit * limit) b->found[count++] = j;
    }
    return count;
}

int64_t neighbours_find(const struct neighbours *b, double *const x[3], int64_t i)
{
    int64_t at[3], bins[3][3], count = 0;
    int n[3];
    bin_of(b, x, i, at);
    for (int a = 0; a < 3; a++) n[a] = beside(b, a, at[a], bins[a]);
    for (int p = 0; p < n[2]; p++)
        for (int q = 0; q < n[1]; q++)
            for (int r = 0; r < n[0]; r++)
                count = look_into(b, x, i,
                                  (bins[2][p] * b->size[1] + bins[1][q]) * b->size[0] + bins[0][r],
                                  count);
    if (count > 1) qsort(b->found, (size_t)count, sizeof *b->found, ascending);
    return count;
}
