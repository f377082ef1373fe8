/* capped.c - a bond spring on the non-uniform part of the motion that yields like the material.
 *
 *   z = y_j - y_i - Fbar (xi + zeta),  Fbar = (F_i + F_j)/2, zeta the slip               (capped.1)
 *   energy V^2 c w |z|^2 a bond (unordered);  tau = 2 V c w z                           (capped.2)
 *   f_i += tau, f_j -= tau;  S_i, S_j -= tau (x) (xi + zeta) / 2
 *   c = G M/kappa_0, kappa_0 = K_11 of the full family, M = lambda + 4 mu, of a bond    (capped.3)
 *       between phases 2 M_i M_j/(M_i + M_j): its halves are springs in series
 *   |z| <= z_c = C (q_i + q_j)/(2 E) |xi|, q the flow stress of the ends                (capped.4)
 *   beyond it the slip takes the excess but 0.1 %: zeta += Fbar^-1 (excess)
 *
 * The slip is kept in the reference configuration, so that it turns with the material.  Where nodes
 * degrade, tau and the energy are multiplied by the integrity that the ends give the bond
 * (integrity.h); the cap is that of the sound material.
 *
 * The elastic part has the scale of Wan, Chen, Xiao, Chen, Acta Mech. Sin. 35 (2019), and the form
 * of Silling, Comput. Methods Appl. Mech. Engrg. 322 (2017) 42; capping it is this program's own,
 * so that it does not act as a strain-gradient stiffness in plastic flow.
 *
 * The springs are made of all bonds of the family, so that longer horizons, whose gradient sees
 * less of short waves, have more of them.  One strip of bonds is worked on at a time, its springs
 * in buffers: stiffness, cap, z, slip, and then the forces at lower ends before those at upper
 * ones, which fixes the order of each node's terms. */
#include "broken.h"
#include "checkpoint.h"
#include "integrity.h"
#include "memory.h"
#include "stabilisation.h"

#include <math.h>
#include <stdlib.h>

enum { STATE = 4 };

struct capped {
    double stiffness, cap; /* G, C */
    const struct materials *materials;
    double shape;    /* kappa_0 in lattice units */
    double *modulus; /* M of pairs of phases [Pa] */
    double *state;   /* strip by strip: zeta [m], then the energy lost so far [J/m^3] */
    double *before;  /* integrity at the last commit; NULL: no node degrades */
};

static const struct key keys[] = {
    {"stiffness", KEY_NUMBER, offsetof(struct capped, stiffness), "1", 1e-3, 10, .usual = 0.3,
     .help = "G, of the springs over that of the material"},
    {"cap", KEY_NUMBER, offsetof(struct capped, cap), "1", 1e-4, 1e3, .usual = 0.05,
     .help = "C, at which a spring slips: shares of the strain at yield"},
};
/* Share of the excess that stays elastic, for a positive tangent; that of each step anew, which is
 * an error that grows with the step. */
static const double hardening = 0.001;

static int capped_bonds(const void *self, const struct family *family,
                        const struct offset **offsets)
{
    (void)self;
    *offsets = family->half;
    return family->n_half;
}

static void find_moduli(struct capped *c)
{
    const struct materials *all = c->materials;
    const int n = all->count;
    c->modulus = memory_new((size_t)(n * n), sizeof *c->modulus);
    for (int pair = 0; pair < n * n; pair++) {
        const int i = pair / n * (n + 1), j = pair % n * (n + 1);
        const double Mi = all->bulk[i] - 2 * all->shear[i] / 3 + 4 * all->shear[i],
                     Mj = all->bulk[j] - 2 * all->shear[j] / 3 + 4 * all->shear[j];
        c->modulus[pair] = i == j ? Mi : 2 * Mi * Mj / (Mi + Mj);
    }
}

static void capped_start(void *self, const struct body *body, const struct materials *materials,
                         const struct strips bonds[], double *nominal)
{
    struct capped *c = self;
    const struct family *family = body->family;
    (void)bonds, (void)nominal;
    c->materials = materials;
    find_moduli(c);
    for (int o = 0; o < family->n_half; o++) {
        const struct offset *offset = &family->half[o];
        if (body->lattice->dimensions == 2 && offset->step[2] != 0) continue;
        c->shape += 2 * offset->weight * offset->step[0] * offset->step[0];
    }
    const size_t points = (size_t)body->bonds->points;
    c->state = memory_new(points * STATE, sizeof *c->state);
    if (!body->integrity) return;
    c->before = memory_new(points, sizeof *c->before);
    for (size_t k = 0; k < points; k++) c->before[k] = 1;
}

