#include "transform.h"

#include "collection.h"
#include "memory.h"

#include <fftw3.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The box around the free components along one axis, on the rank whose work it is. */
struct box {
    int dimensions, low[3], size[3];
    bool corners;
    bool held[3][2]; /* whether there is something of the body below, above */
    int64_t count;
    double *values, *inverse; /* [count]; FFTW's scale is in the inverse */
    fftw_plan forward, backward;
    int64_t *place; /* [n_nodes] in the box, or -1 */
    double *weight; /* [n_nodes] of corners; NULL: 1 */
    double *all;    /* [n_nodes] */
};

struct transform {
    const struct unknowns *unknowns;
    struct collection *collection;
    int root[3];
    bool crowded;
    struct box box[3];
};

/* Place of a site in the lattice, of scattered particles in one of their mean distance. */
static void find_position(const struct lattice *lattice, int64_t site, int at[3])
{
    lattice_position(lattice, site, at);
    if (!lattice_is_scattered(lattice)) return;
    for (int b = 0; b < 3; b++)
        at[b] = (int)floor((lattice->point[b][site] - lattice->origin[b]) / lattice->spacing + 0.5);
}

static void find_box(struct box *box, const struct lattice *lattice, const int64_t *sites,
                     int64_t n, const double *free)
{
    int high[3] = {-1, -1, -1}, body_low[3], body_high[3] = {-1, -1, -1};
    for (int b = 0; b < 3; b++) box->low[b] = body_low[b] = INT_MAX;
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        find_position(lattice, sites[i], at);
        for (int b = 0; b < 3; b++) {
            body_low[b] = at[b] < body_low[b] ? at[b] : body_low[b];
            body_high[b] = at[b] > body_high[b] ? at[b] : body_high[b];
            if (!(free[i] > 0)) continue;
            box->low[b] = at[b] < box->low[b] ? at[b] : box->low[b];
            high[b] = at[b] > high[b] ? at[b] : high[b];
        }
    }
    box->count = 1;
    box->corners = lattice->corner != NULL;
    box->dimensions = lattice->dimensions;
    for (int b = 0; b < 3; b++) {
        box->size[b] = high[b] >= box->low[b] ? high[b] - box->low[b] + 1 : 0;
        box->held[b][0] = body_low[b] < box->low[b];
        box->held[b][1] = body_high[b] > high[b];
        box->count *= box->size[b];
    }
}

/* 1 over the share of a whole corner's volume that the waves give to a place: a half at each free end. */
static double weight_at(const struct box *box, const int at[3])
{
    double weight = 1;
    for (int b = 0; b < box->dimensions; b++)
        if ((at[b] == 0 && !box->held[b][0]) || (at[b] == box->size[b] - 1 && !box->held[b][1]))
            weight *= 2;
    return weight;
}

/* Whether two nodes have one place. */
static bool find_places(struct box *box, const struct lattice *lattice, const int64_t *sites,
                        int64_t n, const double *free_nodes)
{
    bool *taken = memory_new((size_t)box->count + 1, sizeof *taken), crowded = false;
    box->place = memory_new((size_t)n, sizeof *box->place);
    if (box->corners) box->weight = memory_new((size_t)n, sizeof *box->weight);
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        find_position(lattice, sites[i], at);
        for (int b = 0; b < 3; b++) at[b] -= box->low[b];
        box->place[i] = -1;
        if (!(free_nodes[i] > 0)) continue;
        const int64_t place = ((int64_t)at[2] * box->size[1] + at[1]) * box->size[0] + at[0];
        crowded |= taken[place];
        taken[place] = true;
        box->place[i] = place;
        if (box->corners) box->weight[i] = weight_at(box, at);
    }
    free(taken);
    return crowded;
}

/* Waves along one axis: FFTW's names for them, their wave numbers per site, and FFTW's scale. */
struct waves {
    fftw_r2r_kind forward, backward;
    double *k; /* [n] */
    double scale;
};

/* n: sites; period: those of half a period of the longest wave; shift: the first wave number, of pi/period. */
static struct waves waves_of(fftw_r2r_kind forward, fftw_r2r_kind backward, int n, int period,
                             double shift)
{
    struct waves waves = {forward, backward, memory_new((size_t)n, sizeof(double)), 2 * period};
    for (int i = 0; i < n; i++) waves.k[i] = M_PI * (i + shift) / period;
    return waves;
}

/* Ends half a spacing beyond the outermost nodes. */
static struct waves waves_of_particles(int n, bool low, bool high)
{
    if (low && high) return waves_of(FFTW_RODFT10, FFTW_RODFT01, n, n, 1);
    if (low) return waves_of(FFTW_RODFT11, FFTW_RODFT11, n, n, 0.5);
    if (high) return waves_of(FFTW_REDFT11, FFTW_REDFT11, n, n, 0.5);
    return waves_of(FFTW_REDFT10, FFTW_REDFT01, n, n, 0);
}

