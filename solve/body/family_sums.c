/* family_sums.c - the sums of (family_sums.2), strips of nodes at a time.
 *
 * Gradient and divergence are sums over whole families, of the same weights at every node, in each
 * evaluation of the force.  Member by member they would read each neighbour once a node; by
 * columns, what nodes beside each other share is added once, in buffers along x that are as much
 * longer than the strip as the family reaches.  The order of the terms depends on the family alone,
 * so a node's sum has the same bits in any strip.  No index but the strip's own varies in a loop:
 * they are vector loads at any offset. */
#include "family_sums.h"

#include "simd.h"

#include <string.h>

enum { VECTOR = 8, LONGEST_REACH = 8 /* of a deck */ };

HS_SIMD static void add_sum(int count, const double *restrict plus, const double *restrict minus,
                            double weight, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] += (plus[i] + minus[i]) * weight;
}
HS_SIMD static void add_difference(int count, const double *restrict plus,
                                   const double *restrict minus, double weight,
                                   double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] += (plus[i] - minus[i]) * weight;
}
HS_SIMD static void add_one(int count, const double *restrict a, double weight,
                            double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] += a[i] * weight;
}

static void add_columns(const struct grid *grid, int b, const struct columns *level, int count,
                        const double *field, double *out)
{
    for (int c = 0; c < level->count; c++) {
        const struct column *column = &level->items[c];
        const int64_t shift = grid_shift(grid, (const int[]){0, column->y, column->z});
        (b == 0 ? add_sum : add_difference)(count, field + shift, field - shift, column->weight,
                                            out);
    }
}

void family_sums_add(const struct family *family, const struct grid *grid, int b, int count,
                     const double *field, double *out)
{
    double padded[LANES + 2 * LONGEST_REACH + VECTOR], *const sums = padded + LONGEST_REACH;
    bool empty = true;
    double own = 0; /* weight of the site's own column while there is no other */
    for (int k = family->reach; k > 0; k--) {
        const struct columns *level = &family->columns[b][k];
        const int wide = (count + 2 * k + VECTOR - 1) / VECTOR * VECTOR;
        own += level->own;
        const bool first = empty && level->count > 0;
        if (first) memset(padded, 0, sizeof padded);
        empty &= !first;
        const double added = first ? own : level->own;
        if (!empty && added != 0) add_one(wide, field - k, added, sums - k);
        add_columns(grid, b, level, wide, field - k, sums - k);
        if (b > 0 && !empty)
            add_sum(count, sums + k, sums - k, 1, out);
        else if (b == 0 && empty)
            add_difference(count, field + k, field - k, k * own, out);
        else if (b == 0)
            add_difference(count, sums + k, sums - k, k, out);
    }
    if (b == 0) return; /* where members at |x| = 0 give nothing */
    const struct columns *level = &family->columns[b][0];
    add_columns(grid, b, level, count, field, out);
    if (!empty) add_one(count, sums, 1, out);
}
