/* ordinary.c - the two passes over the bonds that all ordinary state-based materials share (ordinary.h). */
#include "ordinary.h"

#include "box_fields.h"
#include "gradient.h"
#include "integrity.h"
#include "memory.h"
#include "nominal.h"
#include "opening.h"
#include "profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* |xi| where a bond's weight is not to be multiplied by it. */
static const double ones[LANES] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
                                   1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
                                   1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

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

/* What a kernel reads and writes of a strip: arrays of its first bond, or one number for all of it. */
struct pass {
    int count;
    const double *u_lower[3], *u_upper[3];
    const double *xi[3], *length, *weight, *volume_i, *volume_j;
    const double *reach; /* |xi| or 1 */
    /* First pass. */
    double *sum_lower[SUM_COUNT], *sum_upper[SUM_COUNT];
    /* Second pass. */
    const double *node_lower[NODE_COUNT], *node_upper[NODE_COUNT];
    double *f_lower[3], *f_upper[3];
    /* e^p of the lower and the upper ends. */
    struct slip slip;
};

/* What a kernel does: sums of the first pass up to this one, and the second's forces without e^p, with it, and with
 * its growth.  Where there is no e^p, or no growth, all give the same bits. */
enum { ELASTIC, ENERGY, STORED, YIELDING };

/* First pass over a strip, with an array each of geometry and weight where g and w. */
HS_INLINE void sum_up(const struct pass *s, bool g, bool w, int depth)
{
    const double *ux = s->u_lower[0], *uy = s->u_lower[1], *uz = s->u_lower[2];
    const double *vx = s->u_upper[0], *vy = s->u_upper[1], *vz = s->u_upper[2];
    const double *X = s->xi[0], *Y = s->xi[1], *Z = s->xi[2], *L = s->length, *W = s->weight;
    const double *Vi = s->volume_i, *Vj = s->volume_j, *R = s->reach;
    const double *pi = s->slip.end[0], *pj = s->slip.end[1];
    double *ei = s->sum_lower[SUM_EXTENSION], *ni = s->sum_lower[SUM_SQUARE];
    double *ej = s->sum_upper[SUM_EXTENSION], *nj = s->sum_upper[SUM_SQUARE];
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, R0 = *R;
    const int count = s->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double weight = w ? W[k] : W0, reach = g ? R[k] : R0;
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        double e = longer / (sqrt(length * length + longer) + length);
        double qi = e, qj = e;
        if (depth == STORED) {
            qi -= pi[k];
            qj -= pj[k];
        }
        ei[k] += (weight * reach * volume_j) * qi;
        ej[k] += (weight * reach * volume_i) * qj;
        if (depth >= ENERGY) {
            ni[k] += (weight * volume_j) * (qi * qi);
            nj[k] += (weight * volume_i) * (qj * qj);
        }
    }
}

/* (ordinary.4), of one fraction t/|y| = (pull |xi| (|y| + |xi|) + spring (|y|^2 - |xi|^2))/((|y| + |xi|) |y|); where an
 * end yields, its e^p moves on. */
HS_INLINE void push(const struct pass *s, bool g, bool w, int depth)
{
    const double *ux = s->u_lower[0], *uy = s->u_lower[1], *uz = s->u_lower[2];
    const double *vx = s->u_upper[0], *vy = s->u_upper[1], *vz = s->u_upper[2];
    const double *X = s->xi[0], *Y = s->xi[1], *Z = s->xi[2], *L = s->length, *W = s->weight;
    const double *Vi = s->volume_i, *Vj = s->volume_j, *R = s->reach;
    const double *Ai = s->node_lower[NODE_PULL], *Aj = s->node_upper[NODE_PULL];
    const double *Bi = s->node_lower[NODE_SPRING], *Bj = s->node_upper[NODE_SPRING];
    const double *Fi = s->node_lower[NODE_FLOW], *Fj = s->node_upper[NODE_FLOW];
    const double *Ci = s->node_lower[NODE_CENTRE], *Cj = s->node_upper[NODE_CENTRE];
    double *pi = s->slip.end[0], *pj = s->slip.end[1];
    double *ix = s->f_lower[0], *iy = s->f_lower[1], *iz = s->f_lower[2];
    double *jx = s->f_upper[0], *jy = s->f_upper[1], *jz = s->f_upper[2];
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, R0 = *R;
    const int count = s->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double weight = w ? W[k] : W0, reach = g ? R[k] : R0;
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        double square = length * length + longer, now = sqrt(square), sum = now + length;
        double pull = (Ai[k] + Aj[k]) * reach;
        if (depth >= STORED) pull -= Bi[k] * pi[k] + Bj[k] * pj[k];
        double force = (pull * sum + (Bi[k] + Bj[k]) * longer) / (square + length * now);
        double i = (weight * volume_j) * force, j = (weight * volume_i) * force;
        x += a;
        y += b;
        z += d;
        ix[k] += i * x;
        iy[k] += i * y;
        iz[k] += i * z;
        jx[k] -= j * x;
        jy[k] -= j * y;
        jz[k] -= j * z;
        if (depth == YIELDING) {
            double e = longer / sum;
            pi[k] += Fi[k] * (e - pi[k] - Ci[k] * length);
            pj[k] += Fj[k] * (e - pj[k] - Cj[k] * length);
        }
    }
}

