#include "cores.h"

#include "die.h"
#include "memory.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

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

static struct cores cores_new(enum core_shape shape, double distance, const double size[3],
                              int64_t most)
{
    struct cores cores = {.shape = shape, .distance = distance};
    for (int axis = 0; axis < 3; axis++) cores.size[axis] = size[axis];
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
    for (int axis = 0; axis < 3; axis++)
        if (fabs(centre[axis]) > 0.5 * cores->size[axis] + reach) return;
    for (int axis = 0; axis < 3; axis++) cores->centre[cores->count][axis] = centre[axis];
    cores->count++;
}

struct cores cores_lattice(enum core_lattice lattice, enum core_shape shape, double distance,
                           double jitter, const double size[3], long seed)
{
    struct basis basis = lattice_basis(lattice);
    double edge = basis.edge * distance;
    double reach = (2 + 4 * jitter) * distance;
    int64_t most[3];
    double cells = 1;
    for (int axis = 0; axis < 3; axis++) {
        most[axis] = (int64_t)ceil((0.5 * size[axis] + reach) / edge);
        cells *= (double)(2 * most[axis] + 1);
    }
    if (cells * basis.sites > 1e8) die_user("core distance %g m: more than 1e8 cores", distance);
    struct cores cores = cores_new(shape, distance, size, (int64_t)cells * basis.sites);
    struct random_stream *stream = random_new(seed, "jitter");
    for (int64_t k = -most[2]; k <= most[2]; k++)
        for (int64_t j = -most[1]; j <= most[1]; j++)
            for (int64_t i = -most[0]; i <= most[0]; i++)
                for (int b = 0; b < basis.sites; b++) {
                    double cell[3] = {(double)i, (double)j, (double)k};
                    double centre[3];
                    for (int axis = 0; axis < 3; axis++) {
                        centre[axis] = edge * (cell[axis] + basis.site[b][axis]);
                        if (jitter > 0) centre[axis] += jitter * distance * random_gaussian(stream);
                    }
                    add_centre(&cores, centre, reach);
                }
    random_free(stream);
    draw_order(&cores, seed);
    cores_index(&cores);
    return cores;
}

struct cores cores_random(enum core_shape shape, double density, double margin,
                          const double size[3], long seed)
{
    double expected = density;
    for (int axis = 0; axis < 3; axis++) expected *= size[axis] + 2 * margin;
    if (!(expected < 1e8)) die_user("%g random cores are more than 1e8", expected);
    int64_t count = (int64_t)llround(fmax(expected, 1));
    struct cores cores = cores_new(shape, cbrt(1 / density), size, count);
    struct random_stream *stream = random_new(seed, "positions");
    for (; cores.count < count; cores.count++)
        for (int axis = 0; axis < 3; axis++)
            cores.centre[cores.count][axis] =
                (random_uniform(stream) - 0.5) * (size[axis] + 2 * margin);
    random_free(stream);
    draw_order(&cores, seed);
    cores_index(&cores);
    return cores;
}

void cores_free(struct cores *cores)
{
    free(cores->centre);
    free(cores->order);
    free(cores->first);
    free(cores->member);
    *cores = (struct cores){0};
}
