#include "points.h"

#include "across.h"
#include "checkpoint.h"
#include "degradation.h"
#include "integrity.h"
#include "laws.h"
#include "memory.h"
#include "profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UNIT = 8 }; /* strides are multiples of it (grid.h) */

struct point_store {
    const struct body *body;
    const struct materials *materials;
    int64_t offset;
    double **state; /* of each law */
    /* [points / UNIT] by law: where its points of a strip begin in state, -1 where the strip has
     * none; NULL: all points obey one law. */
    int64_t **place;
    double *records; /* of degradation, strip by strip; NULL: none degrades */
    double *stretch; /* across a sheet in plane stress, strip by strip (across.h); else NULL */
};

/* The points of a strip that obey one law. */
struct part {
    int count, stride;
    double *state;
    const int *lanes; /* which of the strip; NULL: all */
};

static int pair_of(const struct point_store *store, int64_t site)
{
    const uint8_t *phase = store->body->grid.phase;
    return phase[site] * store->materials->count + phase[site + store->offset];
}

static int find_lanes(const struct point_store *store, const struct strip *strip, int law,
                      int lanes[LANES])
{
    int count = 0;
    for (int i = 0; i < strip->count; i++)
        if (store->materials->law_of[pair_of(store, strip->site + i)] == law) lanes[count++] = i;
    return count;
}

static int stride_of(int count)
{
    return (count + UNIT - 1) / UNIT * UNIT;
}

/* Whether the strip has points of the law, and where; lanes: room for the list. */
static bool find_part(const struct point_store *store, const struct strip *strip, int law,
                      struct part *part, int lanes[LANES])
{
    const int components = law_components(store->materials->laws[law].law);
    if (!store->place) {
        *part = (struct part){strip->count, strip->stride,
                              store->state[law] + components * strip->store, NULL};
        return true;
    }
    const int64_t place = store->place[law][strip->store / UNIT];
    if (place < 0) return false;
    const int count = find_lanes(store, strip, law, lanes);
    const bool all = count == strip->count;
    *part = (struct part){count, stride_of(count), store->state[law] + components * place,
                          all ? NULL : lanes};
    return true;
}

/* Where each law's points of each strip begin; fills how many numbers a component has. */
static void find_places(struct point_store *store, const struct strips *strips, int64_t points[])
{
    const int n_laws = store->materials->n_laws;
    const size_t units = (size_t)(strips->points / UNIT);
    int lanes[LANES];
    store->place = memory_new((size_t)n_laws, sizeof *store->place);
    for (int law = 0; law < n_laws; law++) {
        store->place[law] = memory_new(units, sizeof **store->place);
        for (int64_t s = 0; s < strips->count; s++) {
            const struct strip *strip = &strips->items[s];
            const int count = find_lanes(store, strip, law, lanes);
            store->place[law][strip->store / UNIT] = count ? points[law] : -1;
            points[law] += stride_of(count);
        }
    }
}

static void gather_inputs(const struct points *from, const struct part *part, struct points *to)
{
    to->count = part->count;
    for (int i = 0; i < part->count; i++) {
        const int lane = part->lanes[i];
        for (int k = 0; k < TENSOR; k++) to->H[k][i] = from->H[k][lane];
        to->mu[i] = from->mu[lane];
        to->bulk[i] = from->bulk[lane];
        to->pair[i] = from->pair[lane];
        to->shift[i] = from->shift[lane];
    }
}

static void scatter_outputs(const struct points *from, const struct part *part, bool energy,
                            struct points *to)
{
    to->flows |= from->flows;
    for (int i = 0; i < part->count; i++) {
        const int lane = part->lanes[i];
        for (int k = 0; k < TENSOR; k++) to->P[k][lane] = from->P[k][i];
        if (!energy) continue;
        to->stored[lane] = from->stored[i];
        to->dissipated[lane] = from->dissipated[i];
        to->dissipating[lane] = from->dissipating[i];
    }
}

static void start(struct point_store *store, const struct strips *strips)
{
    for (int64_t s = 0; s < strips->count; s++)
        for (int law = 0; law < store->materials->n_laws; law++) {
            int lanes[LANES];
            struct part part;
            struct points points = {0}, gathered;
            if (!find_part(store, &strips->items[s], law, &part, lanes)) continue;
            points_load(store, &strips->items[s], &points);
            if (part.lanes) gather_inputs(&points, &part, &gathered);
            const struct law_in_use *use = &store->materials->laws[law];
            law_start(use->law, use->pairs, part.lanes ? &gathered : &points, part.state,
                      part.stride);
        }
}

