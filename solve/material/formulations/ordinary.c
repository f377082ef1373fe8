/* ordinary.c - the two passes over the bonds that all ordinary state-based materials share (ordinary.h). */
#include "ordinary.h"

#include "bond_loop.h"
#include "box_fields.h"
#include "gradient.h"
#include "integrity.h"
#include "memory.h"
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

/* What a kernel does: sums of the first pass up to this one, and the second's forces without e^p, with it, and with
 * its growth.  Where there is no e^p, or no growth, all give the same bits. */
enum { ELASTIC, ENERGY, STORED, YIELDING };

/* e^p of a bond's ends among the numbers of each bond. */
enum { SLIP_LOWER, SLIP_UPPER };

/* a/w: |xi| or 1 */
HS_INLINE double reach_of(const struct bond_pass *p, struct bond b)
{
    return p->number > 0 ? p->number : b.length;
}

/* First pass: a (e - e^p) V and w (e - e^p)^2 V. */
HS_INLINE void sum_up(const struct bond_pass *p, int k, struct bond b, int depth)
{
    const double e = b.longer / (sqrt(b.length * b.length + b.longer) + b.length),
                 ei = depth == STORED ? e - p->each[SLIP_LOWER][k] : e,
                 ej = depth == STORED ? e - p->each[SLIP_UPPER][k] : e;
    const double a = b.weight * reach_of(p, b);
    p->sum[0][SUM_EXTENSION][k] += (a * b.volume_j) * ei;
    p->sum[1][SUM_EXTENSION][k] += (a * b.volume_i) * ej;
    if (depth == ELASTIC) return;
    p->sum[0][SUM_SQUARE][k] += (b.weight * b.volume_j) * (ei * ei);
    p->sum[1][SUM_SQUARE][k] += (b.weight * b.volume_i) * (ej * ej);
}

/* (ordinary.4), of one fraction t/|y| = (pull |xi| (|y| + |xi|) + spring (|y|^2 - |xi|^2))/((|y| + |xi|) |y|); where an
 * end yields, its e^p moves on. */
HS_INLINE void push(const struct bond_pass *p, int k, struct bond b, int depth)
{
    double *pi = &p->each[SLIP_LOWER][k], *pj = &p->each[SLIP_UPPER][k];
    const double spring_i = p->node[0][NODE_SPRING][k], spring_j = p->node[1][NODE_SPRING][k];
    const double square = b.length * b.length + b.longer, now = sqrt(square), sum = now + b.length;
    double pull = (p->node[0][NODE_PULL][k] + p->node[1][NODE_PULL][k]) * reach_of(p, b);
    if (depth >= STORED) pull -= spring_i * *pi + spring_j * *pj;
    const double t =
        (pull * sum + (spring_i + spring_j) * b.longer) / (square + b.length * now);
    bond_push(p, k, b, (b.weight * b.volume_j) * t, (b.weight * b.volume_i) * t);
    if (depth < YIELDING) return;
    const double e = b.longer / sum;
    *pi += p->node[0][NODE_FLOW][k] * (e - *pi - p->node[0][NODE_CENTRE][k] * b.length);
    *pj += p->node[1][NODE_FLOW][k] * (e - *pj - p->node[1][NODE_CENTRE][k] * b.length);
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

/* Puts e^p of a strip into the pass; returns whether there is any. */
static bool find_slip(struct ordinary *model, int64_t number, bool make, struct bond_pass *pass)
{
    const struct slip slip =
        (make ? ordinary_plastic_room : ordinary_plastic_slip)(model, number);
    pass->each[SLIP_LOWER] = slip.end[0];
    pass->each[SLIP_UPPER] = slip.end[1];
    return slip.end[0] != NULL;
}

/* First pass over a strip. */
static void sum_strip(struct ordinary *model, int64_t number, int depth)
{
    struct bond_pass pass;
    pass.number = model->law->by_length ? 0 : 1;
    if (model->plastic && find_slip(model, number, false, &pass)) depth = STORED;
    bond_run(summing[depth], model->bonds, &model->bonds->strips[number],
             (struct bond_fields){0, depth == ELASTIC ? 1 : SUM_COUNT, NULL, model->sum}, &pass);
}

/* Second pass over a strip; flows: whether a node anywhere is about to. */
static void push_strip(struct ordinary *model, struct body *body, int64_t number, bool flows)
{
    struct bond_pass pass;
    int depth = ELASTIC, nodes = NODE_FLOW;
    pass.number = model->law->by_length ? 0 : 1;
    if (model->plastic) {
        const bool yields = flows && ordinary_plastic_flows(model, number);
        profile_count(body->profile, WORK_FLOW_STRIPS, yields, 1);
        if (find_slip(model, number, yields, &pass)) depth = yields ? YIELDING : STORED;
        if (yields) nodes = NODE_COUNT;
    }
    bond_run(pushing[depth], model->bonds, &model->bonds->strips[number],
             (struct bond_fields){nodes, 3, model->node, body->f}, &pass);
}

/* pull = k D theta */
HS_SIMD static void find_pull(int count, const double *restrict volumetric,
                              const double *restrict extension, double *restrict pull)
{
    for (int i = 0; i < count; i++) pull[i] = volumetric[i] * extension[i];
}

static void elastic_nodes(struct ordinary *model, const struct body *body,
                          struct force_energy *energy)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const int64_t i = body->owned.items[s].site;
        const int count = body->owned.items[s].count;
        double terms[LANES];
        find_pull(count, model->volumetric + i, model->sum[SUM_EXTENSION] + i,
                  model->node[NODE_PULL] + i);
        if (!energy) continue;
        for (int k = 0; k < count; k++)
            terms[k] = 0.5 * (model->node[NODE_PULL][i + k] * model->sum[SUM_EXTENSION][i + k] +
                              model->distortion[i + k] * model->sum[SUM_SQUARE][i + k]);
        body_times_volume(body, i, count, terms);
        exact_sum_add_strip(&energy->stored, count, terms, 1);
    }
}

