/* ordinary.c - the two passes over the bonds that all ordinary state-based materials share
 * (ordinary.h).
 *
 * The force along a bond depends on the dilatations of its ends, and so on all their bonds: it
 * takes two passes.  The first, sum_up, gives each node its dilatation; then the law goes from node
 * to node (elastic_nodes, or the plastic return in ordinary_plastic.c) and leaves what the second,
 * push, reads of a node, for which ranks exchange no more than that: the pull of the dilatation
 * alone until a node yields.  Both passes find the extension of a bond anew, so that an elastic
 * bond has no memory of its own.  Either takes one root and one division a bond, which set its
 * pace.
 *
 * The kernels come in depths, each a loop of its own (bond_loop.h makes the variants by geometry
 * and weight): without the sum of squares, which energy and yield alone need; with e^p, which a
 * line of bonds has once one of them has yielded, two numbers a bond; with the growth of e^p, only
 * in strips with a node that flows.  A node before yield so costs what an elastic one does.  Strips
 * with bonds through two phases have kernels of their own, too. */
#include "ordinary.h"

#include "bond_loop.h"
#include "bond_stress.h"
#include "box_fields.h"
#include "checkpoint.h"
#include "gradient.h"
#include "integrity.h"
#include "interface.h"
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
    model->series = interface_read(solver);
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

/* How much a kernel does: sums of the first pass up to this one, and the second's forces without
 * e^p, with it, and with its growth.  Where there is no e^p, or no growth, all give the same bits.
 */
enum { ELASTIC, ENERGY, STORED, YIELDING };

/* Numbers of each bond: e^p of its ends, NULL where there is none, and what find_state and hold
 * find of it. */
enum {
    SLIP_LOWER,
    SLIP_UPPER,
    EXTENSION,
    STATE_LOWER,
    STATE_UPPER,
    HELD = EXTENSION,
    WAY = EXTENSION,
    FORCE = WAY + 3
};

/* What each bond of a strip with some through two phases is given: (interface.2). */
enum { SHARE_LOWER, SHARE_UPPER, PART_LOWER, PART_UPPER, ENDS };

/* r, g and g/r of an end. */
HS_INLINE double share_of(const struct bond_pass *p, int k, int end, bool shared)
{
    return shared ? p->given[SHARE_LOWER + end][k] : 1;
}
HS_INLINE double part_of(const struct bond_pass *p, int k, int end, bool shared)
{
    return shared ? p->given[PART_LOWER + end][k] : 1;
}
HS_INLINE double both_of(const struct bond_pass *p, int k, int end, bool shared)
{
    return share_of(p, k, end, shared) * part_of(p, k, end, shared);
}

/* |xi| or 1 */
HS_INLINE double a_over_w(const struct bond_pass *p, struct bond b)
{
    return p->number > 0 ? p->number : b.length;
}

/* (ordinary.1) but for D, and the sum of (ordinary.2). */
HS_INLINE void sum_up(const struct bond_pass *p, int k, struct bond b, int depth, bool shared)
{
    const double e = b.longer / (sqrt(b.length * b.length + b.longer) + b.length),
                 own_i = e * share_of(p, k, 0, shared), own_j = e * share_of(p, k, 1, shared),
                 ei = depth == STORED ? own_i - p->each[SLIP_LOWER][k] : own_i,
                 ej = depth == STORED ? own_j - p->each[SLIP_UPPER][k] : own_j;
    const double part_i = part_of(p, k, 0, shared), part_j = part_of(p, k, 1, shared);
    const double a = b.weight * a_over_w(p, b);
    p->sum[0][SUM_DILATATION][k] += (a * b.volume_j * part_i) * ei;
    p->sum[1][SUM_DILATATION][k] += (a * b.volume_i * part_j) * ej;
    if (depth == ELASTIC) return;
    p->sum[0][SUM_SQUARE][k] += (b.weight * b.volume_j * part_i) * (ei * ei);
    p->sum[1][SUM_SQUARE][k] += (b.weight * b.volume_i * part_j) * (ej * ej);
}

