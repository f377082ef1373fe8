/* opening.h - the energy that goes into bonds when a crack opens.
 *
 * Bonds of length xi that cross a plane, per area of it: pi xi^3 d xi in space; 2 h xi^2 d xi in a
 * plane of thickness h (per length of the crack and h).  All of them pulled to the stretch s, a
 * material takes up G = a s^2:
 *
 *   bond-based     a = (9/4) K M4/M3                  in a plane: (4/pi) K_2 M3/M2      (opening.1)
 *   ordinary       a = (15/4) mu M5/M4 + (K - 5 mu/3) delta t^2,  t = (3/4) M5/(M4 delta)
 *                  in a plane: (8/pi) mu M4/M3 + (K_2 - 2 mu) delta t^2,  t = (2/pi) M4/(M3 delta)
 *                                                                                       (opening.2)
 *   a bond's energy density w_c = 4 G/(pi delta^4)    in a plane: 3 G/(2 h delta^3)     (opening.3)
 *
 * M_n the integral of w r^n from 0 to the horizon delta; K_2 as in (bond_based.3).  With w = 1,
 * (opening.1) is G = (9/5) K delta s^2 (Silling, Askari, Computers & Structures 83 (2005) 1526), 9
 * E delta s^2/(4 pi) in plane stress and 12 E delta s^2/(5 pi) in plane strain (Ha, Bobaru, Int. J.
 * Fract. 162 (2010) 229).  In (opening.2) t s is the dilatation that the crossing bonds alone make,
 * averaged over the layer that has any (Madenci, Oterkus, Peridynamic Theory and Its Applications
 * (2014), section 6.4).  Their own material has w = 1/r in the first term and 1/r^2 in the second:
 *
 *   a = (3 mu + (K - 5 mu/3) (9/16)^2) delta     in a plane: (6 mu/pi + (K_2 - 2 mu) 16/(9 pi^2))
 *       delta
 *                                                                                       (opening.4)
 *
 * (opening.3): Foster, Silling, Chen, Int. J. Multiscale Comput. Eng. 9 (2011) 675. */
#ifndef HS_OPENING_H
#define HS_OPENING_H

#include "family.h"
#include "lattice.h"
#include "material.h"

/* (opening.1), (opening.2): a [J/m^2]. */
double opening_bond_based(const struct material *material, enum plane plane,
                          const struct family *family, const struct lattice *lattice);
double opening_ordinary(const struct material *material, enum plane plane,
                        const struct family *family, const struct lattice *lattice);

/* (opening.4) [J/m^2]. */
double opening_madenci_oterkus(const struct material *material, enum plane plane,
                               const struct family *family, const struct lattice *lattice);

/* (opening.3): w_c/G [1/m^4]. */
double opening_energy_density(const struct family *family, const struct lattice *lattice);

#endif
