/* interface.h - bonds through more than one phase.
 *
 * Phases that lie one behind the other along a bond carry one force, and share its extension as
 * springs in series do:
 *
 *   S = 1/sum_p (lambda_p/M_p)                                                       (interface.1)
 *   r_i = S/M_i,  g_i = 1 + lambda_i r_i - lambda_j r_j                              (interface.2)
 *
 * lambda_p is the part of the bond's line that lies in cells of phase p, M_p the stiffness of the
 * phase, S that of the bond.  r_i e is the extension that the bond would have if all of it were
 * strained as it is in the phase of its end i, lambda_i the part in that phase (of two ends of one
 * phase each has half), g_i the weight of that end in what both make of the bond: g_i + g_j = 2,
 * and with it the bond is as stiff as S whatever lambda is.  A stack of layers pulled across them
 * so has the one stress that it has to have.  Pulled along them it has too little, since there the
 * strain is one and the mean of the moduli would be right; a spring has no way to know.  Between
 * scattered particles, which have no cells, lambda is 1/2. */
#ifndef HS_INTERFACE_H
#define HS_INTERFACE_H

#include "bonds.h"
#include "keys.h"
#include "material.h"

extern const char *const interface_laws[]; /* in the deck's words, ended by NULL */

struct interface;

/* solver.interfaces: whether bonds are in series. */
bool interface_read(struct deck_node solver);

/* stiffness: M of each phase, any unit; not kept.  NULL where phases are alike. */
struct interface *interface_new(const struct bonds *bonds, int n_phases, const double *stiffness);
void interface_free(struct interface *interface);

/* Of a strip's bonds what its lower and its upper ends have: r and g/r, [2][count]; both are 1
 * where the bond lies in one phase.  Whether any does not. */
bool interface_strip(const struct interface *interface, const struct bond_strip *strip,
                     double *const share[2], double *const part[2]);

/* K + 4 mu/3, in a plane K_2 + mu: what resists a stretch across layers that cannot move sideways
 * [Pa]. */
double interface_stiffness(const struct material *material, enum plane plane);

#endif