/* (ordinary_plastic.3): e^p of an end moves on. */
HS_INLINE void flow(const struct bond_pass *p, int k, double e, double length, int end)
{
    double *slip = p->each[end];
    slip[k] += p->node[end][NODE_FLOW][k] * (e - slip[k] - p->node[end][NODE_CENTRE][k] * length);
}

/* (ordinary.4), (t_ij + t_ji)/(w |y|) of one fraction: (pull |xi| (|y| + |xi|) + spring (|y|^2 -
 * |xi|^2))/((|y| + |xi|) |y|) */
HS_INLINE double force_of(const struct bond_pass *p, int k, struct bond b, int depth, bool shared)
{
    const double g_i = both_of(p, k, 0, shared), g_j = both_of(p, k, 1, shared),
                 r_i = share_of(p, k, 0, shared), r_j = share_of(p, k, 1, shared);
    const double spring_i = g_i * p->node[0][NODE_SPRING][k],
                 spring_j = g_j * p->node[1][NODE_SPRING][k];
    const double square = b.length * b.length + b.longer, now = sqrt(square), sum = now + b.length;
    double pull =
        (g_i * p->node[0][NODE_PULL][k] + g_j * p->node[1][NODE_PULL][k]) * a_over_w(p, b);
    if (depth >= STORED)
        pull -= spring_i * p->each[SLIP_LOWER][k] + spring_j * p->each[SLIP_UPPER][k];
    return (pull * sum + (spring_i * r_i + spring_j * r_j) * b.longer) / (square + b.length * now);
}

HS_INLINE void push(const struct bond_pass *p, int k, struct bond b, int depth, bool shared)
{
    const double t = force_of(p, k, b, depth, shared);
    bond_push(p, k, b, (b.weight * b.volume_j) * t, (b.weight * b.volume_i) * t);
    if (depth < YIELDING) return;
    const double e = b.longer / (sqrt(b.length * b.length + b.longer) + b.length);
    flow(p, k, share_of(p, k, 0, shared) * e, b.length, 0);
    flow(p, k, share_of(p, k, 1, shared) * e, b.length, 1);
}

/* y, and the force over |y|, per volume of either end. */
HS_INLINE void find_force(const struct bond_pass *p, int k, struct bond b, int depth, bool shared)
{
    p->each[WAY][k] = b.x;
    p->each[WAY + 1][k] = b.y;
    p->each[WAY + 2][k] = b.z;
    p->each[FORCE][k] = b.weight * force_of(p, k, b, depth, shared);
}

BOND_KERNELS(sum_elastic, sum_up(p, k, b, ELASTIC, false))
BOND_KERNELS(sum_energy, sum_up(p, k, b, ENERGY, false))
BOND_KERNELS(sum_stored, sum_up(p, k, b, STORED, false))
BOND_KERNELS(push_elastic, push(p, k, b, ELASTIC, false))
BOND_KERNELS(push_stored, push(p, k, b, STORED, false))
BOND_KERNELS(push_yielding, push(p, k, b, YIELDING, false))
BOND_KERNELS(sum_elastic_shared, sum_up(p, k, b, ELASTIC, true))
BOND_KERNELS(sum_energy_shared, sum_up(p, k, b, ENERGY, true))
BOND_KERNELS(sum_stored_shared, sum_up(p, k, b, STORED, true))
BOND_KERNELS(push_elastic_shared, push(p, k, b, ELASTIC, true))
BOND_KERNELS(push_stored_shared, push(p, k, b, STORED, true))
BOND_KERNELS(push_yielding_shared, push(p, k, b, YIELDING, true))
/* [shared][depth] */
static bond_kernel *const *const summing[2][3] = {
    {sum_elastic, sum_energy, sum_stored},
    {sum_elastic_shared, sum_energy_shared, sum_stored_shared}};
static bond_kernel *const *const pushing[2][4] = {
    {[ELASTIC] = push_elastic, [STORED] = push_stored, [YIELDING] = push_yielding},
    {[ELASTIC] = push_elastic_shared,
     [STORED] = push_stored_shared,
     [YIELDING] = push_yielding_shared}};

