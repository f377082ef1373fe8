/* correspondence.c - non-ordinary state-based peridynamics: a classical law at every node.
 *
 *   H_i = [sum_j w V (u_j - u_i) (x) xi] K_i^-1,  F_i = 1 + H_i                  (correspondence.1)
 *   f_i = sum_j w V (Q_i + Q_j) xi,  Q = S K^-1,  S = P(F) + stabilisation       (correspondence.2)
 *
 * Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, section 18; total Lagrangian.
 * The shape tensor normalises families cut by a surface, so an affine motion gives its exact
 * gradient there too, without any surface correction.  Broken bonds are left out of H, K and f; a
 * node that has lost its deformation gradient carries no stress and keeps its plastic state.
 *
 * Any law of a point serves, at the price of motions that every gradient misses (zero-energy
 * modes), which a stabilisation controls.  Gradient, law and division by K read and write the
 * fields of the same nodes, so they go through the body in one walk, plane by plane, while the
 * caches still hold what a plane needs; the divergence, which waits for the neighbours, comes after
 * it.  S K^-1 is put in the place of S, since each neighbour reads Q and nobody S again. */
#include "broken.h"
#include "die.h"
#include "family_sums.h"
#include "gradient.h"
#include "integrity.h"
#include "memory.h"
#include "model.h"
#include "points.h"
#include "scattered.h"
#include "stabilisation.h"

#include <stdlib.h>
#include <string.h>

/* One strip of the walk over the body: nodes, or bonds along one offset by their lower ends.  The
 * walk goes plane by plane, the nodes of a plane before the bonds that reach it from below, so that
 * a node writes its stress first and its bonds add to it; the global order fixes the order of every
 * node's sums. */
struct task {
    struct strip strip;
    int key[4]; /* the order: step of the walk, bonds after nodes, global y, bond offset */
    int kind;   /* -1: nodes; otherwise the number of the bond offset */
};

struct correspondence {
    const struct materials *materials;
    const struct stabilisation *stabilisation;
    void *self; /* the stabilisation's parameters and state */
    double node_share;
    bool near_nodes;
    const struct strips *nodes; /* body->owned or body->near */
    int64_t n_tasks, n_sites;
    struct task *tasks;
    struct point_store *points; /* of the nodes */
    double *flow;               /* [n_sites] flow stress, where the stabilisation wants it */
    double *nominal; /* [n_sites] axial stress, share of the bonds included, at the last record */
};

static int compare_tasks(const void *a, const void *b)
{
    const struct task *s = a, *t = b;
    for (int k = 0; k < 4; k++)
        if (s->key[k] != t->key[k]) return s->key[k] < t->key[k] ? -1 : 1;
    return (s->strip.x > t->strip.x) - (s->strip.x < t->strip.x);
}

static void append_tasks(struct correspondence *model, const struct grid *grid,
                         const struct strips *strips, int kind)
{
    for (int64_t s = 0; s < strips->count; s++) {
        int at[3];
        grid_position(grid, strips->items[s].site, at);
        const int bond = kind >= 0;
        model->tasks = memory_grow(model->tasks, model->n_tasks, sizeof *model->tasks);
        model->tasks[model->n_tasks++] =
            (struct task){strips->items[s], {at[2] + bond, bond, at[1], kind}, kind};
    }
}

static void list_tasks(struct correspondence *model, const struct body *body)
{
    const struct offset *bonds;
    int count = model->stabilisation->bonds(model->self, body->family, &bonds);
    struct strips *strips = memory_new((size_t)count, sizeof *strips);
    append_tasks(model, &body->grid, model->nodes, -1);
    for (int o = 0; o < count; o++) {
        strips[o] = grid_bond_strips(&body->grid, bonds[o].step, LANES);
        append_tasks(model, &body->grid, &strips[o], o);
    }
    qsort(model->tasks, (size_t)model->n_tasks, sizeof *model->tasks, compare_tasks);
    model->stabilisation->start(model->self, body, model->materials, strips, model->nominal);
    for (int o = 0; o < count; o++) strips_free(&strips[o]);
    free(strips);
}