/* sum = sum_j w |xi|^power V_j of each node. */
static void sum_moments(const struct ordinary *model, int power, double *sum)
{
    for (int64_t s = 0; s < model->bonds->count; s++) {
        const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[s]);
        const int g = view.geometry_step;
        double lower[BOND_LANES], upper[BOND_LANES], *i = bond_target(&view, false, sum, lower),
                                                     *j = bond_target(&view, true, sum, upper);
        for (int k = 0; k < view.count; k++) {
            double moment = view.weight[k * view.weight_step] * view.length[k * g];
            if (power == 2) moment *= view.length[k * g];
            i[k] += moment * view.volume_j[k * g];
            j[k] += moment * view.volume_i[k * g];
        }
        bond_scatter(&view, false, sum, lower);
        bond_scatter(&view, true, sum, upper);
    }
}

static void find_moment(struct ordinary *model, const struct body *body)
{
    body_clear(body, &model->moment, 1);
    sum_moments(model, 2, model->moment);
    model->moment_changes = model->bonds->changes;
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
    if (model->plastic && model->moment_changes != model->bonds->changes) find_moment(model, body);
    body_clear(body, model->sum, depth == ELASTIC ? 1 : SUM_COUNT);
    for (int64_t s = 0; s < model->bonds->count; s++)
        sum_strip(model, s, depth);
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
        const double left = body->integrity ? body->integrity->node[i] : 1,
                     spring = left * model->distortion[i];
        node[NODE_PULL][i] -= spring * node[NODE_FLOW][i] * node[NODE_CENTRE][i];
        node[NODE_SPRING][i] = spring;
        node[NODE_FLOW][i] = 0;
    }
}

static void ordinary_force(void *self, struct body *body, struct force_mode mode,
                           struct force_energy *energy)
{
    struct ordinary *model = self;
    find_nodes(model, body, body->f, mode, mode.energy ? energy : NULL);
    const bool flows = mode.commit && !mode.frozen && any_flow(model, body);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < model->bonds->count; s++)
        push_strip(model, body, s, flows);
    if (flows) settle_flow(model, body);
}

/* (ordinary.3) of both ends of the bonds of a strip, the extensions and their elastic parts. */
struct states {
    double extension[BOND_LANES], t[2][BOND_LANES], elastic[2][BOND_LANES];
};

