#include "forest.h"

#include "memory.h"

#include <stdlib.h>

struct forest forest_new(int64_t n, bool periodic)
{
    struct forest forest = {.parent = memory_new((size_t)n, sizeof *forest.parent)};
    for (int64_t node = 0; node < n; node++) forest.parent[node] = (int32_t)node;
    if (periodic) forest.around = memory_new((size_t)n, sizeof *forest.around);
    if (periodic) forest.closed = memory_new((size_t)n, sizeof *forest.closed);
    return forest;
}

void forest_free(struct forest *forest)
{
    free(forest->parent);
    free(forest->around);
    free(forest->closed);
    *forest = (struct forest){0};
}

int32_t forest_root(struct forest *forest, int32_t node)
{
    int32_t *parent = forest->parent;
    while (parent[node] != node) {
        const int32_t up = parent[node];
        for (int axis = 0; forest->around && axis < 3; axis++)
            forest->around[node][axis] += forest->around[up][axis];
        parent[node] = parent[up];
        node = parent[node];
    }
    return node;
}

/* The image in which the node is met on the way from its root. */
static void sum_around(struct forest *forest, int32_t node, int32_t sum[3])
{
    for (; forest->parent[node] != node; node = forest->parent[node])
        for (int axis = 0; axis < 3; axis++) sum[axis] += forest->around[node][axis];
}

void forest_join(struct forest *forest, int32_t node, int32_t neighbour, const int32_t around[3])
{
    const int32_t a = forest_root(forest, node), b = forest_root(forest, neighbour);
    const int32_t low = a < b ? a : b, high = a < b ? b : a;
    forest->parent[high] = low;
    if (!forest->around) return;
    int32_t gap[3] = {0}, there[3] = {0};
    /* The root just joined has no way up yet: its own is zero. */
    sum_around(forest, node, gap);
    sum_around(forest, neighbour, there);
    for (int axis = 0; axis < 3; axis++) {
        gap[axis] += around[axis] - there[axis];
        if (a == b && gap[axis] != 0) forest->closed[a][axis] = true;
        if (a != b) forest->around[high][axis] = high == b ? gap[axis] : -gap[axis];
    }
}
