/* logarithmic.h - what laws in logarithmic strain share, a point at a time, for loops that are
 * vectorised.
 *
 *   b = F C F^T,  e = (ln b)/2,  P = tau F^-T                                       (logarithmic.1)
 *
 * ln and exp are the series of artanh and tanh,
 *   (ln b)/2 = artanh X, X = (b - 1)(b + 1)^-1,
 * with an error below 1e-10 for elastic strains below 10 %: an eigenvalue problem a point would
 * cost more than all else, and its branches no vector loop takes. */
#ifndef HS_LOGARITHMIC_H
#define HS_LOGARITHMIC_H

#include "law.h"

/* Symmetric 3x3 matrices in registers. */
struct symmetric {
    double xx, yy, zz, xy, yz, zx;
};

/* a b of two that commute (functions of one matrix): symmetric again. */
HS_INLINE struct symmetric times(struct symmetric a, struct symmetric b)
{
    return (struct symmetric){
        dot3(a.xx, b.xx, a.xy, b.xy, a.zx, b.zx), dot3(a.xy, b.xy, a.yy, b.yy, a.yz, b.yz),
        dot3(a.zx, b.zx, a.yz, b.yz, a.zz, b.zz), dot3(a.xx, b.xy, a.xy, b.yy, a.zx, b.yz),
        dot3(a.xy, b.zx, a.yy, b.yz, a.yz, b.zz), dot3(a.zx, b.xx, a.yz, b.xy, a.zz, b.zx)};
}

HS_INLINE struct symmetric scaled(struct symmetric a, double factor, double diagonal)
{
    return (struct symmetric){fused(a.xx, factor, diagonal),
                              fused(a.yy, factor, diagonal),
                              fused(a.zz, factor, diagonal),
                              a.xy * factor,
                              a.yz * factor,
                              a.zx * factor};
}

HS_INLINE struct symmetric mean_of(struct symmetric a, struct symmetric b)
{
    return (struct symmetric){0.5 * (a.xx + b.xx), 0.5 * (a.yy + b.yy), 0.5 * (a.zz + b.zz),
                              0.5 * (a.xy + b.xy), 0.5 * (a.yz + b.yz), 0.5 * (a.zx + b.zx)};
}

