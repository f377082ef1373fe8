#include "j2.h"

#include "flow_curve.h"
#include "radial_return.h"

#include <math.h>

/* Symmetric 3x3 matrices in registers. */
struct symmetric {
    double xx, yy, zz, xy, yz, zx;
};

/* a b of two that commute (functions of one matrix): symmetric again. */
HS_INLINE struct symmetric times(struct symmetric a, struct symmetric b)
{
    return (struct symmetric){
        a.xx * b.xx + a.xy * b.xy + a.zx * b.zx, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
        a.zx * b.zx + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.zx * b.yz,
        a.xy * b.zx + a.yy * b.yz + a.yz * b.zz, a.zx * b.xx + a.yz * b.xy + a.zz * b.zx};
}

HS_INLINE struct symmetric scaled(struct symmetric a, double factor, double diagonal)
{
    return (struct symmetric){a.xx * factor + diagonal,
                              a.yy * factor + diagonal,
                              a.zz * factor + diagonal,
                              a.xy * factor,
                              a.yz * factor,
                              a.zx * factor};
}

HS_INLINE struct symmetric inverse(struct symmetric a)
{
    double xx = a.yy * a.zz - a.yz * a.yz, xy = a.yz * a.zx - a.xy * a.zz,
           zx = a.xy * a.yz - a.yy * a.zx;
    double scale = 1 / (a.xx * xx + a.xy * xy + a.zx * zx);
    return (struct symmetric){
        xx * scale, (a.xx * a.zz - a.zx * a.zx) * scale, (a.xx * a.yy - a.xy * a.xy) * scale,
        xy * scale, (a.xy * a.zx - a.xx * a.yz) * scale, zx * scale};
}

/* (ln b)/2 = artanh X, X = 1 - 2 (b + 1)^-1 */
HS_INLINE struct symmetric half_logarithm(struct symmetric b)
{
    struct symmetric X = scaled(inverse(scaled(b, 1, 1)), -2, 1), Y = times(X, X);
    struct symmetric series = scaled(Y, 1.0 / 7, 1.0 / 5);
    series = scaled(times(Y, series), 1, 1.0 / 3);
    series = scaled(times(Y, series), 1, 1);
    return times(X, series);
}

/* exp(2 e) = 2 (1 - T)^-1 - 1, T = tanh e */
HS_INLINE struct symmetric double_exponential(struct symmetric e)
{
    struct symmetric Y = times(e, e);
    struct symmetric series = scaled(Y, -17.0 / 315, 2.0 / 15);
    series = scaled(times(Y, series), 1, -1.0 / 3);
    series = scaled(times(Y, series), 1, 1);
    return scaled(inverse(scaled(times(e, series), -1, 1)), 2, -1);
}

