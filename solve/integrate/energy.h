/* energy.h - where the work of the grips has gone.
 *
 *   kinetic + stored + plastic + stabilisation + damping + fracture = initial kinetic + external work
 *
 * The drift is the difference of both sides over the larger of them, and, while both are still small,
 * over the kinetic energy of the affine motion at the grips' full speed.  It measures the
 * integrator, the law and the output together: the left side is evaluated from the state, the right side
 * from forces and motion. */
#ifndef HS_ENERGY_H
#define HS_ENERGY_H

struct energy_balance {
    double kinetic, stored, plastic, stabilisation, damping; /* J */
    double fracture;      /* what the body held less after bonds had broken, J */
    double initial, work; /* J */
    double reference;     /* of the affine motion at the grips' full speed, J */
};

double energy_drift(const struct energy_balance *balance);

double
energy_internal(const struct energy_balance *balance); /* stored + plastic + stabilisation, J */

#endif