HS_INLINE struct symmetric inverse(struct symmetric a)
{
    double xx = minor_of(a.yy, a.zz, a.yz, a.yz), xy = minor_of(a.yz, a.zx, a.xy, a.zz),
           zx = minor_of(a.xy, a.yz, a.yy, a.zx);
    double scale = 1 / dot3(a.xx, xx, a.xy, xy, a.zx, zx);
    return (struct symmetric){xx * scale,
                              minor_of(a.xx, a.zz, a.zx, a.zx) * scale,
                              minor_of(a.xx, a.yy, a.xy, a.xy) * scale,
                              xy * scale,
                              minor_of(a.xy, a.zx, a.xx, a.yz) * scale,
                              zx * scale};
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

/* b^(1/2): Y of Y, Z = (Y + Z^-1)/2, (Z + Y^-1)/2 from b, 1 (Denman, Beavers, Appl. Math. Comput. 2
 * (1976) 63), to rounding from stretches of 1/10 to 10. */
HS_INLINE struct symmetric square_root(struct symmetric b)
{
    struct symmetric Y = b, Z = {1, 1, 1, 0, 0, 0};
    for (int k = 0; k < 9; k++) {
        const struct symmetric y = inverse(Y), z = inverse(Z);
        Y = mean_of(Y, z);
        Z = mean_of(Z, y);
    }
    return Y;
}

/* (ln b)/2 = 32 (ln b^(1/32))/2, with an error below 1e-10 up to stretches of 5. */
HS_INLINE struct symmetric half_logarithm_of_large(struct symmetric b)
{
    for (int k = 0; k < 5; k++) b = square_root(b);
    return scaled(half_logarithm(b), 32, 0);
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

HS_INLINE struct tensor deformation_gradient(const struct points *s, int i)
{
    return (struct tensor){1 + s->H[0][i], s->H[1][i], s->H[2][i], s->H[3][i],    1 + s->H[4][i],
                           s->H[5][i],     s->H[6][i], s->H[7][i], 1 + s->H[8][i]};
}

HS_INLINE struct tensor inverse_tensor(struct tensor F)
{
    double xx = minor_of(F.yy, F.zz, F.yz, F.zy), yx = minor_of(F.yz, F.zx, F.yx, F.zz),
           zx = minor_of(F.yx, F.zy, F.yy, F.zx);
    double scale = 1 / dot3(F.xx, xx, F.xy, yx, F.xz, zx);
    return (struct tensor){xx * scale,
                           minor_of(F.xz, F.zy, F.xy, F.zz) * scale,
                           minor_of(F.xy, F.yz, F.xz, F.yy) * scale,
                           yx * scale,
                           minor_of(F.xx, F.zz, F.xz, F.zx) * scale,
                           minor_of(F.xz, F.yx, F.xx, F.yz) * scale,
                           zx * scale,
                           minor_of(F.xy, F.zx, F.xx, F.zy) * scale,
                           minor_of(F.xx, F.yy, F.xy, F.yx) * scale};
}

/* F C F^T */
HS_INLINE struct symmetric push_forward(struct tensor F, struct symmetric C)
{
    double ax = dot3(F.xx, C.xx, F.xy, C.xy, F.xz, C.zx),
           ay = dot3(F.xx, C.xy, F.xy, C.yy, F.xz, C.yz),
           az = dot3(F.xx, C.zx, F.xy, C.yz, F.xz, C.zz);
    double bx = dot3(F.yx, C.xx, F.yy, C.xy, F.yz, C.zx),
           by = dot3(F.yx, C.xy, F.yy, C.yy, F.yz, C.yz),
           bz = dot3(F.yx, C.zx, F.yy, C.yz, F.yz, C.zz);
    double cx = dot3(F.zx, C.xx, F.zy, C.xy, F.zz, C.zx),
           cy = dot3(F.zx, C.xy, F.zy, C.yy, F.zz, C.yz),
           cz = dot3(F.zx, C.zx, F.zy, C.yz, F.zz, C.zz);
    return (struct symmetric){
        dot3(ax, F.xx, ay, F.xy, az, F.xz), dot3(bx, F.yx, by, F.yy, bz, F.yz),
        dot3(cx, F.zx, cy, F.zy, cz, F.zz), dot3(ax, F.yx, ay, F.yy, az, F.yz),
        dot3(bx, F.zx, by, F.zy, bz, F.zz), dot3(cx, F.xx, cy, F.xy, cz, F.xz)};
}

/* F F^T */
HS_INLINE struct symmetric left_cauchy_green(struct tensor F)
{
    return (struct symmetric){
        dot3(F.xx, F.xx, F.xy, F.xy, F.xz, F.xz), dot3(F.yx, F.yx, F.yy, F.yy, F.yz, F.yz),
        dot3(F.zx, F.zx, F.zy, F.zy, F.zz, F.zz), dot3(F.xx, F.yx, F.xy, F.yy, F.xz, F.yz),
        dot3(F.yx, F.zx, F.yy, F.zy, F.yz, F.zz), dot3(F.zx, F.xx, F.zy, F.xy, F.zz, F.xz)};
}

HS_INLINE double trace_of(struct symmetric a)
{
    return a.xx + a.yy + a.zz;
}

/* a : a */
HS_INLINE double square_of(struct symmetric a)
{
    const double diagonal = dot3(a.xx, a.xx, a.yy, a.yy, a.zz, a.zz);
    return fused(2, dot3(a.xy, a.xy, a.yz, a.yz, a.zx, a.zx), diagonal);
}

/* P of point i from tau = deviator e + pressure 1, e a deviator; G = F^-1. */
HS_INLINE void write_stress(struct points *restrict s, int i, struct tensor G, struct symmetric e,
                            double deviator, double pressure)
{
    struct symmetric tau = scaled(e, deviator, pressure);
    s->P[0][i] = dot3(tau.xx, G.xx, tau.xy, G.xy, tau.zx, G.xz);
    s->P[1][i] = dot3(tau.xx, G.yx, tau.xy, G.yy, tau.zx, G.yz);
    s->P[2][i] = dot3(tau.xx, G.zx, tau.xy, G.zy, tau.zx, G.zz);
    s->P[3][i] = dot3(tau.xy, G.xx, tau.yy, G.xy, tau.yz, G.xz);
    s->P[4][i] = dot3(tau.xy, G.yx, tau.yy, G.yy, tau.yz, G.yz);
    s->P[5][i] = dot3(tau.xy, G.zx, tau.yy, G.zy, tau.yz, G.zz);
    s->P[6][i] = dot3(tau.zx, G.xx, tau.yz, G.xy, tau.zz, G.xz);
    s->P[7][i] = dot3(tau.zx, G.yx, tau.yz, G.yy, tau.zz, G.yz);
    s->P[8][i] = dot3(tau.zx, G.zx, tau.yz, G.zy, tau.zz, G.zz);
}

/* Stored energy density, q = 2 mu (3/2 e : e)^1/2 of the elastic deviator e. */
HS_INLINE double stored_energy(double q, double mu, double bulk, double trace)
{
    return q * q / (6 * (mu > 0 ? mu : 1)) + 0.5 * bulk * trace * trace;
}

#endif