struct point_store *points_new(const struct body *body, const struct materials *materials,
                               const struct strips *strips, int64_t offset)
{
    struct point_store *store = memory_new(1, sizeof *store);
    const size_t n_laws = (size_t)materials->n_laws;
    int64_t *points = memory_new(n_laws, sizeof *points);
    *store = (struct point_store){.body = body, .materials = materials, .offset = offset};
    store->state = memory_new(n_laws, sizeof *store->state);
    points[0] = strips->points;
    if (n_laws > 1) {
        points[0] = 0;
        find_places(store, strips, points);
    }
    for (size_t law = 0; law < n_laws; law++)
        store->state[law] = memory_new(
            (size_t)(law_components(materials->laws[law].law) * points[law]), sizeof(double));
    free(points);
    start(store, strips);
    if (body->integrity) store->records = degradation_new(strips);
    if (materials->plane == PLANE_STRESS) {
        store->stretch = memory_new((size_t)strips->points, sizeof *store->stretch);
        for (int64_t i = 0; i < strips->points; i++) store->stretch[i] = 1;
    }
    return store;
}

void points_free(struct point_store *store)
{
    if (!store) return;
    for (int law = 0; law < store->materials->n_laws; law++) {
        free(store->state[law]);
        if (store->place) free(store->place[law]);
    }
    free(store->state);
    free(store->place);
    free(store->records);
    free(store->stretch);
    free(store);
}

HS_SIMD static void load(int count, const uint8_t *restrict a, const uint8_t *restrict b,
                         int64_t n_phases, const double *restrict shear,
                         const double *restrict bulk, struct points *restrict points)
{
    for (int i = 0; i < count; i++) {
        int64_t pair = a[i] * n_phases + b[i];
        points->mu[i] = shear[pair];
        points->bulk[i] = bulk[pair];
        points->pair[i] = pair;
    }
}

void points_load(const struct point_store *store, const struct strip *strip, struct points *points)
{
    const struct materials *materials = store->materials;
    const struct body *body = store->body;
    const uint8_t *phase = body->grid.phase + strip->site;
    points->count = strip->count;
    load(strip->count, phase, phase + store->offset, materials->count, materials->shear,
         materials->bulk, points);
    const double *shift = body->yield_shift ? body->yield_shift + strip->site : NULL;
    for (int i = 0; i < strip->count; i++)
        points->shift[i] = shift ? 0.5 * (shift[i] + shift[i + store->offset]) : 0;
}

static void update_part(const struct law_in_use *use, const struct part *part,
                        struct points *points, struct step step)
{
    struct points gathered;
    gather_inputs(points, part, &gathered);
    use->law->update(use->pairs, &gathered, part->state, part->stride, step);
    scatter_outputs(&gathered, part, step.energy, points);
}

static void ask_laws(struct point_store *store, const struct strip *strip, struct points *points,
                     struct step step)
{
    points->flows = false;
    for (int law = 0; law < store->materials->n_laws; law++) {
        const struct law_in_use *use = &store->materials->laws[law];
        int lanes[LANES];
        struct part part;
        if (!find_part(store, strip, law, &part, lanes)) continue;
        /* That of the next strip lies behind. */
        const size_t length = (size_t)(law_components(use->law) * part.stride);
        prefetch(part.state + length, length * sizeof *part.state);
        if (part.lanes)
            update_part(use, &part, points, step);
        else
            use->law->update(use->pairs, points, part.state, part.stride, step);
    }
}

static void ask_in_plane_stress(struct point_store *store, const struct strip *strip,
                                struct points *points, struct step step)
{
    const struct step trial = {
        .dt = step.dt, .time = step.time, .frozen = step.frozen, .energy = false};
    double *kept = store->stretch + strip->store;
    struct across across;
    across_begin(&across, kept, points);
    do ask_laws(store, strip, points, trial);
    while (across_improve(&across, points));
    if (step.commit || step.energy) ask_laws(store, strip, points, step);
    if (step.commit) memcpy(kept, across.stretch, (size_t)strip->count * sizeof *kept);
}

