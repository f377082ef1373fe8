/* mix.c - the node's law and the same law on the bonds to the nearest neighbours, mixed.
 *
 *   Pi = (1 - a) sum_i V psi(F_i) + a sum_b V beta_b psi(F_b),  b over the axis bonds       (mix.1)
 *   F_b = Fbar + (dy - Fbar xi) (x) xi / |xi|^2,  Fbar = (F_i + F_j)/2                      (mix.2)
 *   beta_b = g_ib + g_jb,  g_ib = 1/(n_i c_ib)                                              (mix.3)
 *
 * n_i: number of axes along which node i has a bond, c_ib: its bonds along that axis; so sum_b g_ib
 * = 1 and the bonds of each node carry exactly its volume.  (mix.2) is the bond-associated
 * deformation gradient of Breitzman & Dayal, J. Mech. Phys. Solids 110 (2018) 57; for an axis bond
 * it is Fbar with the column along the bond replaced by the bond's own stretch.  The bonds obey the
 * full law of the nodes (a bond across an interface the mean law of its ends), so the control of
 * the zero-energy modes yields with the material.  A uniform uniaxial stress stays exact at free
 * surfaces for any weights g that depend on the section alone, since both sums of the virtual work
 * cancel by translation along the bar.
 *
 * Where nodes degrade, the stress of a bond is multiplied by the integrity that its ends give it
 * (integrity.h). A broken axis bond, or one with an end that has no deformation gradient any more,
 * carries nothing and keeps its plastic state; the weights g stay those of the whole body, so that
 * no other bond gains energy. */
#include "broken.h"
#include "integrity.h"
#include "memory.h"
#include "points.h"
#include "stabilisation.h"

#include <stdlib.h>
#include <string.h>

struct mix {
    double share;        /* a */
    int number[3];       /* of each axis among the half offsets */
    uint8_t *divisor[3]; /* n_i c_ib of each site's bonds along each axis (box field), 0: none */
    struct point_store *bonds[3]; /* along each axis */
    double *nominal;              /* of the nodes */
};

static const struct offset axes[3] = {{{1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, 0, 1}, 1}};
static const struct key keys[] = {
    {"share", KEY_NUMBER, offsetof(struct mix, share), "1", 0.01, 1, .usual = 0.1,
     .help = "a, of the stress: the rest is the nodes' own"},
};

static int mix_bonds(const void *self, const struct family *family, const struct offset **offsets)
{
    (void)self, (void)family;
    *offsets = axes;
    return 3;
}

static void find_divisors(struct mix *mix, const struct body *body)
{
    for (int64_t s = 0; s < body->near.count; s++)
        for (int i = 0; i < body->near.items[s].count; i++) {
            int64_t site = body->near.items[s].site + i;
            int count[3], along = 0;
            for (int a = 0; a < 3; a++) {
                int64_t step = body->grid.step[a];
                count[a] = (body->grid.phase[site - step] != ABSENT) +
                           (body->grid.phase[site + step] != ABSENT);
                along += count[a] > 0;
            }
            for (int a = 0; a < 3; a++) mix->divisor[a][site] = (uint8_t)(along * count[a]);
        }
}

/* g of both ends (mix.3), and their sum. */
HS_SIMD static void find_shares(int count, const uint8_t *restrict divisor_i,
                                const uint8_t *restrict divisor_j, double *restrict gi,
                                double *restrict gj, double *restrict beta)
{
    static const double share[] = {0, 1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6};
    for (int k = 0; k < count; k++) {
        gi[k] = share[divisor_i[k]];
        gj[k] = share[divisor_j[k]];
        beta[k] = gi[k] + gj[k];
    }
}

static double mix_node_share(const void *self)
{
    return 1 - ((const struct mix *)self)->share;
}

/* (mix.2): two columns are means, the third is the bond's. */
HS_SIMD static void mean_column(int count, const double *restrict Hi, const double *restrict Hj,
                                double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] = 0.5 * (Hi[i] + Hj[i]);
}
HS_SIMD static void bond_column(int count, const double *restrict ui, const double *restrict uj,
                                double inverse_spacing, double mean, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] = (uj[i] - ui[i]) * inverse_spacing + mean;
}

static void bond_gradient(struct points *points, const struct body *body, int axis, int64_t i,
                          int64_t j)
{
    for (int k = 0; k < TENSOR; k++) {
        if (k % 3 == axis)
            bond_column(points->count, body->u[k / 3] + i, body->u[k / 3] + j,
                        1 / body->lattice->spacing, body->lattice_gradient[k], points->H[k]);
        else
            mean_column(points->count, body->H[k] + i, body->H[k] + j, points->H[k]);
    }
}

static void mix_start(void *self, const struct body *body, const struct materials *materials,
                      const struct strips bonds[], double *nominal)
{
    struct mix *mix = self;
    mix->nominal = nominal;
    const size_t sites = (size_t)body->grid.n_sites;
    for (int a = 0; a < 3; a++) {
        mix->number[a] = family_number(body->family, axes[a].step);
        mix->divisor[a] = memory_new(sites, sizeof *mix->divisor[a]);
        mix->bonds[a] = points_new(body, materials, &bonds[a], body->grid.step[a]);
    }
    find_divisors(mix, body);
}