static void *correspondence_read(struct deck_node solver, const struct family *family,
                                 const struct materials *materials)
{
    struct correspondence *model = memory_new(1, sizeof *model);
    model->materials = materials;
    model->stabilisation =
        stabilisation_read(deck_find(solver, "stabilisation"), family->scattered, &model->self);
    return model;
}

static int correspondence_near(const void *self, const struct family *family,
                               const struct offset **offsets)
{
    const struct correspondence *model = self;
    return model->stabilisation->bonds(model->self, family, offsets);
}

static void correspondence_visit(void *self, const struct body *body, struct checkpoint *checkpoint)
{
    struct correspondence *model = self;
    points_visit(model->points, checkpoint, "nodes", model->nodes);
    model->stabilisation->visit(model->self, body, checkpoint);
}

static void correspondence_free(void *self)
{
    struct correspondence *model = self;
    model->stabilisation->free(model->self);
    free(model->tasks);
    points_free(model->points);
    free(model->flow);
    free(model->nominal);
    free(model);
}

static const double *correspondence_state(const void *self, const struct strip *strip, int number,
                                          int component, double *buffer)
{
    return points_state(((const struct correspondence *)self)->points, strip, number, component,
                        buffer);
}

static void load_nodes(const struct correspondence *model, const struct body *body,
                       const struct strip *strip, struct points *points)
{
    points_load(model->points, strip, points);
    for (int k = 0; k < TENSOR; k++)
        memcpy(points->H[k], body->H[k] + strip->site, (size_t)strip->count * sizeof(double));
    for (int i = 0; body->broken && i < strip->count; i++)
        if (broken_lost(body->broken, strip->site + i)) points_switch_off(points, i);
}

static void correspondence_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct correspondence *model = self;
    (void)bonds;
    if (lattice_is_scattered(body->lattice) && !model->stabilisation->add_family)
        die_user("the stabilisation '%s' needs particles on a lattice: take 'capped'",
                 model->stabilisation->words.name);
    model->n_sites = body->grid.n_sites;
    model->nominal = memory_new((size_t)model->n_sites, sizeof *model->nominal);
    model->node_share =
        model->stabilisation->node_share ? model->stabilisation->node_share(model->self) : 1;
    model->near_nodes = model->stabilisation->add_family != NULL;
    model->nodes = model->near_nodes ? &body->near : &body->owned;
    model->points = points_new(body, model->materials, model->nodes, 0);
    if (model->near_nodes) {
        model->flow = memory_new((size_t)model->n_sites, sizeof(double));
        model->stabilisation->start(model->self, body, model->materials, NULL, model->nominal);
    } else {
        list_tasks(model, body);
    }
}

static void correspondence_observe(void *self, const struct body *body, const struct strip *strip,
                                   struct node_state *node)
{
    struct correspondence *model = self;
    struct points points;
    load_nodes(model, body, strip, &points);
    points_observe(model->points, body, strip, &points, model->nominal, node);
}

HS_SIMD static void write_scaled(int count, const double *restrict P, double weight,
                                 double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] = weight * P[i];
}

static void node_law(struct correspondence *model, struct body *body, const struct strip *strip,
                     struct force_mode mode, struct force_energy *energy)
{
    const int64_t site = strip->site;
    struct points points;
    load_nodes(model, body, strip, &points);
    points_update(model->points, strip, &points, mode,
                  integrity_of_nodes(body, site, strip->count));
    const size_t bytes = (size_t)strip->count * sizeof(double);
    for (int k = 0; k < TENSOR; k++)
        write_scaled(strip->count, points.P[k], model->node_share, body->S[k] + site);
    for (int k = 0; k < 3; k++) memset(body->f[k] + site, 0, bytes);
    if (mode.record) memcpy(model->nominal + site, body->S[4 * body->lattice->axis] + site, bytes);
    if (model->flow) {
        double buffer[LANES];
        memcpy(model->flow + site, points_flow_stress(model->points, strip, buffer), bytes);
    }
    if (!mode.energy) return;
    body_times_volume(body, site, strip->count, points.stored);
    body_times_volume(body, site, strip->count, points.dissipated);
    body_sum_owned(body, site, strip->count, points.stored, model->node_share, &energy->stored);
    body_sum_owned(body, site, strip->count, points.dissipated, model->node_share,
                   &energy->plastic);
}

