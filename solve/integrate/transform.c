#include "transform.h"

#include "collection.h"
#include "memory.h"
#include "waves.h"

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
    float *values, *room, *inverse; /* [count] */
    struct waves *waves[3];
    int64_t *place; /* [n_nodes] in the box, or -1 */
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
    if (!lattice_is_row(lattice)) return;
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

/* Whether two nodes have one place. */
static bool find_places(struct box *box, const struct lattice *lattice, const int64_t *sites,
                        int64_t n, const double *free_nodes)
{
    bool *taken = memory_new((size_t)box->count + 1, sizeof *taken), crowded = false;
    box->place = memory_new((size_t)n, sizeof *box->place);
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
    }
    free(taken);
    return crowded;
}

static void find_inverse(struct box *box, const struct symbol *symbol, int a)
{
    double *k[3], *stiffness = memory_new((size_t)box->count, sizeof *stiffness);
    int64_t inner = 1;
    for (int b = 0; b < 3; b++) {
        const int n = box->size[b];
        /* Across the one layer of a plane there are no corners. */
        const bool corners = box->corners && b < box->dimensions;
        box->waves[b] = waves_new(n, inner, corners, box->held[b][0], box->held[b][1]);
        inner *= n;
        k[b] = memory_new((size_t)n, sizeof *k[b]);
        for (int i = 0; i < n; i++) k[b][i] = waves_number(box->waves[b], i);
    }
    box->values = memory_new((size_t)box->count, sizeof *box->values);
    box->room = memory_new((size_t)box->count, sizeof *box->room);
    box->inverse = memory_new((size_t)box->count, sizeof *box->inverse);
    symbol_evaluate(symbol, a, box->size, k, stiffness);
    /* Motions of the whole body, and across a layer, have no stiffness of their own. */
    const double own = symbol->answer[a][0], least = own > 0 ? 3e-6 * own : 1;
    for (int64_t i = 0; i < box->count; i++)
        box->inverse[i] = (float)(1 / (fmax(stiffness[i], 0) + least));
    for (int b = 0; b < 3; b++) free(k[b]);
    free(stiffness);
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
        for (int b = 0; b < 3; b++) waves_free(box->waves[b]);
        free(box->values);
        free(box->room);
        free(box->inverse);
        free(box->place);
        free(box->all);
    }
    collection_free(transform->collection);
    free(transform);
}

bool transform_is_crowded(const struct transform *transform)
{
    return transform->crowded;
}

static int64_t outer_of(const struct box *box, int axis)
{
    int64_t outer = 1;
    for (int b = axis + 1; b < 3; b++) outer *= box->size[b];
    return outer;
}

static void invert(struct box *box, int64_t n)
{
    float *values = box->values, *room = box->room;
    if (box->count == 0) return;
    memset(values, 0, (size_t)box->count * sizeof *values);
    for (int64_t i = 0; i < n; i++)
        if (box->place[i] >= 0) values[box->place[i]] += (float)box->all[i];
    for (int step = 0; step < 6; step++) {
        const int b = step < 3 ? step : 5 - step;
        float *result = waves_transform(box->waves[b], step >= 3, outer_of(box, b), values, room);
        room = result == values ? room : values;
        values = result;
        for (int64_t i = 0; step == 2 && i < box->count; i++) values[i] *= box->inverse[i];
    }
    for (int64_t i = 0; i < n; i++) box->all[i] = box->place[i] >= 0 ? values[box->place[i]] : 0;
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
