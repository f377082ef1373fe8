#include "image_points.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

#define SLACK 0.1 /* of an edge */

void image_points_add(struct image_points *points, double x, double y, double z, double value)
{
    const int64_t n = points->count;
    points->at = memory_grow(points->at, n, sizeof *points->at);
    points->value = memory_grow(points->value, n, sizeof *points->value);
    points->at[n][0] = x;
    points->at[n][1] = y;
    points->at[n][2] = z;
    points->value[n] = value;
    points->count++;
}

void image_points_free(struct image_points *points)
{
    free(points->at);
    free(points->value);
    *points = (struct image_points){0};
}

/* Places along an axis. */
struct axis {
    double low, edge, count;
};

static int compare_numbers(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* Places of one layer differ by rounding alone, those of two by much more: a gap of more than half
 * the widest one lies between two layers.  Their mean distance is the edge. */
static struct axis find_axis(const struct image_points *points, int axis)
{
    double *place = memory_new((size_t)points->count, sizeof *place);
    for (int64_t i = 0; i < points->count; i++) place[i] = points->at[i][axis];
    qsort(place, (size_t)points->count, sizeof *place, compare_numbers);
    const double low = place[0], extent = place[points->count - 1] - low;
    double widest = 0;
    for (int64_t i = 1; i < points->count; i++) widest = fmax(widest, place[i] - place[i - 1]);
    int64_t steps = 0;
    for (int64_t i = 1; i < points->count; i++) steps += place[i] - place[i - 1] > 0.5 * widest;
    free(place);
    return (struct axis){low, steps > 0 ? extent / (double)steps : 0, (double)steps + 1};
}

static _Noreturn void refuse(const struct image_source *source, const struct image_points *points,
                             int64_t i, const char *what, const char *advice)
{
    die_user("%s: the point (%.9g, %.9g, %.9g), of %lld, %s: %s", source->path, points->at[i][0],
             points->at[i][1], points->at[i][2], (long long)points->count, what, advice);
}

void image_points_fill(const struct image_source *source, const struct image_points *points,
                       double missing, const char *advice, struct image *image)
{
    struct axis along[3];
    double count[3], edge = 0;
    if (points->count == 0) die_user("%s: there are no points in it", source->path);
    for (int axis = 0; axis < 3; axis++) {
        along[axis] = find_axis(points, axis);
        count[axis] = along[axis].count;
        if (edge == 0) edge = along[axis].edge;
    }
    /* A grid that is mostly holes is none. */
    if (isnan(missing) ? count[0] * count[1] * count[2] != (double)points->count
                       : count[0] * count[1] * count[2] > 1e3 * (double)points->count)
        die_user("%s: %lld points, and %g x %g x %g places along x, y, z: no regular grid; %s",
                 source->path, (long long)points->count, count[0], count[1], count[2], advice);
    image_size(source, image, count, HUGE_VAL);
    const int64_t voxels = image_voxels(image);
    bool *filled = memory_new((size_t)voxels, sizeof *filled);
    for (int axis = 0; axis < 3; axis++)
        image->edge[axis] = along[axis].edge > 0 ? along[axis].edge : edge;
    for (int64_t i = 0; i < points->count; i++) {
        int64_t place[3];
        for (int axis = 0; axis < 3; axis++) {
            const double at = along[axis].edge > 0
                                  ? (points->at[i][axis] - along[axis].low) / along[axis].edge
                                  : 0;
            if (fabs(at - round(at)) > SLACK)
                refuse(source, points, i, "is not on a regular grid", advice);
            place[axis] = (int64_t)llround(at);
        }
        const int64_t voxel = place[0] + image->count[0] * (place[1] + image->count[1] * place[2]);
        if (filled[voxel]) refuse(source, points, i, "is there twice", advice);
        filled[voxel] = true;
        image->value[voxel] = points->value[i];
    }
    for (int64_t i = 0; i < voxels; i++)
        if (!filled[i]) image->value[i] = missing;
    free(filled);
}