/* What one strip of bonds works on. */
struct springs {
    int count;
    double slip[3][LANES]; /* m, what z loses in this step */
    double z[3][LANES], cap[LANES];
    double stiffness[LANES]; /* 2 V c w with the mean volume, so that tau = stiffness z */
    double at_lower[LANES], at_upper[LANES]; /* the same with the volume of the other end */
};

HS_SIMD static void difference(int count, const double *restrict ui, const double *restrict uj,
                               double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] = uj[i] - ui[i];
}

HS_SIMD static void subtract(int count, const double *restrict Hi, const double *restrict Hj,
                             double half_xi, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] -= half_xi * (Hi[i] + Hj[i]);
}

/* out -= (H_i + H_j)/2 zeta for one component of zeta */
HS_SIMD static void subtract_slip(int count, const double *restrict Hi, const double *restrict Hj,
                                  const double *restrict zeta, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] -= 0.5 * (Hi[i] + Hj[i]) * zeta[i];
}

HS_SIMD static void subtract_zeta(int count, const double *restrict zeta, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] -= zeta[i];
}

/* (capped.4): finds the elastic z and the excess; the energy lost moves on only where commit = 1.
 */
HS_SIMD static int64_t slip(int count, struct springs *restrict s, double *restrict lost,
                            double cap_on, double commit)
{
    int64_t any = 0;
    for (int i = 0; i < count; i++) {
        double x = s->z[0][i], y = s->z[1][i], z = s->z[2][i];
        double length = sqrt(x * x + y * y + z * z);
        double excess = (1 - s->cap[i] / (length > 0 ? length : 1)) / (1 + hardening);
        excess = length > s->cap[i] ? cap_on * excess : 0;
        s->slip[0][i] = excess * x;
        s->slip[1][i] = excess * y;
        s->slip[2][i] = excess * z;
        s->z[0][i] = (1 - excess) * x;
        s->z[1][i] = (1 - excess) * y;
        s->z[2][i] = (1 - excess) * z;
        any |= excess > 0;
        /* work of the force after the slip: that of a bond that slides, however far in one step */
        lost[i] += commit * s->stiffness[i] * (1 - excess) * excess * length * length;
    }
    return any;
}

/* zeta += Fbar^-1 slip */
HS_SIMD static void add_slip(int count, const struct springs *restrict s,
                             const double (*restrict F)[LANES], double *restrict px,
                             double *restrict py, double *restrict pz)
{
    for (int i = 0; i < count; i++) {
        double x = s->slip[0][i], y = s->slip[1][i], z = s->slip[2][i];
        double xx = F[4][i] * F[8][i] - F[5][i] * F[7][i],
               yx = F[5][i] * F[6][i] - F[3][i] * F[8][i],
               zx = F[3][i] * F[7][i] - F[4][i] * F[6][i];
        double scale = 1 / (F[0][i] * xx + F[1][i] * yx + F[2][i] * zx);
        px[i] += scale * (xx * x + (F[2][i] * F[7][i] - F[1][i] * F[8][i]) * y +
                          (F[1][i] * F[5][i] - F[2][i] * F[4][i]) * z);
        py[i] += scale * (yx * x + (F[0][i] * F[8][i] - F[2][i] * F[6][i]) * y +
                          (F[2][i] * F[3][i] - F[0][i] * F[5][i]) * z);
        pz[i] += scale * (zx * x + (F[1][i] * F[6][i] - F[0][i] * F[7][i]) * y +
                          (F[0][i] * F[4][i] - F[1][i] * F[3][i]) * z);
    }
}

static void commit_slip(const struct springs *s, const struct body *body,
                        const struct bond_view *view, double *const zeta[3])
{
    double F[9][LANES];
    for (int k = 0; k < 9; k++)
        for (int l = 0; l < s->count; l++)
            F[k][l] = (k % 4 == 0) +
                      0.5 * (body->H[k][bond_lower(view, l)] + body->H[k][bond_upper(view, l)]);
    add_slip(s->count, s, (const double(*)[LANES])F, zeta[0], zeta[1], zeta[2]);
}

/* A bond that is broken, or has an end without a deformation gradient, carries nothing and keeps
 * its slip. */
static bool carries(const struct body *body, double weight, int64_t i, int64_t j)
{
    if (!(weight > 0)) return false;
    return !body->broken || !(broken_lost(body->broken, i) || broken_lost(body->broken, j));
}

