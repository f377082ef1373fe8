#include "voxels.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

double voxels_size(const struct voxels *voxels, int axis)
{
    return (double)voxels->count[axis] * voxels->edge[axis];
}

static int64_t number_of(const struct voxels *voxels, const int64_t at[3])
{
    return at[0] + voxels->count[0] * (at[1] + voxels->count[1] * at[2]);
}

static struct voxel take(const struct voxels *voxels, int64_t number)
{
    return (struct voxel){voxels->phase[number], voxels->grain ? voxels->grain[number] : 0};
}

/* --- resampling ---------------------------------------------------------------------------------
 */

/* Voxels that a stretch of an axis meets. */
struct stretch {
    int64_t first, last;
    double low, high; /* edges, from the first corner of the box */
};

static int64_t within(int64_t i, int64_t count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

static struct stretch meet(const struct voxels *voxels, int axis, double centre, double width)
{
    /* What rounding alone makes a cell share is none. */
    const double rounding = 1e-9, edge = voxels->edge[axis];
    const double middle = (centre + 0.5 * voxels_size(voxels, axis)) / edge;
    struct stretch stretch = {.low = middle - 0.5 * width / edge,
                              .high = middle + 0.5 * width / edge};
    stretch.first = within((int64_t)floor(stretch.low + rounding), voxels->count[axis]);
    stretch.last = within((int64_t)ceil(stretch.high - rounding) - 1, voxels->count[axis]);
    return stretch;
}

static double share(const struct stretch *stretch, int64_t i)
{
    return fmin(stretch->high, (double)i + 1) - fmax(stretch->low, (double)i);
}

/* Index of the largest; sums that differ by rounding alone are equal. */
static int largest(const double *sums, int count)
{
    int best = 0;
    for (int i = 1; i < count; i++)
        if (sums[i] > sums[best] * (1 + 1e-9)) best = i;
    return best;
}

struct majority {
    const struct voxels *voxels;
    struct stretch along[3];
    double phase[VOXEL_PHASES + 1]; /* the last one: no material */
    int n_grains;
    int64_t *grain;
    double *part;
};

/* Adds the part of the cell in each voxel to its phase; with a phase, to the grains of that one. */
static void sum_up(struct majority *majority, int phase)
{
    const struct voxels *voxels = majority->voxels;
    const struct stretch *along = majority->along;
    int64_t at[3];
    for (at[2] = along[2].first; at[2] <= along[2].last; at[2]++)
        for (at[1] = along[1].first; at[1] <= along[1].last; at[1]++)
            for (at[0] = along[0].first; at[0] <= along[0].last; at[0]++) {
                const double part =
                    share(&along[0], at[0]) * share(&along[1], at[1]) * share(&along[2], at[2]);
                const struct voxel here = take(voxels, number_of(voxels, at));
                if (phase < 0) {
                    const bool empty = here.phase == VOXEL_EMPTY;
                    majority->phase[empty ? VOXEL_PHASES : here.phase] += part;
                } else if (here.phase == phase) {
                    int g = 0;
                    while (g < majority->n_grains && majority->grain[g] != here.grain) g++;
                    if (g == majority->n_grains) {
                        majority->grain = memory_grow(majority->grain, g, sizeof(int64_t));
                        majority->part = memory_grow(majority->part, g, sizeof(double));
                        majority->grain[g] = here.grain;
                        majority->part[g] = 0;
                        majority->n_grains++;
                    }
                    majority->part[g] += part;
                }
            }
}

static struct voxel take_majority(const struct voxels *voxels, const double point[3],
                                  const double cell[3])
{
    struct majority majority = {.voxels = voxels};
    for (int axis = 0; axis < 3; axis++)
        majority.along[axis] = meet(voxels, axis, point[axis], cell[axis]);
    sum_up(&majority, -1);
    const int phase = largest(majority.phase, VOXEL_PHASES + 1);
    struct voxel found = {phase == VOXEL_PHASES ? VOXEL_EMPTY : phase, 0};
    if (voxels->grain && phase < VOXEL_PHASES) {
        sum_up(&majority, phase);
        found.grain = majority.grain[largest(majority.part, majority.n_grains)];
    }
    free(majority.grain);
    free(majority.part);
    return found;
}

struct voxel voxels_at(const struct voxels *voxels, const double point[3], const double cell[3],
                       enum voxels_rule rule)
{
    int64_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        const double size = voxels_size(voxels, axis), edge = voxels->edge[axis];
        if (fabs(point[axis]) > 0.5 * size * (1 + 1e-9)) return (struct voxel){VOXEL_OUTSIDE, 0};
        at[axis] = within((int64_t)floor((point[axis] + 0.5 * size) / edge), voxels->count[axis]);
    }
    return rule == VOXELS_MAJORITY ? take_majority(voxels, point, cell)
                                   : take(voxels, number_of(voxels, at));
}

/* --- cutting ------------------------------------------------------------------------------------
 */

void voxels_crop(struct voxels *voxels, const int64_t low[3], const int64_t high[3],
                 const bool mirror[3])
{
    struct voxels cut = *voxels;
    int64_t from[3], to[3];
    for (int axis = 0; axis < 3; axis++)
        cut.count[axis] = (high[axis] - low[axis]) * (mirror[axis] ? 2 : 1);
    const size_t number = (size_t)(cut.count[0] * cut.count[1] * cut.count[2]);
    cut.phase = memory_new(number, sizeof *cut.phase);
    cut.grain = voxels->grain ? memory_new(number, sizeof *cut.grain) : NULL;
    for (to[2] = 0; to[2] < cut.count[2]; to[2]++)
        for (to[1] = 0; to[1] < cut.count[1]; to[1]++)
            for (to[0] = 0; to[0] < cut.count[0]; to[0]++) {
                for (int axis = 0; axis < 3; axis++) {
                    const int64_t last = cut.count[axis] - 1 - to[axis];
                    const bool back = to[axis] >= high[axis] - low[axis];
                    from[axis] = low[axis] + (back ? last : to[axis]);
                }
                const struct voxel here = take(voxels, number_of(voxels, from));
                cut.phase[number_of(&cut, to)] = (uint8_t)here.phase;
                if (cut.grain) cut.grain[number_of(&cut, to)] = here.grain;
            }
    voxels_free(voxels);
    *voxels = cut;
}

void voxels_free(struct voxels *voxels)
{
    free(voxels->phase);
    free(voxels->grain);
    *voxels = (struct voxels){0};
}