struct tensor {
    double xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

HS_INLINE struct tensor deformation_gradient(const double (*H)[LANES], int i)
{
    return (struct tensor){1 + H[0][i], H[1][i], H[2][i], H[3][i],    1 + H[4][i],
                           H[5][i],     H[6][i], H[7][i], 1 + H[8][i]};
}

HS_INLINE struct tensor inverse_tensor(struct tensor F)
{
    double xx = F.yy * F.zz - F.yz * F.zy, yx = F.yz * F.zx - F.yx * F.zz,
           zx = F.yx * F.zy - F.yy * F.zx;
    double scale = 1 / (F.xx * xx + F.xy * yx + F.xz * zx);
    return (struct tensor){
        xx * scale, (F.xz * F.zy - F.xy * F.zz) * scale, (F.xy * F.yz - F.xz * F.yy) * scale,
        yx * scale, (F.xx * F.zz - F.xz * F.zx) * scale, (F.xz * F.yx - F.xx * F.yz) * scale,
        zx * scale, (F.xy * F.zx - F.xx * F.zy) * scale, (F.xx * F.yy - F.xy * F.yx) * scale};
}

/* F C F^T */
HS_INLINE struct symmetric push_forward(struct tensor F, struct symmetric C)
{
    double ax = F.xx * C.xx + F.xy * C.xy + F.xz * C.zx,
           ay = F.xx * C.xy + F.xy * C.yy + F.xz * C.yz,
           az = F.xx * C.zx + F.xy * C.yz + F.xz * C.zz;
    double bx = F.yx * C.xx + F.yy * C.xy + F.yz * C.zx,
           by = F.yx * C.xy + F.yy * C.yy + F.yz * C.yz,
           bz = F.yx * C.zx + F.yy * C.yz + F.yz * C.zz;
    double cx = F.zx * C.xx + F.zy * C.xy + F.zz * C.zx,
           cy = F.zx * C.xy + F.zy * C.yy + F.zz * C.yz,
           cz = F.zx * C.zx + F.zy * C.yz + F.zz * C.zz;
    return (struct symmetric){ax * F.xx + ay * F.xy + az * F.xz, bx * F.yx + by * F.yy + bz * F.yz,
                              cx * F.zx + cy * F.zy + cz * F.zz, ax * F.yx + ay * F.yy + az * F.yz,
                              bx * F.zx + by * F.zy + bz * F.zz, cx * F.xx + cy * F.xy + cz * F.xz};
}

/* (j2.1): elastic trial strain and its deviator's norm; returns whether any point is beyond yield. */
HS_SIMD static int64_t trial_strain(int count, struct j2_strip *restrict s,
                                    const double *restrict xx, const double *restrict yy,
                                    const double *restrict zz, const double *restrict xy,
                                    const double *restrict yz, const double *restrict zx,
                                    const double *restrict flow)
{
    int64_t beyond = 0;
    for (int i = 0; i < count; i++) {
        struct symmetric Cp = {xx[i], yy[i], zz[i], xy[i], yz[i], zx[i]};
        struct symmetric e =
            half_logarithm(push_forward(deformation_gradient((const double(*)[LANES])s->H, i), Cp));
        double trace = e.xx + e.yy + e.zz;
        e = scaled(e, 1, -trace / 3);
        s->e[0][i] = e.xx;
        s->e[1][i] = e.yy;
        s->e[2][i] = e.zz;
        s->e[3][i] = e.xy;
        s->e[4][i] = e.yz;
        s->e[5][i] = e.zx;
        s->trace[i] = trace;
        double norm =
            e.xx * e.xx + e.yy * e.yy + e.zz * e.zz + 2 * (e.xy * e.xy + e.yz * e.yz + e.zx * e.zx);
        double q = 2 * s->mu[i] * sqrt(1.5 * norm);
        s->q[i] = q;
        s->scale[i] = 1;
        s->grown[i] = 0;
        double yield = flow[i] + s->shift[i];
        s->yield[i] = yield;
        beyond |= q > yield;
    }
    return beyond;
}

/* tau and P = tau F^-T of point i; G = F^-1. */
HS_INLINE void write_stress(struct j2_strip *restrict s, int i, struct tensor G)
{
    double deviator = 2 * s->mu[i] * s->scale[i], pressure = s->bulk[i] * s->trace[i];
    struct symmetric tau = {deviator * s->e[0][i] + pressure,
                            deviator * s->e[1][i] + pressure,
                            deviator * s->e[2][i] + pressure,
                            deviator * s->e[3][i],
                            deviator * s->e[4][i],
                            deviator * s->e[5][i]};
    s->P[0][i] = tau.xx * G.xx + tau.xy * G.xy + tau.zx * G.xz;
    s->P[1][i] = tau.xx * G.yx + tau.xy * G.yy + tau.zx * G.yz;
    s->P[2][i] = tau.xx * G.zx + tau.xy * G.zy + tau.zx * G.zz;
    s->P[3][i] = tau.xy * G.xx + tau.yy * G.xy + tau.yz * G.xz;
    s->P[4][i] = tau.xy * G.yx + tau.yy * G.yy + tau.yz * G.yz;
    s->P[5][i] = tau.xy * G.zx + tau.yy * G.zy + tau.yz * G.zz;
    s->P[6][i] = tau.zx * G.xx + tau.yz * G.xy + tau.zz * G.xz;
    s->P[7][i] = tau.zx * G.yx + tau.yz * G.yy + tau.zz * G.yz;
    s->P[8][i] = tau.zx * G.zx + tau.yz * G.zy + tau.zz * G.zz;
}

HS_SIMD static void stress(int count, struct j2_strip *restrict s)
{
    for (int i = 0; i < count; i++)
        write_stress(s, i, inverse_tensor(deformation_gradient((const double(*)[LANES])s->H, i)));
}

/* The same, and (j2.4) where the point has flowed; the others keep their state to the last bit. */
HS_SIMD static void stress_and_state(int count, struct j2_strip *restrict s, double *restrict xx,
                                     double *restrict yy, double *restrict zz, double *restrict xy,
                                     double *restrict yz, double *restrict zx, double *restrict p,
                                     double *restrict flow, const double *restrict table)
{
    for (int i = 0; i < count; i++) {
        struct tensor G = inverse_tensor(deformation_gradient((const double(*)[LANES])s->H, i));
        write_stress(s, i, G);
        double scale = s->scale[i], third = s->trace[i] / 3;
        struct symmetric e = {scale * s->e[0][i] + third, scale * s->e[1][i] + third,
                              scale * s->e[2][i] + third, scale * s->e[3][i],
                              scale * s->e[4][i],         scale * s->e[5][i]};
        struct symmetric C = push_forward(G, double_exponential(e));
        double grown = s->grown[i];
        xx[i] = grown > 0 ? C.xx : xx[i];
        yy[i] = grown > 0 ? C.yy : yy[i];
        zz[i] = grown > 0 ? C.zz : zz[i];
        xy[i] = grown > 0 ? C.xy : xy[i];
        yz[i] = grown > 0 ? C.yz : yz[i];
        zx[i] = grown > 0 ? C.zx : zx[i];
        p[i] = p[i] + grown;
        flow[i] = flow_stress(table, flow_cell(s->curve[i], p[i]), p[i]);
    }
}

HS_SIMD static void energy(int count, struct j2_strip *restrict s, const double *restrict p,
                           const double *restrict table)
{
    for (int i = 0; i < count; i++) {
        double q = s->scale[i] * s->q[i], all = p[i];
        double mu = s->mu[i] > 0 ? s->mu[i] : 1;
        s->stored[i] = q * q / (6 * mu) + 0.5 * s->bulk[i] * s->trace[i] * s->trace[i];
        s->plastic[i] = flow_work(table, flow_cell(s->curve[i], all), all) + s->shift[i] * all;
    }
}

void j2_start(const struct j2_strip *s, double *state, int64_t stride, const double *table)
{
    for (int i = 0; i < s->count; i++) {
        for (int k = 0; k < J2_STATE; k++) state[k * stride + i] = k < 3 ? 1 : 0;
        state[J2_YIELD * stride + i] = flow_stress(table, flow_cell(s->curve[i], 0), 0);
    }
}

void j2_update(struct j2_strip *s, double *state, int64_t stride, const double *table,
               struct j2_mode mode)
{
    double *c[J2_STATE];
    for (int k = 0; k < J2_STATE; k++) c[k] = state + k * stride;
    double *p = c[J2_PLASTIC];