static void find_states(const struct ordinary *model, const struct bond_view *view, int64_t number,
                        const struct bond_ends *u, struct states *states)
{
    struct slip slip = {{NULL, NULL}};
    const double *e = states->extension;
    if (model->plastic) slip = ordinary_plastic_slip(model, number);
    bond_ends_extensions(view, u, states->extension);
    for (int k = 0; k < view->count; k++) {
        const double reach = model->law->by_length ? view->length[k * view->geometry_step] : 1,
                     weight = view->weight[k * view->weight_step];
        for (int end = 0; end < 2; end++) {
            const int64_t i = end ? bond_upper(view, k) : bond_lower(view, k);
            const double elastic = e[k] - (slip.end[end] ? slip.end[end][k] : 0);
            states->elastic[end][k] = elastic;
            states->t[end][k] = weight * (model->node[NODE_PULL][i] * reach +
                                          model->node[NODE_SPRING][i] * elastic);
        }
    }
}

static void add_stress(const struct ordinary *model, struct body *body, int64_t number, int rows)
{
    const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[number]);
    double displacement[6][BOND_LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    struct states states;
    find_states(model, &view, number, &u, &states);
    bond_ends_add_stress(&view, &u, states.extension, states.t[0], states.t[1], rows, body);
}

/* Energy density that each bond holds: that of the force states of both ends over its elastic extension. */
static void ordinary_bond_energy(const void *self, const struct body *body,
                                 const struct bond_strip *strip, double *energy)
{
    const struct ordinary *model = self;
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][BOND_LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    struct states states;
    find_states(model, &view, strip - model->bonds->strips, &u, &states);
    for (int k = 0; k < view.count; k++)
        energy[k] =
            0.5 * (states.t[0][k] * states.elastic[0][k] + states.t[1][k] * states.elastic[1][k]);
}

static const double *ordinary_plastic(const void *self, const struct strip *strip)
{
    const struct ordinary *model = self;
    return model->plastic ? ordinary_plastic_strain(model) + strip->site : NULL;
}

static void ordinary_prepare(void *self, struct body *body, double *axial, int rows)
{
    struct ordinary *model = self;
    body_need_gradient(body);
    find_nodes(model, body, body->S, (struct force_mode){0}, NULL);
    displacement_gradient(body);
    body_clear(body, body->S, 3 * rows);
    for (int64_t s = 0; s < model->bonds->count; s++) add_stress(model, body, s, rows);
    if (axial) memcpy(axial, body->S[0], (size_t)body->grid.n_sites * sizeof(double));
}

static void ordinary_observe(void *self, const struct body *body, const struct strip *strip,
                             struct node_state *node)
{
    const struct ordinary *model = self;
    node_state_from_nominal(body, strip, model->materials, node);
    memset(node->plastic, 0, sizeof node->plastic);
    if (model->plastic)
        memcpy(node->plastic, ordinary_plastic_strain(model) + strip->site,
               (size_t)strip->count * sizeof(double));
}

static void find_moduli(struct ordinary *model, const struct body *body)
{
    const struct materials *all = model->materials;
    double *moment = body->f[0], *isotropic = body->f[1]; /* not in use yet */
    const bool corrected = model->correction != SURFACE_NONE;
    const double full = corrected ? surface_full_family(model->bonds, 1) : 1;
    body_clear(body, body->f, 2);
    sum_moments(model, 2, moment);
    sum_moments(model, 1, isotropic);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int k = 0; k < body->owned.items[s].count; k++) {
            const int64_t i = body->owned.items[s].site + k;
            const double ratio = corrected ? isotropic[i] / full : 1;
            const struct ordinary_moduli moduli = model->law->moduli(
                &all->items[body->grid.phase[i]], all->plane, body, moment[i], ratio);
            model->volumetric[i] = moduli.volumetric * moduli.dilatation * moduli.dilatation;
            model->distortion[i] = moduli.distortion;
        }
    body_clear(body, body->f, 2);
}

static bool yields_somewhere(const struct materials *all)
{
    for (int p = 0; p < all->count; p++)
        if (all->items[p].yields) return true;
    return false;
}

static void ordinary_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct ordinary *model = self;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 2);
    const bool yields = yields_somewhere(model->materials);
    double *fields[4];
    box_fields_new(fields, yields ? 4 : 3, body->grid.n_sites);
    model->fields = fields[0];
    model->volumetric = fields[0];
    model->distortion = model->node[NODE_SPRING] = fields[1];
    model->node[NODE_PULL] = fields[2];
    if (yields) model->moment = fields[3];
    model->moment_changes = -1;
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
    .free = ordinary_free, .bond_energy = ordinary_bond_energy, .plastic_strain = ordinary_plastic

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
