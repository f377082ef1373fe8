/* ordinary.c - the two passes over the bonds that all ordinary state-based materials share (ordinary.h). */
#include "ordinary.h"

#include "gradient.h"
#include "integrity.h"
#include "memory.h"
#include "opening.h"

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

/* The strip with the fields of its ends. */
struct pass {
    int count;
    struct bond_ends u;
    const struct bond_view *view;
    const double *reach; /* |xi| or 1, as geometry */
    /* First pass. */
    double *lower[SUM_COUNT], *upper[SUM_COUNT];
    /* Second pass. */
    const double *node_lower[NODE_COUNT], *node_upper[NODE_COUNT];
    double *force_lower[3], *force_upper[3];
    /* e^p of the lower and the upper ends. */
    struct slip slip;
};

/* What a kernel does: sums of the first pass up to this one, and the second's forces without e^p, with it, and with
 * its growth. */
enum { ELASTIC, ENERGY, STORED, YIELDING };

/* First pass over a strip, an element of geometry and weight every g and w. */
HS_INLINE void sum_up(const struct pass *s, int g, int w, int depth)
{
    const struct bond_view *v = s->view;
    const double *ux = s->u.lower[0], *uy = s->u.lower[1], *uz = s->u.lower[2];
    const double *vx = s->u.upper[0], *vy = s->u.upper[1], *vz = s->u.upper[2];
    const double *X = v->xi[0], *Y = v->xi[1], *Z = v->xi[2], *L = v->length, *W = v->weight;
    const double *Vi = v->volume_i, *Vj = v->volume_j, *R = s->reach;
    const double *pi = s->slip.end[0], *pj = s->slip.end[1];
    double *ei = s->lower[SUM_EXTENSION], *ni = s->lower[SUM_SQUARE];
    double *ej = s->upper[SUM_EXTENSION], *nj = s->upper[SUM_SQUARE];
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, R0 = *R;
    const int count = s->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double weight = w ? W[k] : W0, reach = g ? R[k] : R0;
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        x += a;
        y += b;
        z += d;
        double e = longer / (sqrt(x * x + y * y + z * z) + length);
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

/* (ordinary.4); where an end yields, its e^p moves on. */
HS_INLINE void push(const struct pass *s, int g, int w, int depth)
{
    const struct bond_view *v = s->view;
    const double *ux = s->u.lower[0], *uy = s->u.lower[1], *uz = s->u.lower[2];
    const double *vx = s->u.upper[0], *vy = s->u.upper[1], *vz = s->u.upper[2];
    const double *X = v->xi[0], *Y = v->xi[1], *Z = v->xi[2], *L = v->length, *W = v->weight;
    const double *Vi = v->volume_i, *Vj = v->volume_j, *R = s->reach;
    const double *Ai = s->node_lower[NODE_PULL], *Aj = s->node_upper[NODE_PULL];
    const double *Bi = s->node_lower[NODE_SPRING], *Bj = s->node_upper[NODE_SPRING];
    const double *Fi = s->node_lower[NODE_FLOW], *Fj = s->node_upper[NODE_FLOW];
    const double *Ci = s->node_lower[NODE_CENTRE], *Cj = s->node_upper[NODE_CENTRE];
    double *pi = s->slip.end[0], *pj = s->slip.end[1];
    double *ix = s->force_lower[0], *iy = s->force_lower[1], *iz = s->force_lower[2];
    double *jx = s->force_upper[0], *jy = s->force_upper[1], *jz = s->force_upper[2];
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, R0 = *R;
    const int count = s->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double weight = w ? W[k] : W0, reach = g ? R[k] : R0;
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        x += a;
        y += b;
        z += d;
        double now = sqrt(x * x + y * y + z * z), sum = now + length, inverse = 1 / (sum * now);
        double e = longer * (inverse * now);
        double force = (Ai[k] + Aj[k]) * reach + (Bi[k] + Bj[k]) * e;
        if (depth >= STORED) force -= Bi[k] * pi[k] + Bj[k] * pj[k];
        force *= inverse * sum;
        double i = (weight * volume_j) * force, j = (weight * volume_i) * force;
        ix[k] += i * x;
        iy[k] += i * y;
        iz[k] += i * z;
        jx[k] -= j * x;
        jy[k] -= j * y;
        jz[k] -= j * z;
        if (depth == YIELDING) {
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
    VARIANT(name##_alike, kernel, 0, 0, depth)                                                     \
    VARIANT(name##_weighted, kernel, 0, 1, depth)                                                  \
    VARIANT(name##_scattered, kernel, 1, 1, depth)
#define CHOICE(name)                                                                               \
    {                                                                                              \
        {name##_alike, name##_weighted},                                                           \
        {                                                                                          \
            NULL, name##_scattered                                                                 \
        }                                                                                          \
    }
VARIANTS(sum_elastic, sum_up, ELASTIC)
VARIANTS(sum_energy, sum_up, ENERGY)
VARIANTS(sum_stored, sum_up, STORED)
VARIANTS(push_elastic, push, ELASTIC)
VARIANTS(push_stored, push, STORED)
VARIANTS(push_yielding, push, YIELDING)

typedef void kernel(const struct pass *);
/* [depth][geometry_step][weight_step] */
static kernel *const summing[][2][2] = {CHOICE(sum_elastic), CHOICE(sum_energy),
                                        CHOICE(sum_stored)};
static kernel *const pushing[][2][2] = {[ELASTIC] = CHOICE(push_elastic),
                                        [STORED] = CHOICE(push_stored),
                                        [YIELDING] = CHOICE(push_yielding)};

static struct pass pass_over(const struct ordinary *model, const struct bond_view *view,
                             const struct body *body, double buffer[6][LANES])
{
    return (struct pass){.count = view->count,
                         .u = bond_ends_find(view, body, buffer),
                         .view = view,
                         .reach = model->law->by_length ? view->length : ones};
}

/* Strip number s; returns how many have been done, those after it that are alike included. */
static int64_t sum_strip(const struct ordinary *model, const struct body *body, int64_t number,
                         int depth)
{
    struct bond_view view;
    const int64_t done = bonds_line(model->bonds, number, &view);
    double displacement[6][LANES], lower[SUM_COUNT][LANES], upper[SUM_COUNT][LANES];
    struct pass pass = pass_over(model, &view, body, displacement);
    if (model->plastic) pass.slip = ordinary_plastic_slip(model, number);
    if (pass.slip.end[0]) depth = STORED;
    const int count = depth == ELASTIC ? 1 : SUM_COUNT;
    for (int k = 0; k < count; k++) {
        pass.lower[k] = bond_target(&view, false, model->sum[k], lower[k]);
        pass.upper[k] = bond_target(&view, true, model->sum[k], upper[k]);
    }
    summing[depth][view.geometry_step][view.weight_step](&pass);
    for (int k = 0; k < count; k++) {
        bond_scatter(&view, false, model->sum[k], lower[k]);
        bond_scatter(&view, true, model->sum[k], upper[k]);
    }
    return done;
}

static int64_t push_strip(struct ordinary *model, struct body *body, int64_t number, bool flows)
{
    struct bond_view view;
    const int64_t done = bonds_line(model->bonds, number, &view);
    double displacement[6][LANES], gathered[2][NODE_COUNT][LANES], force[2][3][LANES];
    struct pass pass = pass_over(model, &view, body, displacement);
    int depth = ELASTIC;
    if (flows) pass.slip = ordinary_plastic_yielding(model, number, &view);
    if (pass.slip.end[0])
        depth = YIELDING;
    else if (model->plastic)
        pass.slip = ordinary_plastic_slip(model, number);
    if (depth == ELASTIC && pass.slip.end[0]) depth = STORED;
    for (int k = 0; k < (depth == YIELDING ? NODE_COUNT : NODE_FLOW); k++) {
        pass.node_lower[k] = bond_gather(&view, false, model->node[k], gathered[0][k]);
        pass.node_upper[k] = bond_gather(&view, true, model->node[k], gathered[1][k]);
    }
    for (int a = 0; a < 3; a++) {
        pass.force_lower[a] = bond_target(&view, false, body->f[a], force[0][a]);
        pass.force_upper[a] = bond_target(&view, true, body->f[a], force[1][a]);
    }
    pushing[depth][view.geometry_step][view.weight_step](&pass);
    for (int a = 0; a < 3; a++) {
        bond_scatter(&view, false, body->f[a], force[0][a]);
        bond_scatter(&view, true, body->f[a], force[1][a]);
    }
    return done;
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
        double lower[LANES], upper[LANES], *i = bond_target(&view, false, sum, lower),
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

/* First pass, and what the second reads of the nodes, those of other ranks included. */
static void find_nodes(struct ordinary *model, struct body *body, struct force_mode mode,
                       struct force_energy *energy)
{
    const int depth = model->plastic || energy ? ENERGY : ELASTIC;
    halo_exchange(body->displacement_halo, body->u, 3);
    if (model->plastic && model->moment_changes != model->bonds->changes) find_moment(model, body);
    body_clear(body, model->sum, depth == ELASTIC ? 1 : SUM_COUNT);
    for (int64_t s = 0; s < model->bonds->count;) s += sum_strip(model, body, s, depth);
    if (model->plastic)
        ordinary_plastic_nodes(model, body, mode, energy);
    else
        elastic_nodes(model, body, energy);
    halo_exchange(body->stress_halo, model->node, model->plastic ? NODE_COUNT : 1);
}

/* Whether a node that this rank knows is about to flow. */
static bool any_flow(const struct ordinary *model, const struct body *body)
{
    double most = 0;
    if (!model->plastic) return false;
    for (int64_t i = 0; i < body->grid.n_sites; i++) most += model->node[NODE_FLOW][i];
    return most > 0;
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
    find_nodes(model, body, mode, mode.energy ? energy : NULL);
    const bool flows = mode.commit && !mode.frozen && any_flow(model, body);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < model->bonds->count;) s += push_strip(model, body, s, flows);
    if (flows) settle_flow(model, body);
}

/* (ordinary.3) of both ends of the bonds of a strip, whose extensions go to e. */
static void find_states(const struct ordinary *model, const struct bond_view *view,
                        const struct pass *pass, double e[LANES], double state[2][LANES])
{
    bond_ends_extensions(view, &pass->u, e);
    for (int k = 0; k < view->count; k++) {
        const double reach = pass->reach[k * view->geometry_step],
                     weight = view->weight[k * view->weight_step];
        for (int end = 0; end < 2; end++) {
            const double *slip = pass->slip.end[end];
            const int64_t i = end ? bond_upper(view, k) : bond_lower(view, k);
            state[end][k] = weight * (model->node[NODE_PULL][i] * reach +
                                      model->node[NODE_SPRING][i] * (e[k] - (slip ? slip[k] : 0)));
        }
    }
}

static void add_stress(const struct ordinary *model, struct body *body, int64_t number)
{
    const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[number]);
    double displacement[6][LANES], e[LANES], state[2][LANES];
    struct pass pass = pass_over(model, &view, body, displacement);
    if (model->plastic) pass.slip = ordinary_plastic_slip(model, number);
    find_states(model, &view, &pass, e, state);
    bond_ends_add_stress(&view, &pass.u, state[0], state[1], body);
}

/* Energy density that each bond holds: that of the force states of both ends over its elastic extension. */
static void ordinary_bond_energy(const void *self, const struct body *body,
                                 const struct bond_strip *strip, double *energy)
{
    const struct ordinary *model = self;
    const int64_t number = strip - model->bonds->strips;
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][LANES], e[LANES], state[2][LANES];
    struct pass pass = pass_over(model, &view, body, displacement);
    if (model->plastic) pass.slip = ordinary_plastic_slip(model, number);
    find_states(model, &view, &pass, e, state);
    for (int k = 0; k < view.count; k++) {
        const double *lower = pass.slip.end[0], *upper = pass.slip.end[1];
        energy[k] = 0.5 * (state[0][k] * (e[k] - (lower ? lower[k] : 0)) +
                           state[1][k] * (e[k] - (upper ? upper[k] : 0)));
    }
}

static const double *ordinary_plastic(const void *self, const struct strip *strip)
{
    const struct ordinary *model = self;
    return model->plastic ? ordinary_plastic_strain(model) + strip->site : NULL;
}

static void ordinary_prepare(void *self, struct body *body, double *axial)
{
    struct ordinary *model = self;
    find_nodes(model, body, (struct force_mode){0}, NULL);
    displacement_gradient(body);
    body_clear(body, body->S, 9);
    for (int64_t s = 0; s < model->bonds->count; s++) add_stress(model, body, s);
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
    const double *moment = model->moment;
    double *isotropic = model->sum[SUM_EXTENSION];
    const bool corrected = model->correction != SURFACE_NONE;
    const double full = corrected ? surface_full_family(model->bonds, 1) : 1;
    find_moment(model, body);
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
    const size_t n = (size_t)body->grid.n_sites;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 2);
    model->volumetric = memory_new(n, sizeof(double));
    model->distortion = memory_new(n, sizeof(double));
    model->moment = memory_new(n, sizeof(double));
    for (int k = 0; k < SUM_COUNT; k++) model->sum[k] = memory_new(n, sizeof(double));
    model->node[NODE_PULL] = memory_new(n, sizeof(double));
    find_moduli(model, body);
    halo_exchange(body->stress_halo, &model->distortion, 1);
    if (yields_somewhere(model->materials)) {
        for (int k = NODE_SPRING; k < NODE_COUNT; k++)
            model->node[k] = memory_new(n, sizeof(double));
        memcpy(model->node[NODE_SPRING], model->distortion, n * sizeof(double));
        model->plastic = ordinary_plastic_new(model);
    } else {
        model->node[NODE_SPRING] = model->distortion;
        free(model->moment);
        model->moment = NULL;
    }
}

static void ordinary_free(void *self)
{
    struct ordinary *model = self;
    if (model->plastic) {
        ordinary_plastic_free(model->plastic);
        free(model->node[NODE_SPRING]);
    }
    free(model->volumetric);
    free(model->distortion);
    free(model->moment);
    for (int k = 0; k < SUM_COUNT; k++) free(model->sum[k]);
    free(model->node[NODE_PULL]);
    free(model->node[NODE_FLOW]);
    free(model->node[NODE_CENTRE]);
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
