/* bond_ends.h - how the ends of a strip of bonds move, and the stress that forces along the bonds make. */
#ifndef HS_BOND_ENDS_H
#define HS_BOND_ENDS_H

#include "bonds.h"

/* Displacement of the ends, element k for bond k [m]. */
struct bond_ends {
    const double *lower[3], *upper[3];
};

/* buffer: where displacements that do not lie side by side are gathered. */
static inline struct bond_ends bond_ends_find(const struct bond_view *view, const struct body *body,
                                              double buffer[6][BOND_LANES])
{
    struct bond_ends ends;
    for (int a = 0; a < 3; a++) {
        ends.lower[a] = bond_gather(view, false, body->u[a], buffer[a]);
        ends.upper[a] = bond_gather(view, true, body->u[a], buffer[3 + a]);
    }
    return ends;
}

/* Extensions |y| - |xi| of the bonds of a view [m], y = xi + u_j - u_i: (2 xi.eta + eta.eta)/(|y| + |xi|), eta = u_j -
 * u_i, is exact to round-off for small displacements, too. */
void bond_ends_extensions(const struct bond_view *view, const struct bond_ends *u,
                          double extension[BOND_LANES]);

/* Nominal stress of the nodes, sum_j t_ij y/|y| (x) xi V_j, added to body->S: Silling, Lehoucq, J. Elasticity 93
 * (2008) 13, for uniform deformation.  lower and upper: force state t of either end on bond k [N/m^6]; rows: of the
 * stress, from xx, xy, xz on. */
void bond_ends_add_stress(const struct bond_view *view, const struct bond_ends *u,
                          const double *extension, const double *lower, const double *upper,
                          int rows, struct body *body);

#endif
