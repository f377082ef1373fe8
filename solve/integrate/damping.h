/* damping.h - the uniform motion between the grips, and damping of what goes beyond it.
 *
 *   v' = v_affine + e^(-c dt/2) (v - v_affine)                                          (damping.1)
 *   the same, less alpha |f + b|/rho dt/2 of its magnitude, and not below 0             (damping.2)
 *
 * over half a step: viscous damping with one rate c for all motions, and local damping, a share
 * alpha of the force on each node against its motion (Cundall, in Brown (ed.), Analytical and
 * Computational Methods in Engineering Rock Mechanics (1987) 129), which damps all frequencies
 * alike and vanishes at equilibrium.  Both leave the affine motion alone: what drags on that would
 * be a force of the test. */
#ifndef HS_DAMPING_H
#define HS_DAMPING_H

#include "integration_state.h"

static inline bool damping_acts(const struct integration *integration)
{
    return integration->damping > 0 || integration->local_damping > 0;
}

/* Velocities decay towards the affine motion between the grips (towards rest, where there are none)
 * over half a step; prescribed components do not.  kicked: how long before, beyond the full step,
 * the force began to act on them [s]: half a step, or 0 at the full step.  lost takes the energy
 * [J]: m (v - v') . (v + v')/2 of velocities that are those of the full step, as the scheme keeps
 * its energy between full steps. */
void damping_apply(const struct integration *integration, struct body *body,
                   const struct boundary *boundary, double time, double kicked,
                   struct exact_sum *lost);

/* Kinetic energy [J] of the motion beyond the uniform stretching that the grips impose: waves, and
 * necks. Collective. */
double damping_unsteady_energy(const struct integration *integration, const struct body *body,
                               const struct boundary *boundary);

#endif