BOND_KERNELS(force_elastic, find_force(p, k, b, ELASTIC, false))
BOND_KERNELS(force_stored, find_force(p, k, b, STORED, false))
BOND_KERNELS(force_elastic_shared, find_force(p, k, b, ELASTIC, true))
BOND_KERNELS(force_stored_shared, find_force(p, k, b, STORED, true))
/* [shared][whether there is some e^p] */
static bond_kernel *const *const forcing[2][2] = {{force_elastic, force_stored},
                                                  {force_elastic_shared, force_stored_shared}};

static bool is_shared(const struct ordinary *model, int64_t number)
{
    return model->ends && model->ends[number];
}

/* Of a strip with bonds through two phases. */
static void give_ends(const struct ordinary *model, int64_t number, struct bond_pass *pass)
{
    const int stride = bonds_stride(model->bonds->strips[number].count);
    for (int a = 0; a < ENDS; a++) pass->given[a] = model->ends[number] + a * stride;
}

/* What a strip has of its own; returns whether that is some e^p. */
static bool fill_pass(const struct ordinary *model, int64_t number, struct bond_pass *pass)
{
    struct slip slip = {{NULL, NULL}};
    if (model->plastic) slip = ordinary_plastic_slip(model, number);
    pass->number = model->law->by_length ? 0 : 1;
    pass->each[SLIP_LOWER] = slip.end[0];
    pass->each[SLIP_UPPER] = slip.end[1];
    if (is_shared(model, number)) give_ends(model, number, pass);
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
    bond_kernel *const *const *of = summing[is_shared(model, number)];
    if (depth == ELASTIC)
        run(of[ELASTIC], model, number, 0, 1, model->sum, &pass);
    else
        run(of[depth], model, number, 0, SUM_COUNT, model->sum, &pass);
}

