/* bond_stress.h - the stress that forces along bonds make. */
#ifndef HS_BOND_STRESS_H
#define HS_BOND_STRESS_H

#include "bonds.h"

/* Nominal stress of the nodes, sum_j t_ij y/|y| (x) xi V_j, added to body->S: Silling, Lehoucq, J.
 * Elasticity 93 (2008) 13, for uniform deformation.  Of each bond of the strip its extension [m]
 * and the force states t of its lower and upper ends [N/m^6]; rows: of the stress, from xx, xy, xz
 * on. */
void bond_stress_add(const struct bonds *bonds, const struct bond_strip *strip,
                     const double *extension, const double *lower, const double *upper, int rows,
                     struct body *body);

/* (macroscopic.2): the sum of force (x) xi over the bonds is that of force
 * (x) period over those through the cell's faces less that of force (x) position over the nodes,
 * which takes a fraction of the terms.  Added to body->stress_sums.
 * Whether bonds of the strip pass through a face; */
bool bond_stress_crosses(const struct bonds *bonds, const struct bond_strip *strip);
/* theirs, of each bond of the strip y [m], and the force along it over |y|, per volume of either
 * end [N/m^7]; */
void bond_stress_cross(const struct bonds *bonds, const struct bond_strip *strip,
                       const double *const y[3], const double *force, const struct body *body);
/* the nodes', by body->f. */
void bond_stress_nodes(const struct body *body);

#endif
