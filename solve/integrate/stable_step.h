/* stable_step.h - the largest stable time step of central differences.
 *
 *   dt_critical = 2/omega_max,  omega_max^2 the largest eigenvalue of M^-1 (-df/du)
 *
 * of the whole body as it stands, stabilisation included, without yield (plastic flow only
 * softens). Lanczos' method on differences of the force, 30 steps from a random vector; the largest
 * Ritz value plus the norm of its residual (Parlett, The Symmetric Eigenvalue Problem (1998),
 * section 4.5) lies above the eigenvalue next to it, which a random start makes the largest.  The
 * safety factor covers the rest. */
#ifndef HS_STABLE_STEP_H
#define HS_STABLE_STEP_H

#include "model.h"

/* [s]; infinite where no force resists any motion.  Costs about 60 force evaluations; leaves u, f
 * and H as they were.  Collective, the same on every rank. */
double stable_step(struct model *model, struct body *body, const struct materials *materials);

#endif
