/* radial_return.c - the plastic multiplier of a strip of points (radial_return.h).
 *
 * All points of the strip take the same steps of Newton's method in one vector loop, whether they
 * are beyond yield or not: those that have settled keep their value by a mask (open = 0), and the
 * loop ends with the last one.  The start, along the tangent of the flow curve, is exact for linear
 * hardening, and near for smooth laws.  The mask makes a point's result depend on its own numbers
 * alone, so strips may be cut anywhere without a change of bits. Bisection, point by point, is for
 * kinks of tabulated curves, between which Newton's steps may go to and fro. */
#include "radial_return.h"

#include "flow_curve.h"

#include <math.h>

/* First guess of g: along the tangent of the flow curve at p.  Points below yield get 0 and are
 * done; open > 0 marks those that are not. */
HS_SIMD static void start(int count, const double *restrict mu, const double *restrict q,
                          const double *restrict yield, const double *restrict p,
                          const int64_t *restrict curve, double *restrict increment,
                          double *restrict open, const double *restrict table)
{
    for (int i = 0; i < count; i++) {
        int64_t cell = flow_cell(curve[i], p[i]);
        double beyond = q[i] - yield[i];
        double g = beyond / (3 * mu[i] + flow_slope(table, cell, p[i]));
        g = g > 0 ? g : 0;
        increment[i] = g;
        open[i] = g;
    }
}

/* One Newton step for the points that are still open; returns whether any stays so.  The residual
 * falls with g and, hardening being monotone, its root lies in [0, most].  The error of a step is
 * about the square of the one before: from a residual below near, the step ends at round-off and is
 * the point's last. */
HS_SIMD static int64_t iterate(int count, const double *restrict mu, const double *restrict q,
                               const double *restrict yield, const double *restrict p,
                               const double *restrict shift, const int64_t *restrict curve,
                               double *restrict increment, double *restrict open,
                               const double *restrict table)
{
    const double near = 1e-8;
    int64_t unsettled = 0;
    for (int i = 0; i < count; i++) {
        double modulus = 3 * mu[i], trial = q[i], g = increment[i], still = open[i];
        double most = (trial - yield[i]) / modulus, all = p[i] + g;
        int64_t cell = flow_cell(curve[i], all);
        double residual = fused(-modulus, g, trial) - (flow_stress(table, cell, all) + shift[i]);
        double next = g + residual / (modulus + flow_slope(table, cell, all));
        next = next > 0 ? next : 0;
        next = next < most ? next : most;
        increment[i] = still > 0 ? next : g;
        still = fabs(residual) > near * trial ? still : 0;
        open[i] = still;
        unsettled |= still > 0;
    }
    return unsettled;
}

/* For the points where Newton's method went to and fro between kinks of a table. */
static void bisect(const struct radial_return *s)
{
    for (int i = 0; i < s->count; i++) {
        if (!(s->open[i] > 0)) continue;
        double modulus = 3 * s->mu[i], q = s->q[i], low = 0, high = (q - s->yield[i]) / modulus;
        for (int step = 0; step < 60; step++) {
            double g = 0.5 * (low + high), all = s->p[i] + g;
            double residual =
                q - modulus * g -
                (flow_stress(s->table, flow_cell(s->curve[i], all), all) + s->shift[i]);
            *(residual > 0 ? &low : &high) = g;
        }
        s->increment[i] = 0.5 * (low + high);
    }
}

HS_SIMD static void find_scale(int count, const double *restrict mu, const double *restrict q,
                               const double *restrict increment, double *restrict scale)
{
    for (int i = 0; i < count; i++) scale[i] = 1 - 3 * mu[i] * increment[i] / (q[i] > 0 ? q[i] : 1);
}

void radial_return(const struct radial_return *s)
{
    int64_t unsettled = 1;
    start(s->count, s->mu, s->q, s->yield, s->p, s->curve, s->increment, s->open, s->table);
    for (int step = 0; step < 25 && unsettled; step++)
        unsettled = iterate(s->count, s->mu, s->q, s->yield, s->p, s->shift, s->curve, s->increment,
                            s->open, s->table);
    if (unsettled) bisect(s);
    find_scale(s->count, s->mu, s->q, s->increment, s->scale);
}
