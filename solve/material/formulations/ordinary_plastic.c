/* ordinary_plastic.c - J2 plasticity of the linear peridynamic solid, with any hardening law.
 *
 *   c_i = sum_j w |xi| (e - e^p) V_j / sum_j w |xi|^2 V_j                      (ordinary_plastic.1)
 *   q_i = [3 mu b_i sum_j w (e - e^p - c_i |xi|)^2 V_j]^1/2 <= sigma_y(p)      (ordinary_plastic.2)
 *   return: q_trial - 3 mu g = sigma_y(p + g),  p += g,
 *           e^p += (3 mu g/q_trial) (e - e^p - c_i |xi|)                       (ordinary_plastic.3)
 *
 * Mitchell, A nonlocal, ordinary, state-based plasticity model for peridynamics, SAND2011-3166,
 * with the yield function scaled by the shear modulus, so that q is von Mises' stress in uniform
 * strain of a continuum, and with hardening.  In an unbroken family c = theta/3: e^p changes no
 * volume, and stays so; theta is that of e - e^p, which keeps the flow of the bonds left out of it
 * once others have broken.  The return minimises (b/2) sum w (e - e^p)^2 V + integral of sigma_y
 * over e^p without change of volume, the incremental potential, of which the force is the gradient
 * in a broken family, too.
 *
 * The sum of squares needs no pass of its own: sum w (q - c |xi|)^2 V = sum w q^2 V - c sum w |xi|
 * q V.  So the return is made node by node, in vectors over strips of nodes, between the two passes
 * of ordinary.c, which move e^p on.  e^p is all that is kept of a bond, and the second pass waits
 * for it to come from memory: the strips of a line lie behind each other, lower ends before upper
 * ones, and a line none of whose nodes has yielded has no e^p at all. */
#include "checkpoint.h"
#include "degradation.h"
#include "flow_curve.h"
#include "integrity.h"
#include "laws.h"
#include "memory.h"
#include "ordinary.h"
#include "radial_return.h"
#include "yield.h"

#include <math.h>
#include <stdlib.h>

struct ordinary_plastic {
    double *strain;      /* p, a box field */
    double *degradation; /* records of all sites; NULL: no node degrades */
    double **slip;       /* [lines of bonds] e^p, or NULL */
    int64_t *first;      /* [lines + 1] what the strips of a line store before them */
    int lines;
    const double *table; /* flow curves by pair */
};

/* The law of bonds declares keys and state as laws of points do; the two passes of ordinary.c are
 * its update. */
static const struct state states[] = {STATE_PLASTIC_STRAIN};
const struct law law_mitchell = {
    .words = {"mitchell",
              "of ordinary_plastic alone: plasticity of bonds, for a few per cent of strain",
              {YIELD_KEYS, yield_keys}},
    .parameters = sizeof(struct yield),
    .n_states = 1,
    .states = states,
    .flow_stress = -1,
    .read = yield_read,
    .release = yield_release,
    .yield = yield_of,
    .pairs = yield_pairs,
};

struct ordinary_plastic *ordinary_plastic_new(const struct ordinary *model)
{
    struct ordinary_plastic *plastic = memory_new(1, sizeof *plastic);
    const struct body *body = model->bonds->body;
    const size_t sites = (size_t)body->grid.n_sites;
    const struct bonds *bonds = model->bonds;
    plastic->table = materials_pairs(model->materials, &law_mitchell);
    plastic->strain = memory_new(sites, sizeof(double));
    if (body->integrity) {
        plastic->degradation = memory_new(DEGRADATION * sites, sizeof(double));
        for (size_t i = 0; i < sites; i++) plastic->degradation[i] = 1; /* LAST_INTEGRITY */
    }
    plastic->lines = bonds->lines;
    plastic->slip = memory_new((size_t)bonds->lines, sizeof *plastic->slip);
    plastic->first = memory_new((size_t)bonds->lines + 1, sizeof *plastic->first);
    for (int64_t s = bonds->count - 1; s >= 0; s--)
        plastic->first[bonds->strips[s].line] = bonds->strips[s].store;
    plastic->first[bonds->lines] = bonds->points;
    return plastic;
}

void ordinary_plastic_free(struct ordinary_plastic *plastic)
{
    for (int l = 0; l < plastic->lines; l++) free(plastic->slip[l]);
    free(plastic->slip);
    free(plastic->first);
    free(plastic->strain);
    free(plastic->degradation);
    free(plastic);
}

/* Lower ends of all strips of a line, then upper ends, so that memory is read on end. */
struct slip ordinary_plastic_slip(const struct ordinary *model, int64_t number)
{
    const struct ordinary_plastic *plastic = model->plastic;
    const struct bond_strip *strip = &model->bonds->strips[number];
    double *slip = plastic->slip[strip->line];
    if (!slip) return (struct slip){{NULL, NULL}};
    const int64_t *first = &plastic->first[strip->line];
    slip += strip->store - first[0];
    return (struct slip){{slip, slip + (first[1] - first[0])}};
}