/* Ghost ends of bonds gather sums that nobody reads; they must not grow. */
static void clear_ghosts(struct body *body)
{
    if (lattice_is_scattered(body->lattice)) { /* whose bonds reach beyond near sites */
        body_clear(body, body->S, 9);
        body_clear(body, body->f, 3);
        return;
    }
    for (int64_t s = 0; s < body->ghosts.count; s++) {
        const struct strip *strip = &body->ghosts.items[s];
        const size_t bytes = (size_t)strip->count * sizeof(double);
        for (int k = 0; k < 9; k++) memset(body->S[k] + strip->site, 0, bytes);
        for (int k = 0; k < 3; k++) memset(body->f[k] + strip->site, 0, bytes);
    }
}

/* S becomes S K^-1, in place, row by row. */
HS_SIMD static void divide_row(int count, const double *restrict xx, const double *restrict yy,
                               const double *restrict zz, const double *restrict xy,
                               const double *restrict yz, const double *restrict zx,
                               double inverse_spacing, double *restrict sx, double *restrict sy,
                               double *restrict sz)
{
    for (int i = 0; i < count; i++) {
        double x = sx[i] * inverse_spacing, y = sy[i] * inverse_spacing,
               z = sz[i] * inverse_spacing;
        sx[i] = x * xx[i] + y * xy[i] + z * zx[i];
        sy[i] = x * xy[i] + y * yy[i] + z * yz[i];
        sz[i] = x * zx[i] + y * yz[i] + z * zz[i];
    }
}

/* (macroscopic.2): H of every node grows with the mean gradient. */
static void sum_stress(const struct body *body, const struct strip *strip)
{
    for (int k = 0; k < TENSOR; k++) {
        double terms[LANES];
        memcpy(terms, body->S[k] + strip->site, (size_t)strip->count * sizeof *terms);
        body_times_volume(body, strip->site, strip->count, terms);
        exact_sum_add_strip(&body->stress_sums[k], strip->count, terms, 1);
    }
}

/* Of owned strips first to end - 1. */
static void divide_by_shape(struct body *body, int64_t first, int64_t end)
{
    double *const *K = body->inverse, *const *S = body->S;
    for (int64_t n = first; n < end; n++) {
        const int64_t i = body->owned.items[n].site;
        if (body->broken) broken_keep_stress(body, i, body->owned.items[n].count);
        if (body->stress_sums) sum_stress(body, &body->owned.items[n]);
        for (int a = 0; a < 9; a += 3)
            divide_row(body->owned.items[n].count, K[0] + i, K[1] + i, K[2] + i, K[3] + i, K[4] + i,
                       K[5] + i, 1 / body->lattice->spacing, S[a] + i, S[a + 1] + i, S[a + 2] + i);
    }
}

/* The first strip, from first on, beyond a plane: one of global z. */
static int64_t strips_below(const struct strips *strips, const struct grid *grid, int64_t first,
                            int plane)
{
    const int64_t limit = (plane + 1 - grid->origin[2]) * grid->step[2];
    while (first < strips->count && strips->items[first].site < limit) first++;
    return first;
}

static void do_task(struct correspondence *model, struct body *body, const struct task *task,
                    struct force_mode mode, struct force_energy *energy)
{
    if (task->kind < 0)
        node_law(model, body, &task->strip, mode, energy);
    else
        model->stabilisation->add(model->self, body, task->kind, &task->strip, mode, energy);
}

/* Gradients, laws and Q of nodes and of bonds to the nearest neighbours, in one walk through the
 * planes: what a plane needs is still in the caches. */
