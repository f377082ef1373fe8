#include "cores.h"

#include "die.h"
#include "memory.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_CORES = 100000000 };

struct basis {
    int sites;
    double edge; /* of the cubic cell, in nearest-neighbour distances */
    double site[4][3];
};

static struct basis lattice_basis(enum core_lattice lattice)
{
    switch (lattice) {
    case LATTICE_SC:
        return (struct basis){1, 1, {{0, 0, 0}}};
    case LATTICE_BCC:
        return (struct basis){2, 2 / sqrt(3), {{0, 0, 0}, {0.5, 0.5, 0.5}}};
    case LATTICE_FCC:
        break;
    }
    return (struct basis){4, sqrt(2), {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};
}

const char *cores_axes(const struct cores_box *box, char text[4])
{
    int length = 0;
    for (int axis = 0; axis < 3; axis++)
        if (box->periodic[axis]) text[length++] = "xyz"[axis];
    text[length] = '\0';
    return text;
}

double cores_lattice_edge(enum core_lattice lattice)
{
    return lattice_basis(lattice).edge;
}

static struct cores cores_new(enum core_shape shape, double distance, const struct cores_box *box,
                              int64_t most)
{
    struct cores cores = {.shape = shape, .distance = distance, .box = *box};
    cores.centre = memory_new((size_t)most, sizeof *cores.centre);
    cores.order = memory_new((size_t)most, sizeof *cores.order);
    return cores;
}

/* A random permutation (Fisher and Yates), so that labels never depend on positions. */
static void draw_order(struct cores *cores, long seed)
{
    struct random_stream *stream = random_new(seed, "labels");
    for (int64_t i = 0; i < cores->count; i++) {
        int64_t j = (int64_t)random_integer(stream, (uint64_t)i + 1);
        cores->order[i] = cores->order[j];
        cores->order[j] = i;
    }
    random_free(stream);
}

/* Adds the centre when it is near enough to the body for its cell or sphere to reach in. */
static void add_centre(struct cores *cores, const double centre[3], double reach)
{
    const struct cores_box *box = &cores->box;
    for (int axis = 0; axis < 3; axis++)
        if (!box->periodic[axis] && fabs(centre[axis]) > 0.5 * box->size[axis] + reach) return;
    for (int axis = 0; axis < 3; axis++) cores->centre[cores->count][axis] = centre[axis];
    cores->count++;
}

struct cores cores_lattice(enum core_lattice lattice, enum core_shape shape, double distance,
                           double jitter, const struct cores_box *box, long seed)
{
    struct basis basis = lattice_basis(lattice);
    double edge = basis.edge * distance;
    double reach = (2 + 4 * jitter) * distance;
    int64_t low[3], high[3];
    double cells = 1;
    for (int axis = 0; axis < 3; axis++) {
        const double most = 0.5 * box->size[axis] + reach + fabs(box->offset[axis]);
        high[axis] = (int64_t)ceil(most / edge);
        low[axis] = -high[axis];
        if (box->periodic[axis]) {
            low[axis] = 0;
            high[axis] = (int64_t)llround(box->size[axis] / edge) - 1;
        }
        cells *= (double)(high[axis] - low[axis] + 1);
    }
    if (cells * basis.sites > MOST_CORES)
        die_user("core distance %g m: more than %d cores", distance, MOST_CORES);
    struct cores cores = cores_new(shape, distance, box, (int64_t)cells * basis.sites);
    struct random_stream *stream = random_new(seed, "jitter");
    for (int64_t k = low[2]; k <= high[2]; k++)
        for (int64_t j = low[1]; j <= high[1]; j++)
            for (int64_t i = low[0]; i <= high[0]; i++)
                for (int b = 0; b < basis.sites; b++) {
                    double cell[3] = {(double)i, (double)j, (double)k};
                    double centre[3];
                    for (int axis = 0; axis < 3; axis++) {
                        centre[axis] =
                            edge * (cell[axis] + basis.site[b][axis]) + box->offset[axis];
                        if (jitter > 0) centre[axis] += jitter * distance * random_gaussian(stream);
                    }
                    add_centre(&cores, centre, reach);
                }
    random_free(stream);
    draw_order(&cores, seed);
    cores_finish(&cores, 2 * reach);
    return cores;
}

struct cores cores_random(enum core_shape shape, double density, double margin,
                          const struct cores_box *box, long seed)
{
    double expected = density, extent[3];
    const bool periodic = box->periodic[0] || box->periodic[1] || box->periodic[2];
    for (int axis = 0; axis < 3; axis++) {
        extent[axis] = box->size[axis] + (box->periodic[axis] ? 0 : 2 * margin);
        expected *= extent[axis];
    }
    if (!(expected < MOST_CORES))
        die_user("%g random cores are more than %d", expected, MOST_CORES);
    if (periodic && expected < 1)
        die_user("the periodic body is so small that it holds %.3g of a random core: take a larger "
                 "one or smaller cores",
                 expected);
    int64_t count = (int64_t)llround(fmax(expected, 1));
    struct cores cores = cores_new(shape, cbrt(1 / density), box, count);
    struct random_stream *stream = random_new(seed, "positions");
    for (; cores.count < count; cores.count++)
        for (int axis = 0; axis < 3; axis++)
            cores.centre[cores.count][axis] = (random_uniform(stream) - 0.5) * extent[axis];
    random_free(stream);
    draw_order(&cores, seed);
    cores_finish(&cores, CORES_REACH * cores.distance);
    return cores;
}

void cores_free(struct cores *cores)
{
    free(cores->centre);
    free(cores->order);
    free(cores->original);
    free(cores->image);
    free(cores->first);
    free(cores->member);
    *cores = (struct cores){0};
}