/* flows: whether a node anywhere is about to. */
static void push_strip(struct ordinary *model, struct body *body, int64_t number, bool flows)
{
    struct bond_pass pass;
    const bool yields = flows && ordinary_plastic_flows(model, number);
    if (model->plastic) profile_count(body->profile, WORK_FLOW_STRIPS, yields, 1);
    if (yields) ordinary_plastic_make_slip(model, number);
    const int depth = fill_pass(model, number, &pass) ? STORED : ELASTIC;
    bond_kernel *const *const *of = pushing[is_shared(model, number)];
    if (yields)
        run(of[YIELDING], model, number, NODE_COUNT, 3, body->f, &pass);
    else
        run(of[depth], model, number, NODE_FLOW, 3, body->f, &pass);
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

/* sum += g/r w |xi|^2 V_j, whose ratio to that without g/r is how much a node's dilatation would
 * lack. */
HS_INLINE void add_part(const struct bond_pass *p, int k, struct bond b, bool shared)
{
    const double one = b.weight * b.length * b.length;
    p->sum[0][0][k] += one * b.volume_j * part_of(p, k, 0, shared);
    p->sum[1][0][k] += one * b.volume_i * part_of(p, k, 1, shared);
}
BOND_KERNELS(parts, add_part(p, k, b, false))
BOND_KERNELS(parts_shared, add_part(p, k, b, true))

static void add_parts(const struct ordinary *model, double *sum)
{
    for (int64_t s = 0; s < model->bonds->count; s++) {
        struct bond_pass pass;
        const bool shared = is_shared(model, s);
        if (shared) give_ends(model, s, &pass);
        run(shared ? parts_shared : parts, model, s, 0, 1, &sum, &pass);
    }
}

static void find_weighted_volume(struct ordinary *model, const struct body *body)
{
    body_clear(body, &model->weighted_volume, 1);
    if (model->ends)
        add_parts(model, model->weighted_volume);
    else
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

/* First pass, and what the second reads of the nodes, those of other ranks included.  The sums go
 * to the first of some fields of the body whose values are not needed any more. */
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

/* The elastic part of a bond's extension as one of its ends has it, and (ordinary.3). */
HS_INLINE double elastic_of(const struct bond_pass *p, int k, struct bond b, int end, bool shared)
{
    return bond_extension(b) * share_of(p, k, end, shared) - (p->each[end] ? p->each[end][k] : 0);
}
HS_INLINE double state_of(const struct bond_pass *p, int k, struct bond b, int end, bool shared)
{
    return b.weight * (p->node[end][NODE_PULL][k] * a_over_w(p, b) +
                       p->node[end][NODE_SPRING][k] * elastic_of(p, k, b, end, shared));
}

HS_INLINE void find_state(const struct bond_pass *p, int k, struct bond b, bool shared)
{
    const double lower = state_of(p, k, b, 0, shared) * both_of(p, k, 0, shared),
                 upper = state_of(p, k, b, 1, shared) * both_of(p, k, 1, shared);
    /* What either end makes of a bond through two phases says more of where its middle lies than of
     * a stress. */
    const bool two = share_of(p, k, 0, shared) != 1 || share_of(p, k, 1, shared) != 1;
    p->each[EXTENSION][k] = bond_extension(b);
    p->each[STATE_LOWER][k] = two ? 0.5 * (lower + upper) : lower;
    p->each[STATE_UPPER][k] = two ? 0.5 * (lower + upper) : upper;
}
BOND_KERNELS(find_states, find_state(p, k, b, false))
BOND_KERNELS(find_states_shared, find_state(p, k, b, true))

/* Energy density that a bond holds: that of the force states of both ends over its elastic
 * extension. */
HS_INLINE double held_of(const struct bond_pass *p, int k, struct bond b, int end, bool shared)
{
    return state_of(p, k, b, end, shared) * elastic_of(p, k, b, end, shared) *
           part_of(p, k, end, shared);
}
HS_INLINE void hold(const struct bond_pass *p, int k, struct bond b, bool shared)
{
    p->each[HELD][k] = 0.5 * (held_of(p, k, b, 0, shared) + held_of(p, k, b, 1, shared));
}
BOND_KERNELS(hold_each, hold(p, k, b, false))
BOND_KERNELS(hold_each_shared, hold(p, k, b, true))
/* [shared] */
static bond_kernel *const *const finding[2] = {find_states, find_states_shared};
static bond_kernel *const *const holding[2] = {hold_each, hold_each_shared};

static void look_at_strip(bond_kernel *const *const kernel[2], const struct ordinary *model,
                          int64_t number, struct bond_pass *pass)
{
    fill_pass(model, number, pass);
    run(kernel[is_shared(model, number)], model, number, NODE_FLOW, 0, NULL, pass);
}

/* Extension and force states of the ends of a strip's bonds. */
static void find_strip(const struct ordinary *model, int64_t number, double *e,
                       double t[2][BOND_LANES])
{
    struct bond_pass pass = {.each = {[EXTENSION] = e, [STATE_LOWER] = t[0], [STATE_UPPER] = t[1]}};
    look_at_strip(finding, model, number, &pass);
}

static void sum_stress(const struct ordinary *model, const struct body *body, int64_t number)
{
    double y[3][BOND_LANES], force[BOND_LANES];
    struct bond_pass pass;
    const bool slipped = fill_pass(model, number, &pass);
    for (int a = 0; a < 3; a++) pass.each[WAY + a] = y[a];
    pass.each[FORCE] = force;
    run(forcing[is_shared(model, number)][slipped], model, number, NODE_FLOW, 0, NULL, &pass);
    bond_stress_cross(model->bonds, &model->bonds->strips[number],
                      (const double *const[]){y[0], y[1], y[2]}, force, body);
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
    if (body->stress_sums) bond_stress_nodes(body);
    for (int64_t s = 0; body->stress_sums && s < model->bonds->count; s++)
        if (bond_stress_crosses(model->bonds, &model->bonds->strips[s])) sum_stress(model, body, s);
}

static void ordinary_bond_energy(const void *self, const struct body *body,
                                 const struct bond_strip *strip, double *energy)
{
    (void)body;
    const struct ordinary *model = self;
    struct bond_pass pass = {.each = {[HELD] = energy}};
    look_at_strip(holding, model, strip - model->bonds->strips, &pass);
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
        find_strip(model, s, e, t);
        bond_stress_add(model->bonds, &model->bonds->strips[s], e, t[0], t[1], rows, body);
    }
}

static void ordinary_observe(void *self, const struct body *body, const struct strip *strip,
                             struct node_state *node)
{
    const struct ordinary *model = self;
    node_state_from_nominal(body, strip, model->materials, node);
}

/* The strips with bonds through two phases get the numbers of their ends. */
static void find_ends(struct ordinary *model)
{
    const struct materials *all = model->materials;
    double *stiffness = memory_new((size_t)all->count, sizeof *stiffness);
    for (int p = 0; p < all->count; p++)
        stiffness[p] = interface_stiffness(&all->items[p], all->plane);
    struct interface *interface = interface_new(model->bonds, all->count, stiffness);
    free(stiffness);
    if (!interface) return;
    model->ends = memory_new((size_t)model->bonds->count, sizeof *model->ends);
    for (int64_t s = 0; s < model->bonds->count; s++) {
        const size_t stride = (size_t)bonds_stride(model->bonds->strips[s].count);
        double *ends = memory_new(ENDS * stride, sizeof *ends);
        if (interface_strip(interface, &model->bonds->strips[s],
                            (double *const[]){ends, ends + stride},
                            (double *const[]){ends + 2 * stride, ends + 3 * stride}))
            model->ends[s] = ends;
        else
            free(ends);
    }
    interface_free(interface);
}

static void find_moduli(struct ordinary *model, const struct body *body)
{
    const struct materials *all = model->materials;
    double *weighted_volume = body->before_f[0], *isotropic = body->before_f[1],
           *parts_volume = body->before_f[2];
    const bool corrected = model->correction != SURFACE_NONE;
    const double full = corrected ? surface_full_family(model->bonds, 1) : 1;
    body_clear(body, body->before_f, 3);
    if (model->ends) add_parts(model, parts_volume);
    surface_add_weighted_volumes(model->bonds, 2, weighted_volume);
    surface_add_weighted_volumes(model->bonds, 1, isotropic);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int k = 0; k < body->owned.items[s].count; k++) {
            const int64_t i = body->owned.items[s].site + k;
            const double ratio = corrected ? isotropic[i] / full : 1;
            struct ordinary_moduli moduli = model->law->moduli(
                &all->items[body->grid.phase[i]], all->plane, body, weighted_volume[i], ratio);
            if (model->ends && parts_volume[i] > 0)
                moduli.dilatation *= weighted_volume[i] / parts_volume[i];
            model->volumetric[i] = moduli.volumetric * moduli.dilatation * moduli.dilatation;
            model->distortion[i] = moduli.distortion;
        }
    body_clear(body, body->before_f, 3);
}

