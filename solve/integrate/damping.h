/* damping.h - the uniform motion between the grips, and damping of what goes beyond it. */
#ifndef HS_DAMPING_H
#define HS_DAMPING_H

#include "integration.h"

/* Velocities decay towards the affine motion between the grips (towards rest, where there are none) over half
 * a step; prescribed components do not.  lost takes the energy [J]. */
void damping_apply(const struct integration *integration, struct body *body,
                   const struct boundary *boundary, double time, struct exact_sum *lost);

/* Kinetic energy [J] of the motion beyond the uniform stretching that the grips impose: waves, and necks.
 * Collective. */
double damping_unsteady_energy(const struct integration *integration, const struct body *body,
                               const struct boundary *boundary);

#endif