void ordinary_plastic_make_slip(struct ordinary *model, int64_t number)
{
    struct ordinary_plastic *plastic = model->plastic;
    const int line = model->bonds->strips[number].line;
    const int64_t bonds = plastic->first[line + 1] - plastic->first[line];
    if (!plastic->slip[line]) plastic->slip[line] = memory_new(2 * (size_t)bonds, sizeof(double));
}

const double *ordinary_plastic_strain(const struct ordinary *model)
{
    return model->plastic->strain;
}

HS_SIMD static int64_t any_beyond(int count, const double *restrict a, const double *restrict b)
{
    int64_t any = 0;
    for (int k = 0; k < count; k++) any |= (a[k] > 0) | (b[k] > 0);
    return any;
}

bool ordinary_plastic_flows(const struct ordinary *model, int64_t strip)
{
    const struct bond_view view = bonds_view(model->bonds, &model->bonds->strips[strip]);
    const double *flow = model->node[NODE_FLOW];
    double lower[BOND_LANES], upper[BOND_LANES];
    return any_beyond(view.count, bond_gather(&view, false, flow, lower),
                      bond_gather(&view, true, flow, upper)) != 0;
}

/* A strip of nodes. */
struct strip_state {
    double mu[LANES], centre[LANES], square[LANES], q[LANES], yield[LANES];
    double increment[LANES], scale[LANES], open[LANES], shift[LANES];
    int64_t curve[LANES];
};

/* (ordinary_plastic.1), (ordinary_plastic.2); returns whether a node is beyond yield. */
HS_SIMD static int64_t trial(int count, const double *restrict distortion,
                             const double *restrict dilatation, const double *restrict square,
                             const double *restrict weighted_volume, const double *restrict p,
                             const double *restrict table, struct strip_state *restrict s)
{
    int64_t beyond = 0;
    for (int i = 0; i < count; i++) {
        double along = dilatation[i];
        double centre = weighted_volume[i] > 0 ? along / weighted_volume[i] : 0;
        double deviatoric = square[i] - centre * along;
        deviatoric = deviatoric > 0 ? deviatoric : 0;
        double q = sqrt(3 * s->mu[i] * distortion[i] * deviatoric);
        s->centre[i] = centre;
        s->square[i] = deviatoric;
        s->q[i] = q;
        s->scale[i] = 1;
        s->increment[i] = 0;
        double yield = flow_stress(table, flow_cell(s->curve[i], p[i]), p[i]) + s->shift[i];
        s->yield[i] = yield;
        beyond |= q > yield;
    }
    return beyond;
}

/* The force after the return: t = k D theta a + b w [scale (e - e^p) + (1 - scale) c |xi|]. */
HS_SIMD static void write_nodes(int count, const double *restrict volumetric,
                                const double *restrict distortion,
                                const double *restrict dilatation,
                                const struct strip_state *restrict s, double *restrict pull,
                                double *restrict spring, double *restrict flow,
                                double *restrict centre)
{
    for (int i = 0; i < count; i++) {
        double flowed = 1 - s->scale[i];
        pull[i] = volumetric[i] * dilatation[i] + distortion[i] * flowed * s->centre[i];
        spring[i] = distortion[i] * s->scale[i];
        flow[i] = flowed;
        centre[i] = s->centre[i];
    }
}

/* Stored energy and plastic work of sound nodes, per volume. */
static void find_energy(const struct ordinary *model, const struct strip *strip,
                        const struct strip_state *s, double *stored, double *plastic)
{
    const double *table = model->plastic->table;
    for (int k = 0; k < strip->count; k++) {
        const int64_t i = strip->site + k;
        const double along = model->sum[SUM_DILATATION][i],
                     p = model->plastic->strain[i] + s->increment[k];
        stored[k] = 0.5 * (model->volumetric[i] * along * along +
                           model->distortion[i] *
                               (s->centre[k] * along + s->scale[k] * s->scale[k] * s->square[k]));
        plastic[k] = flow_work(table, flow_cell(s->curve[k], p), p) + s->shift[k] * p;
    }
}

/* Degrades what write_nodes and find_energy have found: (degradation.1) with the force states for
 * P. */
static void degrade(struct ordinary *model, const struct strip *strip, const struct strip_state *s,
                    const double *integrity, bool commit, double *stored, double *plastic)
{
    const double *table = model->plastic->table;
    const int64_t i = strip->site, stride = model->bonds->body->grid.n_sites;
    double dissipating[LANES], *record = model->plastic->degradation + i;
    for (int k = 0; k < strip->count; k++) {
        const double p = model->plastic->strain[i + k];
        dissipating[k] =
            plastic[k] - (flow_work(table, flow_cell(s->curve[k], p), p) + s->shift[k] * p);
    }
    if (commit) degradation_book(strip->count, integrity, dissipating, stored, record, stride);
    for (int k = 0; k < strip->count; k++) {
        model->node[NODE_PULL][i + k] *= integrity[k];
        model->node[NODE_SPRING][i + k] *= integrity[k];
        stored[k] *= integrity[k];
        plastic[k] -= record[k + WITHHELD * stride];
    }
}