/* The bonds of a strip that carry nothing: how many, and which. */
static int find_off(const struct mix *mix, const struct body *body, int axis,
                    const struct strip *strip, int64_t j, int *off)
{
    const struct broken *broken = body->broken;
    const int64_t i = strip->site;
    int count = 0;
    for (int k = 0; broken && k < strip->count; k++)
        if (broken_bond(broken, i + k, mix->number[axis]) || broken_lost(broken, i + k) ||
            broken_lost(broken, j + k))
            off[count++] = k;
    return count;
}

/* out_i += lower beta P, out_j += upper beta P.  Along x the ends overlap: two sweeps, since the
 * order of the terms must not depend on where a strip ends. */
HS_SIMD static void add_one(int count, const double *restrict P, const double *restrict beta,
                            double weight, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] += weight * beta[i] * P[i];
}
HS_SIMD static void add_two(int count, const double *restrict P, const double *restrict beta,
                            double lower, double upper, double *restrict out_i,
                            double *restrict out_j)
{
    for (int i = 0; i < count; i++) {
        double term = beta[i] * P[i];
        out_i[i] += lower * term;
        out_j[i] += upper * term;
    }
}
static void add_both(int count, const double *P, const double *beta, double lower, double upper,
                     double *out, int64_t step)
{
    if (step > 1) {
        add_two(count, P, beta, lower, upper, out, out + step);
    } else {
        add_one(count, P, beta, lower, out);
        add_one(count, P, beta, upper, out + step);
    }
}

static void mix_energy(const struct mix *mix, const struct body *body, const struct points *points,
                       const double *beta, int64_t site, struct force_energy *energy)
{
    const double scale = mix->share * body->volume;
    double stored[LANES], plastic[LANES];
    for (int i = 0; i < points->count; i++) {
        stored[i] = beta[i] * points->stored[i];
        plastic[i] = beta[i] * points->dissipated[i];
    }
    body_sum_owned(body, site, points->count, stored, scale, &energy->stabilisation);
    body_sum_owned(body, site, points->count, plastic, scale, &energy->plastic);
}

/* (macroscopic.2): what the column along the bond adds; the others come with the nodes' stress. */
static void sum_stress(const struct mix *mix, const struct body *body, int axis,
                       const struct points *points, const double *beta, int64_t site)
{
    double terms[LANES];
    for (int k = axis; k < TENSOR; k += 3) {
        for (int i = 0; i < points->count; i++) terms[i] = beta[i] * points->P[k][i];
        body_sum_owned(body, site, points->count, terms, mix->share * body->volume,
                       &body->stress_sums[k]);
    }
}

static void mix_add(void *self, struct body *body, int axis, const struct strip *strip,
                    struct force_mode mode, struct force_energy *energy)
{
    struct mix *mix = self;
    const int64_t step = body->grid.step[axis], i = strip->site, j = i + step;
    const int count = strip->count;
    struct points points;
    double beta[LANES];
    points_load(mix->bonds[axis], strip, &points);
    bond_gradient(&points, body, axis, i, j);
    int off[LANES];
    const int n_off = find_off(mix, body, axis, strip, j, off);
    for (int k = 0; k < n_off; k++) points_switch_off(&points, off[k]);
    const struct bond_view ends = {.count = count, .i = i, .j = j};
    double integrity[LANES];
    points_update(mix->bonds[axis], strip, &points, mode,
                  integrity_of_bonds(body, &ends, integrity));

    double gi[LANES], gj[LANES];
    find_shares(count, mix->divisor[axis] + i, mix->divisor[axis] + j, gi, gj, beta);
    const double a = mix->share;
    for (int k = 0; k < TENSOR; k++) {
        if (k % 3 == axis) {
            double per_length = a / body->lattice->spacing;
            add_both(count, points.P[k], beta, per_length, -per_length, body->f[k / 3] + i, step);
        } else {
            add_both(count, points.P[k], beta, 0.5 * a, 0.5 * a, body->S[k] + i, step);
        }
    }
    if (body->stress_sums) sum_stress(mix, body, axis, &points, beta, i);
    if (mode.record) {
        const double *axial = points.P[4 * body->lattice->axis];
        add_one(count, axial, gi, a, mix->nominal + i);
        add_one(count, axial, gj, a, mix->nominal + j);
    }
    if (mode.energy) mix_energy(mix, body, &points, beta, i, energy);
}

static void mix_visit(void *self, const struct body *body, struct checkpoint *checkpoint)
{
    static const char *const names[] = {"bonds along x", "bonds along y", "bonds along z"};
    struct mix *mix = self;
    for (int a = 0; a < 3; a++) {
        struct strips strips = grid_bond_strips(&body->grid, axes[a].step, LANES);
        points_visit(mix->bonds[a], checkpoint, names[a], &strips);
        strips_free(&strips);
    }
}

static void mix_free(void *self)
{
    struct mix *mix = self;
    for (int a = 0; a < 3; a++) {
        free(mix->divisor[a]);
        points_free(mix->bonds[a]);
    }
    free(mix);
}

const struct stabilisation stabilisation_mix = {
    .words = {"mix",
              "the law of the nodes on the bonds to the nearest neighbours, too; on a lattice",
              KEYS(keys)},
    .size = sizeof(struct mix),
    .bonds = mix_bonds,
    .start = mix_start,
    .node_share = mix_node_share,
    .add = mix_add,
    .visit = mix_visit,
    .free = mix_free,
};
