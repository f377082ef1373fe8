/* j2.c - finite-strain J2 plasticity in logarithmic strain.
 *
 *   b = F Cp^-1 F^T,  e = (ln b)/2,  tau = 2 mu dev e + K tr(e) 1,  P = tau F^-T          (j2.1)
 *   q = sqrt(3/2 dev tau : dev tau) <= sigma_y(p)                                         (j2.2)
 *   return: q_trial - 3 mu g = sigma_y(p + g),  dev tau *= 1 - 3 mu g/q_trial,  p += g    (j2.3)
 *   Cp^-1 = F^-1 exp(2 e_elastic) F^-T                                                    (j2.4)
 *
 * Simo, Comput. Methods Appl. Mech. Engrg. 99 (1992) 61, section 3; de Souza Neto, Peric, Owen,
 * Computational Methods for Plasticity (2008), box 14.3.  The flow is volume-preserving, the return
 * exact in the direction of the trial stress, and the stress derives from an incremental potential.
 * No term reaches from one point to another: a point's result depends on its own data alone.
 *
 * The plastic multiplier is the one unknown of a point; a strip solves for all of its points in one
 * vector loop (radial_return.h), and only where one is beyond yield. */
#include "flow_curve.h"
#include "logarithmic.h"
#include "radial_return.h"
#include "yield.h"

#include <math.h>

/* Of the state: Cp^-1, p, and sigma_y(p), which is looked up only where p has changed. */
enum { PLASTIC = SYMMETRIC, FLOW_STRESS };

static const struct state states[] = {
    {"inverse_plastic_metric", "1", SYMMETRIC, 1,
     "Cp^-1, the plastic deformation without its rotation"},
    STATE_PLASTIC_STRAIN,
    {"flow_stress", "Pa", 1, 0, "stress at which the point flows, its flaw and scatter included"},
};

/* What lies between the trial state and the stress. */
struct trial {
    HS_ALIGNED double e[SYMMETRIC][LANES]; /* deviator of the elastic strain */
    double trace[LANES], q[LANES];
    double increment[LANES], scale[LANES], open[LANES]; /* as in radial_return.h */
};

/* (j2.1): elastic trial strain and its deviator's norm; returns whether any point is beyond yield.
 */
HS_SIMD static int64_t trial_strain(int count, const struct points *restrict s,
                                    struct trial *restrict t, const double *restrict xx,
                                    const double *restrict yy, const double *restrict zz,
                                    const double *restrict xy, const double *restrict yz,
                                    const double *restrict zx, const double *restrict flow)
{
    int64_t beyond = 0;
    for (int i = 0; i < count; i++) {
        struct symmetric Cp = {xx[i], yy[i], zz[i], xy[i], yz[i], zx[i]};
        struct symmetric e = half_logarithm(push_forward(deformation_gradient(s, i), Cp));
        double trace = trace_of(e);
        e = scaled(e, 1, -trace / 3);
        t->e[0][i] = e.xx;
        t->e[1][i] = e.yy;
        t->e[2][i] = e.zz;
        t->e[3][i] = e.xy;
        t->e[4][i] = e.yz;
        t->e[5][i] = e.zx;
        t->trace[i] = trace;
        double q = 2 * s->mu[i] * sqrt(1.5 * square_of(e));
        t->q[i] = q;
        t->scale[i] = 1;
        t->increment[i] = 0;
        beyond |= q > flow[i];
    }
    return beyond;
}

/* P of point i; G = F^-1. */
HS_INLINE void point_stress(struct points *restrict s, const struct trial *restrict t, int i,
                            struct tensor G)
{
    struct symmetric e = {t->e[0][i], t->e[1][i], t->e[2][i], t->e[3][i], t->e[4][i], t->e[5][i]};
    write_stress(s, i, G, e, 2 * s->mu[i] * t->scale[i], s->bulk[i] * t->trace[i]);
}

HS_SIMD static void stress(int count, struct points *restrict s, const struct trial *restrict t)
{
    for (int i = 0; i < count; i++)
        point_stress(s, t, i, inverse_tensor(deformation_gradient(s, i)));
}

/* P, and (j2.4) where the point has flowed; points that have not keep their state to the last bit.
 */
