#include "pieces.h"

#include "memory.h"
#include "neighbours.h"

#include <stdlib.h>

/* The first particle of a part, the way to which becomes shorter. */
static int64_t first_of(int64_t *towards, int64_t i)
{
    while (towards[i] != i) i = towards[i] = towards[towards[i]];
    return i;
}

int64_t pieces_count(double *const x[3], const double period[3], int64_t n, double reach)
{
    int64_t *towards = memory_new((size_t)n, sizeof *towards), pieces = n;
    struct neighbours near = neighbours_new(x, period, n, reach);
    for (int64_t i = 0; i < n; i++) towards[i] = i;
    for (int64_t i = 0; i < n; i++) {
        const int64_t count = neighbours_find(&near, x, i);
        for (int64_t k = 0; k < count && near.found[k] < i; k++) {
            const int64_t a = first_of(towards, i), b = first_of(towards, near.found[k]);
            if (a == b) continue;
            towards[a > b ? a : b] = a > b ? b : a;
            pieces--;
        }
    }
    neighbours_free(&near);
    free(towards);
    return pieces;
}
