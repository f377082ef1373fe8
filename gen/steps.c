#include "steps.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

struct step steps_to(const double spacing[3], const int offset[3])
{
    struct step step = {{offset[0], offset[1], offset[2]}, 0, 0};
    double square = 0, edge = 0; /* of cubes: whole numbers, and the same */
    for (int axis = 0; axis < 3; axis++) {
        const double ratio = spacing[axis] / spacing[0], part = offset[axis] * ratio;
        square += part * part;
        edge += part * part * ratio * ratio;
    }
    step.distance = sqrt(square);
    step.edge = sqrt(edge) / step.distance;
    return step;
}

double steps_film(const struct step *step)
{
    return step->distance - step->edge;
}

bool steps_touch(const struct step *step)
{
    return abs(step->offset[0]) <= 1 && abs(step->offset[1]) <= 1 && abs(step->offset[2]) <= 1;
}

double steps_unit(const double spacing[3], bool sheet)
{
    const double y = spacing[1] / spacing[0], z = spacing[2] / spacing[0];
    return sheet ? sqrt(y) : cbrt(y * z);
}

double steps_longest_edge(const double spacing[3], bool sheet)
{
    const double in_plane = fmax(spacing[0], spacing[1]) / spacing[0];
    return sheet ? in_plane : fmax(in_plane, spacing[2] / spacing[0]);
}

/* Offsets of equal length in a fixed order. */
static int compare_offsets(const struct step *left, const struct step *right)
{
    int order = 0;
    for (int axis = 2; axis >= 0 && order == 0; axis--)
        order =
            (left->offset[axis] > right->offset[axis]) - (left->offset[axis] < right->offset[axis]);
    return order;
}

static int compare_distances(const void *a, const void *b)
{
    const struct step *left = a, *right = b;
    const int order = (left->distance > right->distance) - (left->distance < right->distance);
    return order ? order : compare_offsets(left, right);
}

static int compare_films(const void *a, const void *b)
{
    const struct step *left = a, *right = b;
    int order = steps_touch(right) - steps_touch(left);
    const double one = steps_film(left), other = steps_film(right);
    if (order == 0) order = (one > other) - (one < other);
    return order ? order : compare_offsets(left, right);
}

struct step *steps_ball(const double spacing[3], double radius, bool half, bool sheet,
                        enum steps_order order, int *count)
{
    int reach[3];
    for (int axis = 0; axis < 3; axis++)
        reach[axis] = (int)floor(radius * spacing[0] / spacing[axis] * (1 + 1e-12));
    if (sheet) reach[2] = 0;
    const size_t most =
        (size_t)(2 * reach[0] + 1) * (size_t)(2 * reach[1] + 1) * (size_t)(2 * reach[2] + 1);
    struct step *steps = memory_new(most, sizeof *steps);
    *count = 0;
    for (int k = half ? 0 : -reach[2]; k <= reach[2]; k++)
        for (int j = -reach[1]; j <= reach[1]; j++)
            for (int i = -reach[0]; i <= reach[0]; i++) {
                if (i == 0 && j == 0 && k == 0) continue;
                const bool upper = k > 0 || (k == 0 && (j > 0 || (j == 0 && i > 0)));
                const struct step step = steps_to(spacing, (const int[3]){i, j, k});
                if (step.distance <= radius && (upper || !half)) steps[(*count)++] = step;
            }
    qsort(steps, (size_t)*count, sizeof *steps,
          order == STEPS_BY_FILM ? compare_films : compare_distances);
    return steps;
}