HS_SIMD static void stress_and_state(int count, struct points *restrict s,
                                     const struct trial *restrict t, double *restrict xx,
                                     double *restrict yy, double *restrict zz, double *restrict xy,
                                     double *restrict yz, double *restrict zx, double *restrict p,
                                     double *restrict flow, const double *restrict table)
{
    for (int i = 0; i < count; i++) {
        struct tensor G = inverse_tensor(deformation_gradient(s, i));
        point_stress(s, t, i, G);
        double scale = t->scale[i], third = t->trace[i] / 3;
        struct symmetric e = {fused(scale, t->e[0][i], third),
                              fused(scale, t->e[1][i], third),
                              fused(scale, t->e[2][i], third),
                              scale * t->e[3][i],
                              scale * t->e[4][i],
                              scale * t->e[5][i]};
        struct symmetric C = push_forward(G, double_exponential(e));
        double increment = t->increment[i];
        xx[i] = increment > 0 ? C.xx : xx[i];
        yy[i] = increment > 0 ? C.yy : yy[i];
        zz[i] = increment > 0 ? C.zz : zz[i];
        xy[i] = increment > 0 ? C.xy : xy[i];
        yz[i] = increment > 0 ? C.yz : yz[i];
        zx[i] = increment > 0 ? C.zx : zx[i];
        p[i] = p[i] + increment;
        flow[i] = flow_stress(table, flow_cell(s->pair[i], p[i]), p[i]) + s->shift[i];
    }
}

/* The plastic work up to p, of a flow stress that follows from p alone: the integral of sigma_y. */
HS_SIMD static void plastic_work(int count, const struct points *restrict s,
                                 const double *restrict p, const double *restrict table,
                                 double *restrict work)
{
    for (int i = 0; i < count; i++)
        work[i] = flow_work(table, flow_cell(s->pair[i], p[i]), p[i]) + s->shift[i] * p[i];
}

/* before: plastic work before the step. */
HS_SIMD static void energy(int count, struct points *restrict s, const struct trial *restrict t,
                           const double *restrict before)
{
    for (int i = 0; i < count; i++) {
        s->stored[i] = stored_energy(t->scale[i] * t->q[i], s->mu[i], s->bulk[i], t->trace[i]);
        s->dissipating[i] = s->dissipated[i] - before[i];
    }
}

static void start(const void *table, const struct points *s, double *state, int64_t stride)
{
    for (int i = 0; i < s->count; i++)
        state[FLOW_STRESS * stride + i] =
            flow_stress(table, flow_cell(s->pair[i], 0), 0) + s->shift[i];
}

static void update(const void *table, struct points *s, double *state, int64_t stride,
                   struct step step)
{
    double *c[SYMMETRIC], *p = state + PLASTIC * stride, *flow = state + FLOW_STRESS * stride;
    for (int k = 0; k < SYMMETRIC; k++) c[k] = state + k * stride;

    struct trial t;
    HS_ALIGNED double before[LANES];
    int64_t beyond = trial_strain(s->count, s, &t, c[0], c[1], c[2], c[3], c[4], c[5], flow);
    beyond = beyond && !step.frozen;
    s->flows = beyond;
    const bool moves = beyond && step.commit;
    if (step.energy && moves) plastic_work(s->count, s, p, table, before);
    if (beyond)
        radial_return(&(struct radial_return){s->count, s->mu, t.q, flow, p, s->shift, s->pair,
                                              t.increment, t.scale, t.open, table});
    if (moves)
        stress_and_state(s->count, s, &t, c[0], c[1], c[2], c[3], c[4], c[5], p, flow, table);
    else
        stress(s->count, s, &t);
    if (!step.energy) return;
    plastic_work(s->count, s, p, table, s->dissipated);
    energy(s->count, s, &t, moves ? before : s->dissipated);
}

const struct law law_j2 = {
    .words = {.name = "j2",
              .help = "finite-strain J2 plasticity with isotropic hardening, in logarithmic strain",
              .keys = {YIELD_KEYS, yield_keys}},
    .parameters = sizeof(struct yield),
    .n_states = sizeof states / sizeof *states,
    .states = states,
    .flow_stress = FLOW_STRESS,
    .read = yield_read,
    .release = yield_release,
    .yield = yield_of,
    .pairs = yield_pairs,
    .start = start,
    .update = update,
};
