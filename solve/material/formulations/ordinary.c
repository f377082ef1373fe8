/* ordinary.c - the two passes over the bonds that all ordinary state-based materials share (ordinary.h).
 *
 * The force along a bond depends on the dilatations of its ends, and so on all their bonds: it takes two passes.  The first,
 * sum_up, gives each node its dilatation; then the law goes from node to node (elastic_nodes, or the plastic return in
 * ordinary_plastic.c) and leaves what the second, push, reads of a node, for which ranks exchange no more than that: the
 * pull of the dilatation alone until a node yields.  Both passes find the extension of a bond anew, so that an elastic bond
 * has no memory of its own.  Either takes one root and one division a bond, which set its pace.
 *
 * The kernels come in depths, each a loop of its own (bond_loop.h makes the variants by geometry and weight): without
 * the sum of squares, which energy and yield alone need; with e^p, which a line of bonds has once one of them has
 * yielded, two numbers a bond; with the growth of e^p, only in strips with a node that flows.  A node before yield
 * so costs what an elastic one does. */
#include "ordinary.h"

#include "bond_loop.h"
#include "bond_stress.h"
#include "box_fields.h"
#include "gradient.h"
#include "integrity.h"
#include "laws.h"
#include "memory.h"
#include "nominal.h"
#include "opening.h"
#include "profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct ordinary *read_any(struct deck_node solver, const struct materials *materials,
                                 const struct ordinary_law *law)
{
    struct ordinary *model = memory_new(1, sizeof *model);
    model->materials = materials;
    model->law = law;
    model->correction = surface_correction_read(solver);
    return model;
}

static void *ordinary_read(struct deck_node solver, const struct family *family,
                           const struct materials *materials)
{
    (void)family;
    return read_any(solver, materials, &ordinary_linear);
}

static void *madenci_oterkus_read(struct deck_node solver, const struct family *family,
                                  const struct materials *materials)
{
    if (family->influence != family_influence("inverse"))
        deck_error(
            deck_get(solver, "influence"),
            "the influence function of madenci_oterkus is 'inverse': leave it out, or take the "
            "model 'ordinary'");
    return read_any(solver, materials, &ordinary_madenci_oterkus);
}

/* How much a kernel does: sums of the first pass up to this one, and the second's forces without e^p, with it, and with
 * its growth.  Where there is no e^p, or no growth, all give the same bits. */
enum { ELASTIC, ENERGY, STORED, YIELDING };

/* Numbers of each bond: e^p of its ends, NULL where there is none, and what find_state and hold find of it. */
enum { SLIP_LOWER, SLIP_UPPER, EXTENSION, STATE_LOWER, STATE_UPPER, HELD = EXTENSION };

/* |xi| or 1 */
HS_INLINE double a_over_w(const struct bond_pass *p, struct bond b)
{
    return p->number > 0 ? p->number : b.length;
}

/* (ordinary.1) but for D, and the sum of (ordinary.2). */
HS_INLINE void sum_up(const struct bond_pass *p, int k, struct bond b, int depth)
{
    const double e = b.longer / (sqrt(b.length * b.length + b.longer) + b.length),
                 ei = depth == STORED ? e - p->each[SLIP_LOWER][k] : e,
                 ej = depth == STORED ? e - p->each[SLIP_UPPER][k] : e;
    const double a = b.weight * a_over_w(p, b);
    p->sum[0][SUM_DILATATION][k] += (a * b.volume_j) * ei;
    p->sum[1][SUM_DILATATION][k] += (a * b.volume_i) * ej;
    if (depth == ELASTIC) return;
    p->sum[0][SUM_SQUARE][k] += (b.weight * b.volume_j) * (ei * ei);
    p->sum[1][SUM_SQUARE][k] += (b.weight * b.volume_i) * (ej * ej);
}

/* (ordinary_plastic.3): e^p of an end moves on. */
HS_INLINE void flow(const struct bond_pass *p, int k, double e, double length, int end)
{
    double *slip = p->each[end];
    slip[k] += p->node[end][NODE_FLOW][k] * (e - slip[k] - p->node[end][NODE_CENTRE][k] * length);
}