/* Free ends at the outermost nodes, which have half the volume of others, held ones a spacing beyond. */
static struct waves waves_of_corners(int n, bool low, bool high)
{
    if (low && high) return waves_of(FFTW_RODFT00, FFTW_RODFT00, n, n + 1, 1);
    if (low) return waves_of(FFTW_RODFT01, FFTW_RODFT10, n, n, 0.5);
    if (high) return waves_of(FFTW_REDFT01, FFTW_REDFT10, n, n, 0.5);
    return waves_of(FFTW_REDFT00, FFTW_REDFT00, n, n - 1, 0);
}

/* Across the one layer of a plane there are no corners. */
static struct waves waves_new(const struct box *box, int axis)
{
    const bool corners = box->corners && axis < box->dimensions;
    return (corners ? waves_of_corners : waves_of_particles)(box->size[axis], box->held[axis][0],
                                                             box->held[axis][1]);
}

static void find_inverse(struct box *box, const struct symbol *symbol, int a)
{
    fftw_r2r_kind forward[3], backward[3];
    double *k[3], scale = 1;
    for (int b = 0; b < 3; b++) {
        const struct waves waves = waves_new(box, b);
        forward[2 - b] = waves.forward;
        backward[2 - b] = waves.backward;
        k[b] = waves.k;
        scale *= waves.scale;
    }
    const int n[3] = {box->size[2], box->size[1], box->size[0]};
    box->values = fftw_alloc_real((size_t)box->count);
    box->inverse = fftw_alloc_real((size_t)box->count);
    symbol_evaluate(symbol, a, box->size, k, box->inverse);
    /* Motions of the whole body, and across a layer, have no stiffness of their own. */
    const double own = symbol->answer[a][0], least = own > 0 ? 3e-6 * own : 1;
    for (int64_t i = 0; i < box->count; i++)
        box->inverse[i] = 1 / (scale * (fmax(box->inverse[i], 0) + least));
    /* Estimated plans are the same each time, measured ones are not. */
    box->forward = fftw_plan_r2r(3, n, box->values, box->values, forward, FFTW_ESTIMATE);
    box->backward = fftw_plan_r2r(3, n, box->values, box->values, backward, FFTW_ESTIMATE);
    for (int b = 0; b < 3; b++) free(k[b]);
}

struct transform *transform_new(const struct unknowns *unknowns, const struct symbol *symbol)
{
    struct transform *transform = memory_new(1, sizeof *transform);
    const struct body *body = unknowns->body;
    const size_t nodes = (size_t)body->n_nodes;
    transform->unknowns = unknowns;
    transform->collection = collection_new(body);
    const int64_t *sites = collection_sites(transform->collection);
    bool crowded = false;
    for (int a = 0; a < 3; a++) {
        struct box *box = &transform->box[a];
        double *free_nodes = memory_new(nodes, sizeof *free_nodes);
        transform->root[a] = a % body->ranks.size;
        collection_gather(transform->collection, transform->root[a],
                          unknowns->free + a * unknowns->n_nodes, free_nodes);
        if (body->ranks.rank == transform->root[a]) {
            find_box(box, body->lattice, sites, body->n_nodes, free_nodes);
            crowded |= find_places(box, body->lattice, sites, body->n_nodes, free_nodes);
            box->all = memory_new(nodes, sizeof *box->all);
            if (box->count > 0) find_inverse(box, symbol, a);
        }
        free(free_nodes);
    }
    double least = crowded ? -1 : 0;
    ranks_minimum(&least, 1);
    transform->crowded = least < 0;
    return transform;
}

void transform_free(struct transform *transform)
{
    for (int a = 0; a < 3; a++) {
        struct box *box = &transform->box[a];
        if (box->values) {
            fftw_destroy_plan(box->forward);
            fftw_destroy_plan(box->backward);
        }
        fftw_free(box->values);
        fftw_free(box->inverse);
        free(box->place);
        free(box->weight);
        free(box->all);
    }
    collection_free(transform->collection);
    free(transform);
}

bool transform_is_crowded(const struct transform *transform)
{
    return transform->crowded;
}

static void invert(struct box *box, int64_t n)
{
    if (box->count == 0) return;
    memset(box->values, 0, (size_t)box->count * sizeof *box->values);
    for (int64_t i = 0; i < n; i++)
        if (box->place[i] >= 0)
            box->values[box->place[i]] += (box->weight ? box->weight[i] : 1) * box->all[i];
    fftw_execute(box->forward);
    for (int64_t i = 0; i < box->count; i++) box->values[i] *= box->inverse[i];
    fftw_execute(box->backward);
    for (int64_t i = 0; i < n; i++)
        box->all[i] = box->place[i] >= 0 ? box->values[box->place[i]] : 0;
}

void transform_apply(struct transform *transform, const double *r, double *z)
{
    const struct unknowns *unknowns = transform->unknowns;
    const int64_t n = unknowns->n_nodes;
    for (int a = 0; a < 3; a++)
        collection_gather(transform->collection, transform->root[a], r + a * n,
                          transform->box[a].all);
    for (int a = 0; a < 3; a++)
        if (unknowns->body->ranks.rank == transform->root[a])
            invert(&transform->box[a], unknowns->body->n_nodes);
    for (int a = 0; a < 3; a++)
        collection_scatter(transform->collection, transform->root[a], transform->box[a].all,
                           z + a * n);
}