static void find_caps(const struct capped *c, struct springs *s, const struct body *body,
                      const struct bond_view *view, const double *flow)
{
    const struct materials *all = c->materials;
    const double spacing = body->lattice->spacing;
    for (int k = 0; k < s->count; k++) {
        const int64_t i = bond_lower(view, k), j = bond_upper(view, k);
        const int pair = body->grid.phase[i] * all->count + body->grid.phase[j],
                  g = k * view->geometry_step;
        const double mu = all->shear[pair], bulk = all->bulk[pair],
                     weight = view->weight[k * view->weight_step];
        const double youngs = 9 * bulk * mu / (3 * bulk + mu);
        const bool whole = carries(body, weight, i, j);
        s->cap[k] =
            whole ? c->cap * (flow[i] + flow[j]) / (2 * youngs) * view->length[g] : INFINITY;
        s->stiffness[k] =
            whole ? 2 * weight * c->stiffness * c->modulus[pair] / (c->shape * spacing * spacing)
                  : 0;
        s->at_lower[k] = s->stiffness[k] * (view->volume_j[g] / body->volume);
        s->at_upper[k] = s->stiffness[k] * (view->volume_i[g] / body->volume);
    }
}

/* Of the way apart by the mean gradient. */
static void add_mean(struct springs *s, const struct body *body, const struct bond_view *view)
{
    for (int a = 0; a < 3; a++)
        for (int k = 0; k < s->count; k++)
            for (int b = 0; b < 3; b++)
                s->z[a][k] +=
                    body->lattice_gradient[3 * a + b] * view->xi[b][k * view->geometry_step];
}

/* (capped.1) */
static void find_z(struct springs *s, const struct body *body, const struct bond_view *view,
                   double *const zeta[3])
{
    double ends[2][LANES];
    for (int a = 0; a < 3; a++) {
        difference(s->count, bond_gather(view, false, body->u[a], ends[0]),
                   bond_gather(view, true, body->u[a], ends[1]), s->z[a]);
    }
    if (lattice_is_periodic(body->lattice)) add_mean(s, body, view);
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            const double *Hi = bond_gather(view, false, body->H[3 * a + b], ends[0]),
                         *Hj = bond_gather(view, true, body->H[3 * a + b], ends[1]);
            if (view->geometry_step)
                subtract_slip(s->count, Hi, Hj, view->xi[b], s->z[a]);
            else if (view->xi[b][0] < 0 || view->xi[b][0] > 0)
                subtract(s->count, Hi, Hj, 0.5 * view->xi[b][0], s->z[a]);
            subtract_slip(s->count, Hi, Hj, zeta[b], s->z[a]);
        }
        subtract_zeta(s->count, zeta[a], s->z[a]);
    }
}

HS_SIMD static void add_force(int count, const double *restrict z, const double *restrict stiffness,
                              double factor, double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] += factor * stiffness[i] * z[i];
}

HS_SIMD static void add_slip_stress(int count, const double *restrict z,
                                    const double *restrict stiffness, const double *restrict zeta,
                                    double *restrict out)
{
    for (int i = 0; i < count; i++) out[i] -= 0.5 * stiffness[i] * z[i] * zeta[i];
}

/* (capped.2) at the lower or the upper ends. */
static void add_to_end(const struct springs *s, struct body *body, const struct bond_view *view,
                       bool upper, double *const zeta[3])
{
    const double *stiffness = upper ? s->at_upper : s->at_lower;
    double buffer[LANES];
    for (int a = 0; a < 3; a++) {
        add_force(s->count, s->z[a], stiffness, upper ? -1 : 1,
                  bond_target(view, upper, body->f[a], buffer));
        bond_scatter(view, upper, body->f[a], buffer);
        for (int b = 0; b < 3; b++) {
            double *S = bond_target(view, upper, body->S[3 * a + b], buffer);
            add_slip_stress(s->count, s->z[a], stiffness, zeta[b], S);
            if (view->geometry_step)
                add_slip_stress(s->count, s->z[a], stiffness, view->xi[b], S);
            else if (view->xi[b][0] < 0 || view->xi[b][0] > 0)
                add_force(s->count, s->z[a], stiffness, -0.5 * view->xi[b][0], S);
            bond_scatter(view, upper, body->S[3 * a + b], buffer);
        }
    }
}

static void degrade(struct springs *s, const double *integrity)
{
    for (int k = 0; k < s->count; k++) {
        s->stiffness[k] *= integrity[k];
        s->at_lower[k] *= integrity[k];
        s->at_upper[k] *= integrity[k];
    }
}

/* What degrading since the last commit has released: (degradation.2) with the energy of now for the
 * mean of the step, by which its error is of first order, of energies that the cap keeps small;
 * sound: stiffness without damage. */