static void add_energy(const struct body *body, const struct strip *strip, double *stored,
                       double *plastic, struct force_energy *energy)
{
    body_times_volume(body, strip->site, strip->count, stored);
    body_times_volume(body, strip->site, strip->count, plastic);
    exact_sum_add_strip(&energy->stored, strip->count, stored, 1);
    exact_sum_add_strip(&energy->plastic, strip->count, plastic, 1);
}

static int64_t try_strip(const struct ordinary *model, const struct body *body,
                         const struct strip *strip, struct strip_state *s)
{
    const struct materials *all = model->materials;
    const int64_t i = strip->site;
    for (int k = 0; k < strip->count; k++) {
        const int phase = body->grid.phase[i + k];
        s->mu[k] = all->items[phase].shear_modulus;
        s->curve[k] = phase * (all->count + 1);
        s->shift[k] = body->yield_shift ? body->yield_shift[i + k] : 0;
    }
    return trial(strip->count, model->distortion + i, model->sum[SUM_DILATATION] + i,
                 model->sum[SUM_SQUARE] + i, model->weighted_volume + i, model->plastic->strain + i,
                 model->plastic->table, s);
}

bool ordinary_plastic_beyond(const struct ordinary *model, const struct body *body)
{
    struct strip_state state;
    double most = 0;
    for (int64_t s = 0; s < body->owned.count && most == 0; s++)
        if (try_strip(model, body, &body->owned.items[s], &state)) most = 1;
    ranks_sum(&most, 1);
    return most > 0;
}

static void update_strip(struct ordinary *model, const struct body *body, const struct strip *strip,
                         struct force_mode mode, struct force_energy *energy)
{
    const int64_t i = strip->site;
    double *p = model->plastic->strain + i, *const *sum = model->sum, *const *node = model->node;
    double sound[3][LANES]; /* what need not be kept before anything yields */
    const bool kept = node[NODE_FLOW] != NULL;
    struct strip_state s;
    const int64_t beyond = try_strip(model, body, strip, &s);
    if (beyond && !mode.frozen)
        radial_return(&(struct radial_return){strip->count, s.mu, s.q, s.yield, p, s.shift, s.curve,
                                              s.increment, s.scale, s.open, model->plastic->table});
    write_nodes(strip->count, model->volumetric + i, model->distortion + i, sum[SUM_DILATATION] + i,
                &s, node[NODE_PULL] + i, kept ? node[NODE_SPRING] + i : sound[0],
                kept ? node[NODE_FLOW] + i : sound[1], kept ? node[NODE_CENTRE] + i : sound[2]);
    double stored[LANES], plastic[LANES];
    const double *integrity = integrity_of_nodes(body, i, strip->count);
    const bool commit = mode.commit && !mode.frozen;
    if (energy || integrity) find_energy(model, strip, &s, stored, plastic);
    if (integrity) degrade(model, strip, &s, integrity, commit, stored, plastic);
    if (energy) add_energy(body, strip, stored, plastic, energy);
    if (commit)
        for (int k = 0; k < strip->count; k++) p[k] += s.increment[k];
}

void ordinary_plastic_nodes(struct ordinary *model, const struct body *body, struct force_mode mode,
                            struct force_energy *energy)
{
    for (int64_t s = 0; s < body->owned.count; s++)
        update_strip(model, body, &body->owned.items[s], mode, energy);
}

/* Lines that have not yielded keep nothing. */
static bool place_slip(void *owner, int64_t strip, int point, bool make, double *places[])
{
    struct ordinary *model = owner;
    if (make) ordinary_plastic_make_slip(model, strip);
    const struct slip slip = ordinary_plastic_slip(model, strip);
    for (int end = 0; slip.end[0] && end < 2; end++) places[end] = slip.end[end] + point;
    return slip.end[0] != NULL;
}

void ordinary_plastic_visit(struct ordinary *model, const struct body *body,
                            struct checkpoint *checkpoint)
{
    struct ordinary_plastic *plastic = model->plastic;
    double *records[DEGRADATION];
    checkpoint_fields(checkpoint, "ordinary: equivalent plastic strain", &plastic->strain, 1);
    for (int k = 0; plastic->degradation && k < DEGRADATION; k++)
        records[k] = plastic->degradation + k * body->grid.n_sites;
    if (plastic->degradation)
        checkpoint_fields(checkpoint, "ordinary: degradation", records, DEGRADATION);
    checkpoint_bonds(checkpoint, "ordinary: plastic extension", 2, place_slip, model);
}
