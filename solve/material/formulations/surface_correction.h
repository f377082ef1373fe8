/* surface_correction.h - factors on the weights of bonds whose ends have not their full families.
 *
 *   volume: g_ij = 2 V_0/(V_i + V_j),  V_i = sum_j w V_j                             (surface.1)
 *   energy: g_ij = [sum_a (n_a/g_a)^2]^-1/2,  g_a = (g_a,i + g_a,j)/2,
 *           g_a,i = W_a,0/W_a,i,  W_a,i = sum_j w |xi|^power n_a^4 V_j,  n = xi/|xi|  (surface.2)
 *
 * Le, Bobaru, Comput. Mech. 61 (2018) 499, the volume method; Madenci, Oterkus, Peridynamic Theory
 * and Its Applications (2014), chapter 4, the energy method: W_a is the energy that a small
 * uniaxial stretch along axis a puts into the bonds of a node, and g_ij is read off an ellipsoid
 * with the half axes g_a.  0 denotes a node deep inside the body: on a lattice a node of the same
 * lattice, so that nothing changes there; among scattered particles the continuum. */
#ifndef HS_SURFACE_CORRECTION_H
#define HS_SURFACE_CORRECTION_H

#include "bonds.h"
#include "keys.h"

enum surface_correction { SURFACE_NONE, SURFACE_VOLUME, SURFACE_ENERGY };

extern const char *const surface_corrections[]; /* in the deck's words, ended by NULL */

/* solver.surface_correction. */
enum surface_correction surface_correction_read(struct deck_node solver);

/* Changes the weights.  power: energy of a bond is proportional to w |xi|^power times its stretch
 * squared: 1 of bond-based materials, 2 of ordinary ones.  Collective. */
void surface_correction_apply(enum surface_correction kind, struct bonds *bonds, int power);

/* sum += sum_j w |xi|^power V_j of each node, over the bonds there are; of power 2 the weighted
 * volume. */
void surface_add_weighted_volumes(const struct bonds *bonds, int power, double *sum);

/* sum_j w |xi|^power V_j of a node deep inside the body. */
double surface_full_family(const struct bonds *bonds, int power);

#endif