void points_update(struct point_store *store, const struct strip *strip, struct points *points,
                   struct force_mode mode, const double *integrity)
{
    const struct step step = {mode.dt, mode.time, mode.commit, mode.frozen,
                              mode.energy || integrity};
    (store->stretch ? ask_in_plane_stress : ask_laws)(store, strip, points, step);
    if (integrity)
        degradation_apply(points, mode.commit, integrity,
                          store->records + DEGRADATION * strip->store, strip->stride);
    if (!mode.frozen) profile_count(store->body->profile, WORK_FLOW_STRIPS, points->flows, 1);
}

/* Component first[number] + component of each law, otherwise where it is -1. */
static const double *see(const struct point_store *store, const struct strip *strip, int number,
                         int component, double otherwise, double *buffer)
{
    for (int i = 0; i < strip->count; i++) buffer[i] = otherwise;
    for (int law = 0; law < store->materials->n_laws; law++) {
        const struct law_in_use *use = &store->materials->laws[law];
        const int first = number < 0 ? use->law->flow_stress : use->component[number];
        int lanes[LANES];
        struct part part;
        if (first < 0 || !find_part(store, strip, law, &part, lanes)) continue;
        const double *state = part.state + (first + component) * part.stride;
        if (!part.lanes) return state;
        for (int i = 0; i < part.count; i++) buffer[lanes[i]] = state[i];
    }
    return buffer;
}

const double *points_state(const struct point_store *store, const struct strip *strip, int number,
                           int component, double *buffer)
{
    return see(store, strip, number, component, state_initial(law_state(number), component),
               buffer);
}

void points_observe(struct point_store *store, const struct body *body, const struct strip *strip,
                    struct points *points, const double *nominal, struct node_state *node)
{
    const double *P[TENSOR];
    const size_t bytes = (size_t)strip->count * sizeof(double);
    points_update(store, strip, points, (struct force_mode){.frozen = true},
                  integrity_of_nodes(body, strip->site, strip->count));
    node->count = strip->count;
    for (int k = 0; k < TENSOR; k++) {
        memcpy(node->H[k], points->H[k], bytes);
        P[k] = points->P[k];
    }
    node_state_cauchy(node, P);
    memcpy(node->nominal, nominal + strip->site, bytes);
}

const double *points_flow_stress(const struct point_store *store, const struct strip *strip,
                                 double *buffer)
{
    return see(store, strip, -1, 0, INFINITY, buffer);
}

/* One state of one law, as a checkpoint walks over it. */
struct visited {
    struct point_store *store;
    const struct strips *strips;
    int law, first, components;
};

static bool place_state(void *owner, int64_t strip, int point, bool make, double *places[])
{
    const struct visited *visited = owner;
    int lanes[LANES];
    struct part part;
    (void)make;
    if (!find_part(visited->store, &visited->strips->items[strip], visited->law, &part, lanes))
        return false;
    int at = part.lanes ? 0 : point;
    while (part.lanes && at < part.count && part.lanes[at] != point) at++;
    if (at >= part.count) return false;
    for (int k = 0; k < visited->components; k++)
        places[k] = part.state + (visited->first + k) * part.stride + at;
    return true;
}

void points_visit(struct point_store *store, struct checkpoint *checkpoint, const char *what,
                  const struct strips *strips)
{
    struct visited visited = {.store = store, .strips = strips};
    for (visited.law = 0; visited.law < store->materials->n_laws; visited.law++) {
        const struct law *law = store->materials->laws[visited.law].law;
        visited.first = 0;
        for (int k = 0; k < law->n_states; k++, visited.first += visited.components) {
            visited.components = law->states[k].components;
            char *name = memory_print("%s: %s %s", what, law->words.name, law->states[k].name);
            checkpoint_points(checkpoint, name, strips, visited.components, place_state, &visited);
            free(name);
        }
    }
    char *name = memory_print("%s: degradation", what);
    checkpoint_strips(checkpoint, name, strips, DEGRADATION, store->records);
    free(name);
    name = memory_print("%s: stretch across", what);
    checkpoint_strips(checkpoint, name, strips, 1, store->stretch);
    free(name);
}