    int64_t beyond = trial_strain(s->count, s, c[0], c[1], c[2], c[3], c[4], c[5], c[J2_YIELD]);
    beyond = beyond && !mode.frozen;
    s->flows = beyond;
    if (beyond)
        radial_return(&(struct radial_return){s->count, s->mu, s->q, s->yield, p, s->shift,
                                              s->curve, s->grown, s->scale, s->open, table});
    if (beyond && mode.commit)
        stress_and_state(s->count, s, c[0], c[1], c[2], c[3], c[4], c[5], p, c[J2_YIELD], table);
    else
        stress(s->count, s);
    if (mode.energy) energy(s->count, s, p, table);
}

void j2_cauchy(const struct j2_strip *s, double cauchy[SYMMETRIC][LANES])
{
    for (int i = 0; i < s->count; i++) {
        double F[TENSOR], P[TENSOR];
        for (int k = 0; k < TENSOR; k++) {
            F[k] = s->H[k][i] + (k % 4 == 0);
            P[k] = s->P[k][i];
        }
        double J = F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
                   F[2] * (F[3] * F[7] - F[4] * F[6]);
        static const int row[SYMMETRIC] = {0, 1, 2, 0, 1, 2},
                         column[SYMMETRIC] = {0, 1, 2, 1, 2, 0};
        for (int k = 0; k < SYMMETRIC; k++) {
            const double *a = P + 3 * row[k], *b = F + 3 * column[k];
            cauchy[k][i] = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / J;
        }
    }
}
