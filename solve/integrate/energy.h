/* energy.h - where the work from outside has gone.
 *
 *   kinetic + staggered + stored + plastic + stabilisation + damping + fracture = the same at the
 *       start + external work
 *
 * kinetic + staggered is 1/2 m v(n-1/2).v(n+1/2), which explicit steps keep where 1/2 m v(n)^2
 * swings (theory.md). The work is that of prescribed motions and of loads.  The drift is the
 * difference of both sides over the larger of them, and, while both are still small, over a
 * reference: what the loads and prescribed motions themselves say about the energy that is to come
 * (theory.md).  It measures the integrator, the law and the output together: the left side is
 * evaluated from the state, the right side from forces and motion.  What the sums may lose, all of
 * terms that are smaller, is no drift. */
#ifndef HS_ENERGY_H
#define HS_ENERGY_H

struct energy_balance {
    double kinetic, stored, plastic, stabilisation, damping; /* J */
    double staggered;     /* of the scheme, 0 or below; at rest 0, J */
    double fracture;      /* what the body held less after bonds had broken, J */
    double initial, work; /* J */
    double reference;     /* J */
    double rounding;      /* what its sums over the body may have lost, J */
};

double energy_drift(const struct energy_balance *balance);

double energy_total(const struct energy_balance *balance); /* the left side, J */
double
energy_internal(const struct energy_balance *balance); /* stored + plastic + stabilisation, J */

#endif
