/* verlet.h - explicit central differences (velocity Verlet).
 *
 *   v += dt/2 a;  u += dt v;  a = (f(u) + b)/rho - c (v - v_affine);  v += dt/2 a
 *
 * Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76 (1982) 637.  b are the loads.  Optional
 * damping c acts on the motion relative to the affine one between the grips, so that it does not
 * drag the test itself.  Bonds break where a step has led to: its second half already feels the
 * force that is left. */
#ifndef HS_VERLET_H
#define HS_VERLET_H

#include "integration.h"

/* One step.  energies: the balance becomes that at its end; evaluating it costs, and changes no
 * motion. record as in struct force_mode.  Collective. */
void verlet_step(struct integration *integration, struct body *body, struct boundary *boundary,
                 struct model *model, bool energies, bool record);

#endif