/* (ordinary.4), (t_ij + t_ji)/(w |y|) of one fraction: (pull |xi| (|y| + |xi|) + spring (|y|^2 - |xi|^2))/((|y| + |xi|) |y|) */
HS_INLINE void push(const struct bond_pass *p, int k, struct bond b, int depth)
{
    const double spring_i = p->node[0][NODE_SPRING][k], spring_j = p->node[1][NODE_SPRING][k];
    const double square = b.length * b.length + b.longer, now = sqrt(square), sum = now + b.length;
    double pull = (p->node[0][NODE_PULL][k] + p->node[1][NODE_PULL][k]) * a_over_w(p, b);
    if (depth >= STORED)
        pull -= spring_i * p->each[SLIP_LOWER][k] + spring_j * p->each[SLIP_UPPER][k];
    const double t = (pull * sum + (spring_i + spring_j) * b.longer) / (square + b.length * now);
    bond_push(p, k, b, (b.weight * b.volume_j) * t, (b.weight * b.volume_i) * t);
    if (depth < YIELDING) return;
    flow(p, k, b.longer / sum, b.length, 0);
    flow(p, k, b.longer / sum, b.length, 1);
}

BOND_KERNELS(sum_elastic, sum_up(p, k, b, ELASTIC))
BOND_KERNELS(sum_energy, sum_up(p, k, b, ENERGY))
BOND_KERNELS(sum_stored, sum_up(p, k, b, STORED))
BOND_KERNELS(push_elastic, push(p, k, b, ELASTIC))
BOND_KERNELS(push_stored, push(p, k, b, STORED))
BOND_KERNELS(push_yielding, push(p, k, b, YIELDING))
static bond_kernel *const *const summing[] = {sum_elastic, sum_energy, sum_stored};
static bond_kernel *const *const pushing[] = {
    [ELASTIC] = push_elastic, [STORED] = push_stored, [YIELDING] = push_yielding};

/* What a strip has of its own; returns whether that is some e^p. */
static bool fill_pass(const struct ordinary *model, int64_t number, struct bond_pass *pass)
{
    struct slip slip = {{NULL, NULL}};
    if (model->plastic) slip = ordinary_plastic_slip(model, number);
    pass->number = model->law->by_length ? 0 : 1;
    pass->each[SLIP_LOWER] = slip.end[0];
    pass->each[SLIP_UPPER] = slip.end[1];
    return slip.end[0] != NULL;
}

/* Numbers of fields are constants at each call, so that no loop is left of them. */
HS_INLINE void run(bond_kernel *const kernel[], const struct ordinary *model, int64_t number,
                   int nodes, int sums, double *const sum[], struct bond_pass *pass)
{
    bond_run(kernel, model->bonds, &model->bonds->strips[number],
             (struct bond_fields){nodes, sums, model->node, sum}, pass);
}

static void sum_strip(const struct ordinary *model, int64_t number, int depth)
{
    struct bond_pass pass;
    if (fill_pass(model, number, &pass)) depth = STORED;
    if (depth == ELASTIC)
        run(summing[ELASTIC], model, number, 0, 1, model->sum, &pass);
    else
        run(summing[depth], model, number, 0, SUM_COUNT, model->sum, &pass);
}

/* flows: whether a node anywhere is about to. */
static void push_strip(struct ordinary *model, struct body *body, int64_t number, bool flows)
{
    struct bond_pass pass;
    const bool yields = flows && ordinary_plastic_flows(model, number);
    if (model->plastic) profile_count(body->profile, WORK_FLOW_STRIPS, yields, 1);
    if (yields) ordinary_plastic_make_slip(model, number);
    const int depth = fill_pass(model, number, &pass) ? STORED : ELASTIC;
    if (yields)
        run(pushing[YIELDING], model, number, NODE_COUNT, 3, body->f, &pass);
    else
        run(pushing[depth], model, number, NODE_FLOW, 3, body->f, &pass);
}

/* pull = k D theta; dilatation: theta/D */
HS_SIMD static void find_pull(int count, const double *restrict volumetric,
                              const double *restrict dilatation, double *restrict pull)
{
    for (int i = 0; i < count; i++) pull[i] = volumetric[i] * dilatation[i];
}

static void elastic_nodes(struct ordinary *model, const struct body *body,
                          struct force_energy *energy)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const int64_t i = body->owned.items[s].site;
        const int count = body->owned.items[s].count;
        double terms[LANES];
        find_pull(count, model->volumetric + i, model->sum[SUM_DILATATION] + i,
                  model->node[NODE_PULL] + i);
        if (!energy) continue;
        for (int k = 0; k < count; k++)
            terms[k] = 0.5 * (model->node[NODE_PULL][i + k] * model->sum[SUM_DILATATION][i + k] +
                              model->distortion[i + k] * model->sum[SUM_SQUARE][i + k]);
        body_times_volume(body, i, count, terms);
        exact_sum_add_strip(&energy->stored, count, terms, 1);
    }
}

static void find_weighted_volume(struct ordinary *model, const struct body *body)
{
    body_clear(body, &model->weighted_volume, 1);
    surface_add_weighted_volumes(model->bonds, 2, model->weighted_volume);
    model->weighted_changes = model->bonds->changes;
}

