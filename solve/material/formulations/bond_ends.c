#include "bond_ends.h"

#include <math.h>

HS_INLINE void extensions(const struct bond_view *v, const struct bond_ends *u, int g, double *e)
{
    const double *ux = u->lower[0], *uy = u->lower[1], *uz = u->lower[2];
    const double *vx = u->upper[0], *vy = u->upper[1], *vz = u->upper[2];
    const double *X = v->xi[0], *Y = v->xi[1], *Z = v->xi[2], *L = v->length;
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L;
    const int count = v->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0;
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        x += a;
        y += b;
        z += d;
        e[k] = longer / (sqrt(x * x + y * y + z * z) + (g ? L[k] : L0));
    }
}
HS_SIMD static void extensions_alike(const struct bond_view *view, const struct bond_ends *u,
                                     double *e)
{
    extensions(view, u, 0, e);
}
HS_SIMD static void extensions_scattered(const struct bond_view *view, const struct bond_ends *u,
                                         double *e)
{
    extensions(view, u, 1, e);
}

void bond_ends_extensions(const struct bond_view *view, const struct bond_ends *u,
                          double extension[BOND_LANES])
{
    (view->geometry_step ? extensions_scattered : extensions_alike)(view, u, extension);
}

/* y, and the force states of the ends times the other end's volume over |y|. */
struct directions {
    double y[3][BOND_LANES], pull[2][BOND_LANES];
};

HS_INLINE void find_directions(const struct bond_view *v, const struct bond_ends *u, int g,
                               const double *e, const double *lower, const double *upper,
                               struct directions *d)
{
    const double *ux = u->lower[0], *uy = u->lower[1], *uz = u->lower[2];
    const double *vx = u->upper[0], *vy = u->upper[1], *vz = u->upper[2];
    const double *X = v->xi[0], *Y = v->xi[1], *Z = v->xi[2], *L = v->length;
    const double *Vi = v->volume_i, *Vj = v->volume_j;
    const int count = v->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = X[k * g] + vx[k] - ux[k], y = Y[k * g] + vy[k] - uy[k],
               z = Z[k * g] + vz[k] - uz[k], inverse = 1 / (L[k * g] + e[k]);
        d->y[0][k] = x;
        d->y[1][k] = y;
        d->y[2][k] = z;
        d->pull[0][k] = lower[k] * Vj[k * g] * inverse;
        d->pull[1][k] = upper[k] * Vi[k * g] * inverse;
    }
}
HS_SIMD static void directions_alike(const struct bond_view *view, const struct bond_ends *u,
                                     const double *e, const double *lower, const double *upper,
                                     struct directions *d)
{
    find_directions(view, u, 0, e, lower, upper, d);
}
HS_SIMD static void directions_scattered(const struct bond_view *view, const struct bond_ends *u,
                                         const double *e, const double *lower, const double *upper,
                                         struct directions *d)
{
    find_directions(view, u, 1, e, lower, upper, d);
}

HS_SIMD static void add_alike(int count, const double *restrict pull, const double *restrict y,
                              double xi, double *restrict S)
{
    for (int k = 0; k < count; k++) S[k] += pull[k] * (y[k] * xi);
}
HS_SIMD static void add_scattered(int count, const double *restrict pull, const double *restrict y,
                                  const double *restrict xi, double *restrict S)
{
    for (int k = 0; k < count; k++) S[k] += pull[k] * (y[k] * xi[k]);
}

void bond_ends_add_stress(const struct bond_view *view, const struct bond_ends *u,
                          const double *extension, const double *lower, const double *upper,
                          int rows, struct body *body)
{
    struct directions d;
    double buffer[BOND_LANES];
    (view->geometry_step ? directions_scattered : directions_alike)(view, u, extension, lower,
                                                                    upper, &d);
    for (int end = 0; end < 2; end++)
        for (int a = 0; a < rows; a++)
            for (int b = 0; b < 3; b++) {
                double *S = body->S[3 * a + b], *target;
                if (!view->geometry_step && view->xi[b][0] == 0) continue;
                target = bond_target(view, end, S, buffer);
                if (view->geometry_step)
                    add_scattered(view->count, d.pull[end], d.y[a], view->xi[b], target);
                else
                    add_alike(view->count, d.pull[end], d.y[a], view->xi[b][0], target);
                bond_scatter(view, end, S, buffer);
            }
}