static void walk(struct correspondence *model, struct body *body, struct force_mode mode,
                 struct force_energy *energy)
{
    int64_t gradients = 0, divided = 0;
    if (body->broken) displacement_gradient(body);
    for (int64_t t = 0; t < model->n_tasks;) {
        const int plane = model->tasks[t].key[0];
        if (!body->broken) {
            const int64_t end = strips_below(&body->near, &body->grid, gradients, plane);
            displacement_gradient_strips(body, gradients, end);
            gradients = end;
        }
        for (; t < model->n_tasks && model->tasks[t].key[0] == plane; t++)
            do_task(model, body, &model->tasks[t], mode, energy);
        /* The bonds from this plane on are still to come. */
        const int64_t end = strips_below(&body->owned, &body->grid, divided, plane - 1);
        divide_by_shape(body, divided, end);
        divided = end;
    }
    divide_by_shape(body, divided, body->owned.count);
}

/* Gradients, laws and Q where bonds of the stabilisation reach farther, or are listed: the flow
 * stress of both ends must be known before their bond. */
static void near_nodes_first(struct correspondence *model, struct body *body,
                             struct force_mode mode, struct force_energy *energy)
{
    displacement_gradient(body);
    for (int64_t s = 0; s < body->near.count; s++)
        node_law(model, body, &body->near.items[s], mode, energy);
    for (int64_t s = 0; s < body->bonds->count; s++)
        model->stabilisation->add_family(model->self, body, &body->bonds->strips[s], model->flow,
                                         mode, energy);
    divide_by_shape(body, 0, body->owned.count);
}

/* f += sum_b Q_b s_b + G, G the sum over the family */
HS_SIMD static void add_divergence(int count, const double *restrict qx, const double *restrict qy,
                                   const double *restrict qz, const double *restrict sx,
                                   const double *restrict sy, const double *restrict sz,
                                   const double *restrict G, double *restrict f)
{
    for (int i = 0; i < count; i++) f[i] += qx[i] * sx[i] + qy[i] * sy[i] + qz[i] * sz[i] + G[i];
}

/* The sum over the family of nodes with broken bonds. */
static void broken_divergence(const struct body *body, int64_t site, int count, double *const Q[3],
                              double *G)
{
    double sums[3][LANES];
    if (!body->broken) return;
    for (int b = 0; b < 3; b++) broken_sums(body, site, count, Q[b], b, sums[b]);
    for (int i = 0; i < count; i++)
        if (body->broken->touched[site + i]) G[i] = sums[0][i] + sums[1][i] + sums[2][i];
}

static void divergence(struct body *body)
{
    if (lattice_is_scattered(body->lattice)) {
        scattered_divergence(body);
        return;
    }
    double *const *s = body->first;
    for (int64_t n = 0; n < body->owned.count; n++) {
        const int count = body->owned.items[n].count;
        const int64_t i = body->owned.items[n].site;
        for (int a = 0; a < 3; a++) {
            double G[LANES] = {0};
            double *const *Q = body->Q + 3 * a;
            for (int b = 0; b < 3; b++)
                family_sums_add(body->family, &body->grid, b, count, Q[b] + i, G);
            broken_divergence(body, i, count, Q, G);
            add_divergence(count, Q[0] + i, Q[1] + i, Q[2] + i, s[0] + i, s[1] + i, s[2] + i, G,
                           body->f[a] + i);
        }
    }
}

static void correspondence_force(void *self, struct body *body, struct force_mode mode,
                                 struct force_energy *energy)
{
    struct correspondence *model = self;
    halo_exchange(body->displacement_halo, body->u, 3);
    clear_ghosts(body);
    (model->near_nodes ? near_nodes_first : walk)(model, body, mode, energy);
    halo_exchange(body->stress_halo, body->Q, 9);
    divergence(body);
}

static const struct strips *correspondence_strips(const void *self, const struct body *body)
{
    (void)body;
    return ((const struct correspondence *)self)->nodes;
}

const struct formulation formulation_correspondence = {
    .name = "correspondence",
    .stress_of = STRESS_OF_NODES,
    .influence = "constant",
    .horizon = 1,
    .scattered = 1.8,
    .keys = (const char *const[]){"stabilisation", NULL},
    .read = correspondence_read,
    .near = correspondence_near,
    .start = correspondence_start,
    .force = correspondence_force,
    .observe = correspondence_observe,
    .strips = correspondence_strips,
    .state = correspondence_state,
    .visit = correspondence_visit,
    .free = correspondence_free,
};