/* Once a node yields, what those that do need. */
static void make_flow(struct ordinary *model, const struct body *body)
{
    box_fields_new(model->node + NODE_SPRING, NODE_COUNT - NODE_SPRING, body->grid.n_sites);
    memcpy(model->node[NODE_SPRING], model->distortion,
           (size_t)body->grid.n_sites * sizeof(double));
}

/* First pass, and what the second reads of the nodes, those of other ranks included.  The sums go to the first of
 * some fields of the body whose values are not needed any more. */
static void find_nodes(struct ordinary *model, struct body *body, double *const fields[],
                       struct force_mode mode, struct force_energy *energy)
{
    for (int k = 0; k < SUM_COUNT; k++) model->sum[k] = fields[k];
    const int depth = model->plastic || energy ? ENERGY : ELASTIC;
    halo_exchange(body->displacement_halo, body->u, 3);
    if (model->plastic && model->weighted_changes != model->bonds->changes)
        find_weighted_volume(model, body);
    body_clear(body, model->sum, depth == ELASTIC ? 1 : SUM_COUNT);
    for (int64_t s = 0; s < model->bonds->count; s++) sum_strip(model, s, depth);
    if (model->plastic && !model->node[NODE_FLOW] && !mode.frozen &&
        ordinary_plastic_beyond(model, body))
        make_flow(model, body);
    if (model->plastic)
        ordinary_plastic_nodes(model, body, mode, energy);
    else
        elastic_nodes(model, body, energy);
    halo_exchange(body->stress_halo, model->node, model->node[NODE_FLOW] ? NODE_COUNT : 1);
}

HS_SIMD static int64_t any_positive(int64_t count, const double *restrict values)
{
    int64_t any = 0;
    for (int64_t i = 0; i < count; i++) any |= values[i] > 0;
    return any;
}

/* Whether a node that this rank knows is about to flow. */
static bool any_flow(const struct ordinary *model, const struct body *body)
{
    return model->node[NODE_FLOW] && any_positive(body->grid.n_sites, model->node[NODE_FLOW]);
}

/* What find_nodes would find now that e^p has moved on: the return is done, the forces stay. */
static void settle_flow(struct ordinary *model, const struct body *body)
{
    double *const *node = model->node;
    for (int64_t i = 0; i < body->grid.n_sites; i++) {
        if (!(node[NODE_FLOW][i] > 0)) continue;
        const double integrity = body->integrity ? body->integrity->node[i] : 1,
                     spring = integrity * model->distortion[i];
        node[NODE_PULL][i] -= spring * node[NODE_FLOW][i] * node[NODE_CENTRE][i];
        node[NODE_SPRING][i] = spring;
        node[NODE_FLOW][i] = 0;
    }
}

static void ordinary_force(void *self, struct body *body, struct force_mode mode,
                           struct force_energy *energy)
{
    struct ordinary *model = self;
    find_nodes(model, body, body->before_f, mode, mode.energy ? energy : NULL);
    const bool flows = mode.commit && !mode.frozen && any_flow(model, body);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < model->bonds->count; s++) push_strip(model, body, s, flows);
    if (flows) settle_flow(model, body);
}

/* The elastic part of a bond's extension as one of its ends has it, and (ordinary.3). */
HS_INLINE double elastic_of(const struct bond_pass *p, int k, struct bond b, int end)
{
    return bond_extension(b) - (p->each[end] ? p->each[end][k] : 0);
}
HS_INLINE double state_of(const struct bond_pass *p, int k, struct bond b, int end)
{
    return b.weight * (p->node[end][NODE_PULL][k] * a_over_w(p, b) +
                       p->node[end][NODE_SPRING][k] * elastic_of(p, k, b, end));
}

HS_INLINE void find_state(const struct bond_pass *p, int k, struct bond b)
{
    p->each[EXTENSION][k] = bond_extension(b);
    p->each[STATE_LOWER][k] = state_of(p, k, b, 0);
    p->each[STATE_UPPER][k] = state_of(p, k, b, 1);
}
BOND_KERNELS(find_states, find_state(p, k, b))

/* Energy density that a bond holds: that of the force states of both ends over its elastic extension. */
HS_INLINE void hold(const struct bond_pass *p, int k, struct bond b)
{
    p->each[HELD][k] = 0.5 * (state_of(p, k, b, 0) * elastic_of(p, k, b, 0) +
                              state_of(p, k, b, 1) * elastic_of(p, k, b, 1));
}
BOND_KERNELS(hold_each, hold(p, k, b))

