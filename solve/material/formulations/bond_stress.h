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

/* (macroscopic.2): force (x) xi of the strip's bonds, added to body->stress_sums; likewise. */
void bond_stress_sum(const struct bonds *bonds, const struct bond_strip *strip,
                     const double *extension, const double *lower, const double *upper,
                     const struct body *body);

#endif
