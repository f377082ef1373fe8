/* radial_return.h - the scalar equation of the plastic return, a strip of points at a time:
 *
 *   q_trial - 3 mu g = sigma_y(p + g)                                               (j2.3)
 *
 * by Newton's method, whose iterates stay between 0 and (q_trial - sigma_y(p))/(3 mu), where the
 * root of a rising law lies; bisection takes over where it does not settle.  A point's result
 * depends on its own numbers alone, whatever its neighbours in the strip need. */
#ifndef HS_RADIAL_RETURN_H
#define HS_RADIAL_RETURN_H

#include "simd.h"

#include <stdint.h>

/* All arrays [count], count at most LANES. */
struct radial_return {
    int count;
    const double *mu;          /* shear modulus [Pa] */
    const double *q;           /* trial stress [Pa] */
    const double *yield;       /* sigma_y(p) [Pa], shift included */
    const double *p;           /* equivalent plastic strain before */
    const double *shift;       /* what sigma_y has over the flow curve [Pa] */
    const int64_t *curve;      /* index of the flow curve */
    double *increment, *scale; /* out: g, and 1 - 3 mu g/q_trial; 0 and 1 below yield */
    double *open;              /* work */
    const double *table;       /* flow curves (flow_curve.h) */
};

void radial_return(const struct radial_return *points);

#endif