static void look_at_strip(bond_kernel *const kernel[], const struct ordinary *model, int64_t number,
                          struct bond_pass *pass)
{
    fill_pass(model, number, pass);
    run(kernel, model, number, NODE_FLOW, 0, NULL, pass);
}

static void ordinary_bond_energy(const void *self, const struct body *body,
                                 const struct bond_strip *strip, double *energy)
{
    (void)body;
    const struct ordinary *model = self;
    struct bond_pass pass = {.each = {[HELD] = energy}};
    look_at_strip(hold_each, model, strip - model->bonds->strips, &pass);
}

static const double *ordinary_state(const void *self, const struct strip *strip, int number,
                                    int component, double *buffer)
{
    (void)number, (void)component,
        (void)buffer; /* mitchell's one state, whose field all phases share */
    return ordinary_plastic_strain(self) + strip->site;
}

static void ordinary_prepare(void *self, struct body *body, int rows)
{
    struct ordinary *model = self;
    body_need_gradient(body);
    find_nodes(model, body, body->before_S, (struct force_mode){0}, NULL);
    displacement_gradient(body);
    body_clear(body, body->S, 3 * rows);
    for (int64_t s = 0; s < model->bonds->count; s++) {
        double e[BOND_LANES], t[2][BOND_LANES];
        struct bond_pass pass = {
            .each = {[EXTENSION] = e, [STATE_LOWER] = t[0], [STATE_UPPER] = t[1]}};
        look_at_strip(find_states, model, s, &pass);
        bond_stress_add(model->bonds, &model->bonds->strips[s], e, t[0], t[1], rows, body);
    }
}

static void ordinary_observe(void *self, const struct body *body, const struct strip *strip,
                             struct node_state *node)
{
    const struct ordinary *model = self;
    node_state_from_nominal(body, strip, model->materials, node);
}

static void find_moduli(struct ordinary *model, const struct body *body)
{
    const struct materials *all = model->materials;
    double *weighted_volume = body->before_f[0], *isotropic = body->before_f[1];
    const bool corrected = model->correction != SURFACE_NONE;
    const double full = corrected ? surface_full_family(model->bonds, 1) : 1;
    body_clear(body, body->before_f, 2);
    surface_add_weighted_volumes(model->bonds, 2, weighted_volume);
    surface_add_weighted_volumes(model->bonds, 1, isotropic);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int k = 0; k < body->owned.items[s].count; k++) {
            const int64_t i = body->owned.items[s].site + k;
            const double ratio = corrected ? isotropic[i] / full : 1;
            const struct ordinary_moduli moduli = model->law->moduli(
                &all->items[body->grid.phase[i]], all->plane, body, weighted_volume[i], ratio);
            model->volumetric[i] = moduli.volumetric * moduli.dilatation * moduli.dilatation;
            model->distortion[i] = moduli.distortion;
        }
    body_clear(body, body->before_f, 2);
}

static void ordinary_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct ordinary *model = self;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 2);
    const bool yields = materials_pairs(model->materials, &law_mitchell) != NULL;
    double *fields[4];
    box_fields_new(fields, yields ? 4 : 3, body->grid.n_sites);
    model->fields = fields[0];
    model->volumetric = fields[0];
    model->distortion = model->node[NODE_SPRING] = fields[1];
    model->node[NODE_PULL] = fields[2];
    if (yields) model->weighted_volume = fields[3];
    model->weighted_changes = -1;
    find_moduli(model, body);
    halo_exchange(body->stress_halo, &model->distortion, 1);
    if (yields) model->plastic = ordinary_plastic_new(model);
}

static void ordinary_free(void *self)
{
    struct ordinary *model = self;
    if (model->plastic) ordinary_plastic_free(model->plastic);
    if (model->node[NODE_FLOW]) box_fields_free(model->node[NODE_SPRING]);
    box_fields_free(model->fields);
    free(model);
}

#define PASSES                                                                                     \
    .keys = (const char *const[]){"surface_correction", NULL}, .start = ordinary_start,            \
    .force = ordinary_force, .prepare = ordinary_prepare, .observe = ordinary_observe,             \
    .free = ordinary_free, .bond_energy = ordinary_bond_energy, .state = ordinary_state

const struct formulation formulation_ordinary = {
    .name = "ordinary state-based",
    .influence = "linear",
    .read = ordinary_read,
    .opening = opening_ordinary,
    PASSES,
};

const struct formulation formulation_madenci_oterkus = {
    .name = "ordinary state-based (a, b, d)",
    .influence = "inverse",
    .read = madenci_oterkus_read,
    .opening = opening_madenci_oterkus,
    PASSES,
};
