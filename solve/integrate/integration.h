/* integration.h - where a body is in time, and where the energy has gone: what all integrators
 * share. */
#ifndef HS_INTEGRATION_H
#define HS_INTEGRATION_H

#include "integration_state.h"

struct checkpoint;

/* Starts from the displacements and velocities as set, those of the boundary taking their places;
 * evaluates the first force.  moving: false for equilibria, which have no velocities.  Collective.
 */
struct integration integration_new(bool moving, double dt, double damping,
                                   const struct materials *materials, struct body *body,
                                   struct boundary *boundary, struct model *model);
void integration_free(struct integration *integration);

/* Time, balance, and the body's motion and forces.  Collective. */
void integration_visit(struct integration *integration, struct body *body,
                       struct checkpoint *checkpoint);

/* Between steps: raises the stepped loads that are due.  True where one has been raised.
 * Collective. */
bool integration_raise_loads(struct integration *integration, struct body *body,
                             struct boundary *boundary, bool equilibrium);

#endif