#define VARIANT(name, kernel, g, w, depth)                                                         \
    HS_SIMD static void name(const struct pass *s)                                                 \
    {                                                                                              \
        kernel(s, g, w, depth);                                                                    \
    }
#define VARIANTS(name, kernel, depth)                                                              \
    VARIANT(name##_alike, kernel, false, false, depth)                                             \
    VARIANT(name##_weighted, kernel, false, true, depth)                                           \
    VARIANT(name##_scattered, kernel, true, true, depth)
#define CHOICE(name)                                                                               \
    {                                                                                              \
        name##_alike, name##_weighted, name##_scattered                                            \
    }
VARIANTS(sum_elastic, sum_up, ELASTIC)
VARIANTS(sum_energy, sum_up, ENERGY)
VARIANTS(sum_stored, sum_up, STORED)
VARIANTS(push_elastic, push, ELASTIC)
VARIANTS(push_stored, push, STORED)
VARIANTS(push_yielding, push, YIELDING)

typedef void kernel(const struct pass *);
enum { ALIKE, WEIGHTED, SCATTERED };
/* [depth][what differs] */
static kernel *const summing[][3] = {CHOICE(sum_elastic), CHOICE(sum_energy), CHOICE(sum_stored)};
static kernel *const pushing[][3] = {[ELASTIC] = CHOICE(push_elastic),
                                     [STORED] = CHOICE(push_stored),
                                     [YIELDING] = CHOICE(push_yielding)};

/* The bonds of a strip of a lattice; returns ALIKE or WEIGHTED. */
static inline int pass_on_lattice(const struct ordinary *model, const struct body *body,
                                  const struct bond_strip *strip, struct pass *pass)
{
    const struct bond_geometry *g = &model->bonds->geometry[strip->offset];
    pass->count = strip->count;
    pass->length = &g->length;
    pass->reach = model->law->by_length ? &g->length : ones;
    pass->weight = strip->weight ? strip->weight : &g->weight;
    pass->volume_i = pass->volume_j = model->bonds->volume;
    for (int a = 0; a < 3; a++) {
        pass->xi[a] = &g->xi[a];
        pass->u_lower[a] = body->u[a] + strip->i;
        pass->u_upper[a] = body->u[a] + strip->i + g->shift;
    }
    return strip->weight ? WEIGHTED : ALIKE;
}

/* The same of any view, whose ends are gathered where they do not lie side by side. */
static void pass_over(const struct ordinary *model, const struct body *body,
                      const struct bond_view *view, double buffer[6][BOND_LANES], struct pass *pass)
{
    const struct bond_ends u = bond_ends_find(view, body, buffer);
    pass->count = view->count;
    pass->length = view->length;
    pass->reach = model->law->by_length ? view->length : ones;
    pass->weight = view->weight;
    pass->volume_i = view->volume_i;
    pass->volume_j = view->volume_j;
    for (int a = 0; a < 3; a++) {
        pass->xi[a] = view->xi[a];
        pass->u_lower[a] = u.lower[a];
        pass->u_upper[a] = u.upper[a];
    }
}

static int sum_depth(const struct ordinary *model, int64_t number, int depth, struct pass *pass)
{
    if (!model->plastic) return depth;
    pass->slip = ordinary_plastic_slip(model, number);
    return pass->slip.end[0] ? STORED : depth;
}

static void sum_lattice(const struct ordinary *model, const struct body *body, int64_t number,
                        int depth)
{
    const struct bond_strip *strip = &model->bonds->strips[number];
    const struct bond_geometry *g = &model->bonds->geometry[strip->offset];
    const int64_t i = strip->i, j = i + g->shift;
    double buffer[3][BOND_LANES];
    struct pass pass;
    const int what = pass_on_lattice(model, body, strip, &pass);
    depth = sum_depth(model, number, depth, &pass);
    for (int k = 0; k < SUM_COUNT; k++) {
        pass.sum_lower[k] = model->sum[k] + i;
        pass.sum_upper[k] = model->sum[k] + j;
    }
    if (!g->apart) bond_detour(SUM_COUNT, buffer, strip->count, pass.sum_upper);
    summing[depth][what](&pass);
    if (!g->apart)
        bond_detour_end(depth == ELASTIC ? 1 : SUM_COUNT, buffer, strip->count, model->sum, j);
}

static void sum_scattered_strip(const struct ordinary *model, const struct body *body,
                                int64_t number, int depth)
{
    const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[number]);
    double displacement[6][BOND_LANES], lower[SUM_COUNT][BOND_LANES], upper[SUM_COUNT][BOND_LANES];
    struct pass pass;
    pass_over(model, body, &view, displacement, &pass);
    depth = sum_depth(model, number, depth, &pass);
    const int count = depth == ELASTIC ? 1 : SUM_COUNT;
    for (int k = 0; k < count; k++) {
        pass.sum_lower[k] = bond_target(&view, false, model->sum[k], lower[k]);
        pass.sum_upper[k] = bond_target(&view, true, model->sum[k], upper[k]);
    }
    summing[depth][SCATTERED](&pass);
    for (int k = 0; k < count; k++) {
        bond_scatter(&view, false, model->sum[k], lower[k]);
        bond_scatter(&view, true, model->sum[k], upper[k]);
    }
}

static int push_depth(struct ordinary *model, int64_t number, bool flows, struct pass *pass)
{
    if (!model->plastic) return ELASTIC;
    const bool yields = flows && ordinary_plastic_flows(model, number);
    profile_count(model->bonds->body->profile, WORK_FLOW_STRIPS, yields, 1);
    if (yields) {
        pass->slip = ordinary_plastic_room(model, number);
        return YIELDING;
    }
    pass->slip = ordinary_plastic_slip(model, number);
    return pass->slip.end[0] ? STORED : ELASTIC;
}

static void push_lattice(struct ordinary *model, struct body *body, int64_t number, bool flows)
{
    const struct bond_strip *strip = &model->bonds->strips[number];
    const struct bond_geometry *g = &model->bonds->geometry[strip->offset];
    const int64_t i = strip->i, j = i + g->shift;
    double buffer[3][BOND_LANES];
    struct pass pass;
    const int what = pass_on_lattice(model, body, strip, &pass),
              depth = push_depth(model, number, flows, &pass);
    for (int k = 0; k < (depth == YIELDING ? NODE_COUNT : NODE_FLOW); k++) {
        pass.node_lower[k] = model->node[k] + i;
        pass.node_upper[k] = model->node[k] + j;
    }
    for (int a = 0; a < 3; a++) {
        pass.f_lower[a] = body->f[a] + i;
        pass.f_upper[a] = body->f[a] + j;
    }
    if (!g->apart) bond_detour(3, buffer, strip->count, pass.f_upper);
    pushing[depth][what](&pass);
    if (!g->apart) bond_detour_end(3, buffer, strip->count, body->f, j);
}

static void push_scattered_strip(struct ordinary *model, struct body *body, int64_t number,
                                 bool flows)
{
    const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[number]);
    double displacement[6][BOND_LANES], gathered[2][NODE_COUNT][BOND_LANES],
        force[2][3][BOND_LANES];
    struct pass pass;
    pass_over(model, body, &view, displacement, &pass);
    const int depth = push_depth(model, number, flows, &pass);
    for (int k = 0; k < (depth == YIELDING ? NODE_COUNT : NODE_FLOW); k++) {
        pass.node_lower[k] = bond_gather(&view, false, model->node[k], gathered[0][k]);
        pass.node_upper[k] = bond_gather(&view, true, model->node[k], gathered[1][k]);
    }
    for (int a = 0; a < 3; a++) {
        pass.f_lower[a] = bond_target(&view, false, body->f[a], force[0][a]);
        pass.f_upper[a] = bond_target(&view, true, body->f[a], force[1][a]);
    }
    pushing[depth][SCATTERED](&pass);
    for (int a = 0; a < 3; a++) {
        bond_scatter(&view, false, body->f[a], force[0][a]);
        bond_scatter(&view, true, body->f[a], force[1][a]);
    }
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
        (lattice_is_scattered(body->lattice) ? sum_scattered_strip : sum_lattice)(model, body, s,
                                                                                  depth);
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
        (lattice_is_scattered(body->lattice) ? push_scattered_strip : push_lattice)(model, body, s,
                                                                                    flows);
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

static void ordinary_prepare(void *self, struct body *body, int rows)
{
    struct ordinary *model = self;
    body_need_gradient(body);
    find_nodes(model, body, body->S, (struct force_mode){0}, NULL);
    displacement_gradient(body);
    body_clear(body, body->S, 3 * rows);
    for (int64_t s = 0; s < model->bonds->count; s++) add_stress(model, body, s, rows);
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
