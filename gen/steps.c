#include "steps.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* By length; offsets of equal length in a fixed order. */
static int compare_steps(const void *a, const void *b)
{
    const struct step *first = a, *second = b;
    int order = (first->square > second->square) - (first->square < second->square);
    for (int axis = 2; axis >= 0 && order == 0; axis--)
        order = (first->offset[axis] > second->offset[axis]) -
                (first->offset[axis] < second->offset[axis]);
    return order;
}

struct step *steps_ball(int radius, bool half, int *count)
{
    int width = 2 * radius + 1;
    struct step *steps = memory_new((size_t)(width * width * width), sizeof *steps);
    *count = 0;
    for (int k = half ? 0 : -radius; k <= radius; k++)
        for (int j = -radius; j <= radius; j++)
            for (int i = -radius; i <= radius; i++) {
                bool upper = k > 0 || (k == 0 && (j > 0 || (j == 0 && i > 0)));
                int square = i * i + j * j + k * k;
                if (square > 0 && square <= radius * radius && (upper || !half))
                    steps[(*count)++] = (struct step){{i, j, k}, square};
            }
    qsort(steps, (size_t)*count, sizeof *steps, compare_steps);
    return steps;
}
