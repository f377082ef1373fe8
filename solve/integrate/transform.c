#include "transform.h"

#include "collection.h"
#include "memory.h"
#include "pins.h"
#include "waves.h"

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
    int each;       /* places of a node: 1, of a mesh 8 */
    int64_t *place; /* [each n_nodes] in the box, or -1 */
    bool *free;     /* [n_nodes] else held */
    struct pins pins;
    float *weight;  /* [each n_nodes] of a mesh; NULL: 1 */
    double *all;    /* [n_nodes] as the ranks have them, one rank behind the other */
    int64_t *
        order; /* [n_nodes] of a row, where places are shared: which of them is at a site; else NULL */
};

struct transform {
    const struct unknowns *unknowns;
    struct collection *collection;
    int root[3];
    bool crowded;
    double filled;
    struct box box[3];
};

/* Place of a site in the lattice; of scattered particles the nearest in one of their mean distance, of a mesh's node where
 * it lies in such a one. */
static void find_position(const struct lattice *lattice, int64_t site, double at[3])
{
    int place[3];
    lattice_position(lattice, site, place);
    for (int b = 0; b < 3; b++) {
        at[b] = place[b];
        if (!lattice_is_row(lattice)) continue;
        at[b] = (lattice->point[b][site] - lattice->origin[b]) / lattice->spacing;
        if (!lattice->hexahedron) at[b] = floor(at[b] + 0.5);
    }
}

/* Free nodes between places count for those on either side, but for what lies where the body is held. */
static void find_box(struct box *box, const struct lattice *lattice, const int64_t *sites,
                     int64_t n, const double *free)
{
    static const double slack = 1e-6; /* spacings, of places of a mesh */
    double low[3], high[3], body_low[3], body_high[3];
    for (int b = 0; b < 3; b++) {
        low[b] = body_low[b] = INFINITY;
        high[b] = body_high[b] = -INFINITY;
    }
    for (int64_t i = 0; i < n; i++) {
        double at[3];
        find_position(lattice, sites[i], at);
        for (int b = 0; b < 3; b++) {
            body_low[b] = fmin(body_low[b], at[b]);
            body_high[b] = fmax(body_high[b], at[b]);
            if (!(free[i] > 0)) continue;
            low[b] = fmin(low[b], at[b]);
            high[b] = fmax(high[b], at[b]);
        }
    }
    box->count = 1;
    box->corners = lattice->corner != NULL;
    box->dimensions = lattice->dimensions;
    for (int b = 0; b < 3; b++) {
        box->held[b][0] = body_low[b] < low[b] - slack;
        box->held[b][1] = body_high[b] > high[b] + slack;
        box->size[b] = 0;
        if (low[b] <= high[b]) {
            box->low[b] = (int)(box->held[b][0] ? ceil(low[b] - slack) : floor(low[b] + slack));
            const int last =
                (int)(box->held[b][1] ? floor(high[b] + slack) : ceil(high[b] - slack));
            box->size[b] = last >= box->low[b] ? last - box->low[b] + 1 : 0;
        }
        box->count *= box->size[b];
    }
}

/* Place in the box; -1 outside of it. */
static int64_t place_in(const struct box *box, const int at[3])
{
    int64_t place = 0;
    for (int b = 2; b >= 0; b--) {
        const int step = at[b] - box->low[b];
        if (step < 0 || step >= box->size[b]) return -1;
        place = place * box->size[b] + step;
    }
    return place;
}

/* The places around each node of a mesh, with the weights of linear interpolation. */
static void find_places_around(struct box *box, const struct lattice *lattice, const int64_t *sites,
                               int64_t n)
{
    box->each = 8;
    box->place = memory_new(8 * (size_t)n, sizeof *box->place);
    box->weight = memory_new(8 * (size_t)n, sizeof *box->weight);
    for (int64_t i = 0; i < n; i++) {
        double at[3];
        find_position(lattice, sites[i], at);
        for (int k = 0; k < 8; k++) {
            int place[3];
            double weight = 1;
            for (int b = 0; b < 3; b++) {
                const double below = floor(at[b]), share = at[b] - below;
                place[b] = (int)below + (k >> b & 1);
                weight *= k >> b & 1 ? share : 1 - share;
            }
            box->place[8 * i + k] = weight > 0 ? place_in(box, place) : -1;
            box->weight[8 * i + k] = (float)weight;
        }
    }
}