static void add_released(const struct springs *s, const double *sound, const double *integrity,
                         double *before, double *lost)
{
    for (int k = 0; k < s->count; k++) {
        const double square =
            s->z[0][k] * s->z[0][k] + s->z[1][k] * s->z[1][k] + s->z[2][k] * s->z[2][k];
        lost[k] += 0.5 * sound[k] * square * (before[k] - integrity[k]);
        before[k] = integrity[k];
    }
}

static void capped_energy(const struct body *body, const struct springs *s,
                          const struct bond_view *view, const double *lost,
                          struct force_energy *energy)
{
    for (int k = 0; k < s->count; k++) {
        const int64_t site = bond_lower(view, k);
        if (!(body->grid.flags[site] & SITE_OWNED)) continue; /* counted by the owner */
        const double volume = body_volume(body, site);
        double square = s->z[0][k] * s->z[0][k] + s->z[1][k] * s->z[1][k] + s->z[2][k] * s->z[2][k];
        exact_sum_add(&energy->stabilisation, 0.5 * volume * s->at_lower[k] * square);
        exact_sum_add(&energy->plastic,
                      volume * (view->volume_j[k * view->geometry_step] / body->volume) * lost[k]);
    }
}

/* (macroscopic.2): tau (x) xi of the bonds; what Fbar takes off it comes with the nodes' stress. */
static void sum_stress(const struct springs *s, const struct body *body,
                       const struct bond_view *view)
{
    for (int k = 0; k < s->count; k++) {
        const int64_t site = bond_lower(view, k);
        if (!(body->grid.flags[site] & SITE_OWNED)) continue; /* counted by the owner */
        const double whole = body_volume(body, site) * s->at_lower[k];
        for (int c = 0; c < 9; c++)
            exact_sum_add(&body->stress_sums[c],
                          whole * s->z[c / 3][k] * view->xi[c % 3][k * view->geometry_step]);
    }
}

/* Of state and before the first bond's entries; the components of state are stride apart. */
static void add_part(const struct capped *c, struct body *body, const struct bond_view *view,
                     double *state, double *before, const double *flow, struct force_mode mode,
                     struct force_energy *energy)
{
    double *const zeta[3] = {state, state + view->stride, state + 2 * view->stride},
                  *lost = state + 3 * view->stride;
    struct springs s = {.count = view->count};
    find_caps(c, &s, body, view, flow);
    double buffer[LANES], sound[LANES];
    const double *integrity = integrity_of_bonds(body, view, buffer);
    memcpy(sound, s.stiffness, (size_t)s.count * sizeof *sound);
    if (integrity) degrade(&s, integrity);
    find_z(&s, body, view, zeta);
    int64_t any = slip(s.count, &s, lost, mode.frozen ? 0 : 1, mode.commit ? 1 : 0);
    add_to_end(&s, body, view, false, zeta);
    add_to_end(&s, body, view, true, zeta);
    if (body->stress_sums) sum_stress(&s, body, view);
    if (integrity && mode.commit) add_released(&s, sound, integrity, before, lost);
    if (any && mode.commit) commit_slip(&s, body, view, zeta);
    if (mode.energy) capped_energy(body, &s, view, lost, energy);
}

/* In parts of at most LANES, cut where strips of nodes are, whatever a rank holds. */
static void capped_add(void *self, struct body *body, const struct bond_strip *strip,
                       const double *flow, struct force_mode mode, struct force_energy *energy)
{
    struct capped *c = self;
    const struct bond_view view = bonds_view(body->bonds, strip);
    int at[3] = {0};
    if (!view.lower) grid_position(&body->grid, view.i, at);
    for (int first = 0, count; first < view.count; first += count) {
        count = LANES - (at[0] + first) % LANES;
        if (count > view.count - first) count = view.count - first;
        const struct bond_view part = bonds_part(&view, first, count);
        add_part(c, body, &part, c->state + STATE * strip->store + first,
                 c->before ? c->before + strip->store + first : NULL, flow, mode, energy);
    }
}

static void capped_visit(void *self, const struct body *body, struct checkpoint *checkpoint)
{
    struct capped *c = self;
    (void)body;
    checkpoint_bond_strips(checkpoint, "capped: slip and loss", STATE, c->state);
    checkpoint_bond_strips(checkpoint, "capped: last integrity", 1, c->before);
}

static void capped_free(void *self)
{
    struct capped *c = self;
    free(c->modulus);
    free(c->state);
    free(c->before);
    free(c);
}

const struct stabilisation stabilisation_capped = {
    .words = {"capped", "springs on the non-uniform part of the motion that slip at a cap",
              KEYS(keys)},
    .size = sizeof(struct capped),
    .bonds = capped_bonds,
    .start = capped_start,
    .add_family = capped_add,
    .visit = capped_visit,
    .free = capped_free,
};