static void ordinary_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct ordinary *model = self;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 2);
    if (model->series) find_ends(model);
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

static void ordinary_visit(void *self, const struct body *body, struct checkpoint *checkpoint)
{
    struct ordinary *model = self;
    if (!model->plastic) return;
    bool flow = model->node[NODE_FLOW] != NULL;
    checkpoint_flag(checkpoint, "ordinary: some node has yielded", &flow);
    if (flow && !model->node[NODE_FLOW]) make_flow(model, body);
    ordinary_plastic_visit(model, body, checkpoint);
}

static void ordinary_free(void *self)
{
    struct ordinary *model = self;
    if (model->plastic) ordinary_plastic_free(model->plastic);
    for (int64_t s = 0; model->ends && s < model->bonds->count; s++) free(model->ends[s]);
    free(model->ends);
    if (model->node[NODE_FLOW]) box_fields_free(model->node[NODE_SPRING]);
    box_fields_free(model->fields);
    free(model);
}

#define PASSES                                                                                     \
    .keys = (const char *const[]){"surface_correction", "interfaces", NULL},                       \
    .start = ordinary_start, .force = ordinary_force, .prepare = ordinary_prepare,                 \
    .observe = ordinary_observe, .visit = ordinary_visit, .free = ordinary_free,                   \
    .bond_energy = ordinary_bond_energy, .state = ordinary_state

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