/* Whether two nodes have one place. */
static bool find_places(struct box *box, const struct lattice *lattice, const int64_t *sites,
                        int64_t n)
{
    bool *taken = memory_new((size_t)box->count + 1, sizeof *taken), crowded = false;
    box->each = 1;
    box->place = memory_new((size_t)n, sizeof *box->place);
    for (int64_t i = 0; i < n; i++) {
        double at[3];
        find_position(lattice, sites[i], at);
        const int64_t place = place_in(box, (const int[]){(int)at[0], (int)at[1], (int)at[2]});
        box->place[i] = place;
        if (!box->free[i]) continue;
        crowded |= taken[place];
        taken[place] = true;
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
        /* Across the one layer of a plane there are no corners, and those of a mesh that is flatter than the lattice
         * they are put on fall into one. */
        const bool corners =
            box->corners && b < box->dimensions && (n > 1 || box->held[b][0] || box->held[b][1]);
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

/* Nodes that are held within the box. */
static void find_pins(struct box *box, int64_t n)
{
    int64_t *candidates = memory_new((size_t)n, sizeof *candidates), count = 0;
    for (int64_t i = 0; i < n; i++) {
        bool within = !box->free[i];
        for (int64_t k = box->each * i; k < box->each * (i + 1); k++)
            within = within && (box->place[k] >= 0 || (box->weight && !(box->weight[k] > 0)));
        if (within) candidates[count++] = i;
    }
    box->pins = pins_new(candidates, count);
    free(candidates);
}

/* Nodes of a mesh stand for more or fewer sites than one. */
static double filled_share(const struct box *box, const struct lattice *lattice,
                           const double *free_nodes, int64_t n)
{
    const double ratio = lattice->hexahedron ? (double)lattice->n_particles / (double)n : 1;
    double count = 0;
    for (int64_t i = 0; i < n; i++) count += free_nodes[i] > 0;
    return ratio * count / (double)box->count;
}

static int64_t *order_of(const int64_t *sites, int64_t n)
{
    int64_t *order = memory_new((size_t)n, sizeof *order);
    for (int64_t i = 0; i < n; i++) order[sites[i]] = i;
    return order;
}

static int64_t outer_of(const struct box *box, int axis)
{
    int64_t outer = 1;
    for (int b = axis + 1; b < 3; b++) outer *= box->size[b];
    return outer;
}

/* Adds what one node has, to its places, and what the places have for it. */
static void put_node(const struct box *box, int64_t i, float value, float *values)
{
    for (int64_t k = box->each * i; k < box->each * (i + 1); k++)
        if (box->place[k] >= 0)
            values[box->place[k]] += (box->weight ? box->weight[k] : 1) * value;
}

static double take_node(const struct box *box, int64_t i, const float *values)
{
    double sum = 0;
    for (int64_t k = box->each * i; k < box->each * (i + 1); k++)
        if (box->place[k] >= 0) sum += (box->weight ? box->weight[k] : 1) * values[box->place[k]];
    return sum;
}

/* Values of the free nodes to the box.  Those that share a place are summed in the order of their sites. */
static void put_in(const struct box *box, int64_t n, float *values)
{
    memset(values, 0, (size_t)box->count * sizeof *values);
    for (int64_t site = 0; site < n; site++) {
        const int64_t i = box->order ? box->order[site] : site;
        if (box->free[i]) put_node(box, i, (float)box->all[i], values);
    }
}

/* M^-1 of box->values; where the result is. */
static const float *apply(const struct box *box)
{
    float *values = box->values, *room = box->room;
    for (int step = 0; step < 6; step++) {
        const int b = step < 3 ? step : 5 - step;
        float *result = waves_transform(box->waves[b], step >= 3, outer_of(box, b), values, room);
        room = result == values ? room : values;
        values = result;
        for (int64_t i = 0; step == 2 && i < box->count; i++) values[i] *= box->inverse[i];
    }
    return values;
}

static void fill_pins(struct box *box)
{
    struct pins *pins = &box->pins;
    for (int j = 0; j < pins->count; j++) {
        memset(box->values, 0, (size_t)box->count * sizeof *box->values);
        put_node(box, pins->node[j], 1, box->values);
        const float *values = apply(box);
        for (int i = j; i < pins->count; i++)
            pins->factor[i * pins->count + j] = take_node(box, pins->node[i], values);
    }
    pins_factorise(pins);
}

/* box->all becomes M^-1 of itself (pins.1). */
static void invert(struct box *box, int64_t n)
{
    struct pins *pins = &box->pins;
    if (box->count == 0) {
        memset(box->all, 0, (size_t)n * sizeof *box->all);
        return;
    }
    put_in(box, n, box->values);
    const float *values = apply(box);
    if (pins->count > 0) {
        for (int k = 0; k < pins->count; k++)
            pins->force[k] = take_node(box, pins->node[k], values);
        pins_solve(pins);
        put_in(box, n, box->values);
        for (int k = 0; k < pins->count; k++)
            put_node(box, pins->node[k], (float)-pins->force[k], box->values);
        values = apply(box);
    }
    for (int64_t i = 0; i < n; i++) box->all[i] = box->free[i] ? take_node(box, i, values) : 0;
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
    double filled = 1;
    for (int a = 0; a < 3; a++) {
        struct box *box = &transform->box[a];
        double *free_nodes = memory_new(nodes, sizeof *free_nodes);
        transform->root[a] = a % body->ranks.size;
        collection_gather(transform->collection, transform->root[a],
                          unknowns->free + a * unknowns->n_nodes, free_nodes);
        if (body->ranks.rank == transform->root[a]) {
            find_box(box, body->lattice, sites, body->n_nodes, free_nodes);
            box->free = memory_new(nodes, sizeof *box->free);
            for (size_t i = 0; i < nodes; i++) box->free[i] = free_nodes[i] > 0;
            crowded |= body->lattice->hexahedron != NULL;
            if (body->lattice->hexahedron)
                find_places_around(box, body->lattice, sites, body->n_nodes);
            else
                crowded |= find_places(box, body->lattice, sites, body->n_nodes);
            box->all = memory_new(nodes, sizeof *box->all);
            if (lattice_is_row(body->lattice)) box->order = order_of(sites, body->n_nodes);
            if (box->count > 0) {
                filled = fmin(filled, filled_share(box, body->lattice, free_nodes, body->n_nodes));
                find_inverse(box, symbol, a);
                find_pins(box, body->n_nodes);
                fill_pins(box);
            }
        }
        free(free_nodes);
    }
    double least[] = {crowded ? -1 : 0, filled};
    ranks_minimum(least, 2);
    transform->crowded = least[0] < 0;
    transform->filled = least[1];
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
        free(box->free);
        pins_free(&box->pins);
        free(box->weight);
        free(box->order);
        free(box->all);
    }
    collection_free(transform->collection);
    free(transform);
}

double transform_filled(const struct transform *transform)
{
    return transform->filled;
}

bool transform_is_crowded(const struct transform *transform)
{
    return transform->crowded;
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
