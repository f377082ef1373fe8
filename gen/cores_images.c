#include "cores.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_IMAGES = 100000000, MOST_SIZES = 1000 };

static void enter_box(struct cores *cores)
{
    for (int64_t c = 0; c < cores->count; c++)
        for (int axis = 0; axis < 3; axis++) {
            const double size = cores->box.size[axis];
            if (cores->box.periodic[axis])
                cores->centre[c][axis] -= size * floor(cores->centre[c][axis] / size + 0.5);
        }
}

/* Whether the image of a core lies within reach of the body; where, goes to place. */
static bool is_near(const struct cores *cores, int64_t core, const int image[3], double place[3])
{
    bool near = true;
    for (int axis = 0; axis < 3; axis++) {
        const double size = cores->box.size[axis];
        place[axis] = cores->centre[core][axis] + image[axis] * size;
        near = near && (image[axis] == 0 || fabs(place[axis]) <= 0.5 * size + cores->reach);
    }
    return near;
}

static void add_image(struct cores *cores, int64_t core, const int image[3], const double place[3])
{
    for (int axis = 0; axis < 3; axis++) {
        cores->centre[cores->count][axis] = place[axis];
        cores->image[cores->count][axis] = image[axis];
    }
    cores->order[cores->count] = cores->order[core];
    cores->original[cores->count] = core;
    cores->count++;
}

/* Visits all images within reach, shift by shift; returns how many, and adds them where there is
 * room. */
static int64_t visit_images(struct cores *cores, bool add)
{
    int most[3], image[3];
    int64_t found = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double sizes = cores->reach / cores->box.size[axis];
        if (cores->box.periodic[axis] && sizes > MOST_SIZES)
            die_user("the periodic body is %g m long along %c, far too short for cores %g m apart",
                     cores->box.size[axis], "xyz"[axis], cores -> distance);
        most[axis] = cores->box.periodic[axis] ? (int)ceil(sizes) + 1 : 0;
    }
    for (image[2] = -most[2]; image[2] <= most[2]; image[2]++)
        for (image[1] = -most[1]; image[1] <= most[1]; image[1]++)
            for (image[0] = -most[0]; image[0] <= most[0]; image[0]++) {
                double place[3];
                if (!image[0] && !image[1] && !image[2]) continue;
                for (int64_t core = 0; core < cores->own; core++) {
                    if (!is_near(cores, core, image, place)) continue;
                    if (add) add_image(cores, core, image, place);
                    if (++found > MOST_IMAGES)
                        die_user("the periodic body has more than %d cores with their images",
                                 MOST_IMAGES);
                }
            }
    return found;
}

static void add_images(struct cores *cores)
{
    const size_t own = (size_t)cores->own, all = own + (size_t)visit_images(cores, false);
    double(*centre)[3] = memory_new(all, sizeof *centre);
    int64_t *order = memory_new(all, sizeof *order);
    memcpy(centre, cores->centre, own * sizeof *centre);
    memcpy(order, cores->order, own * sizeof *order);
    free(cores->centre);
    free(cores->order);
    cores->centre = centre;
    cores->order = order;
    cores->original = memory_new(all, sizeof *cores->original);
    cores->image = memory_new(all, sizeof *cores->image);
    for (int64_t core = 0; core < cores->own; core++) cores->original[core] = core;
    visit_images(cores, true);
}

void cores_finish(struct cores *cores, double reach)
{
    const bool *periodic = cores->box.periodic;
    cores->own = cores->count;
    if (periodic[0] || periodic[1] || periodic[2]) {
        cores->reach = reach;
        enter_box(cores);
        add_images(cores);
    }
    cores_index(cores);
}
