/* balance.h - the sums over the body that a step needs, and the energy balance made of them. */
#ifndef HS_BALANCE_H
#define HS_BALANCE_H

#include "integration_state.h"

/* What a step sums up on the way, to be finished with the rest. */
struct balance_sums {
    struct exact_sum damped, work; /* J */
};

/* Mass of each set [kg].  Collective. */
void balance_masses(const struct integration *integration, const struct body *body,
                    struct boundary *boundary);

/* The balance at the start, whose energies are those of force mode.energy.  Collective. */
void balance_start(struct integration *integration, const struct body *body,
                   struct boundary *boundary, const struct force_energy *energy);

/* The end of a step, in one message: reactions, work and damping, and the energies where energy is
 * not NULL (from model_force).  Collective. */
void balance_step(struct integration *integration, const struct body *body,
                  struct boundary *boundary, const struct force_energy *energy,
                  const struct balance_sums *sums);

/* What the energy of motion that the scheme keeps, 1/2 m v(n-1/2).v(n+1/2), has beyond 1/2 m v(n)^2
 * [J], 0 or below: of the forces and the step as they are now.  Collective. */
double balance_staggered(const struct integration *integration, const struct body *body,
                         const struct boundary *boundary);

/* Sets the length of the steps to come [s].  What the scheme keeps is another energy then, no
 * energy is lost or gained: the balance starts from it.  Collective. */
void balance_set_step(struct integration *integration, const struct body *body,
                      const struct boundary *boundary, double dt);

/* The same for any such change of balance_staggered between two steps [J]. */
void balance_shift(struct energy_balance *balance, double change);

/* The velocities have been set anew.  Kinetic energy that has gone counts as damped; where some has
 * come, the balance starts again: the drift is 0.  Collective. */
void balance_motion(struct integration *integration, const struct body *body,
                    struct boundary *boundary);

/* The reactions again, after the loads have jumped.  Collective. */
void balance_reactions(const struct body *body, struct boundary *boundary);

#endif
