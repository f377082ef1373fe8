/* madenci_oterkus.c - the ordinary material with the parameters a, b, d of Madenci and Oterkus.
 *
 *   theta_i = d delta sum_j s V_j,  s = (|y| - |xi|)/|xi|                       (madenci_oterkus.1)
 *   t_ij = 2 a d delta theta_i/|xi| + 2 b (delta/|xi|) e                        (madenci_oterkus.2)
 *   in space:   2 a = K - 5 mu/3, b = 15 mu/(2 pi delta^5), d = 9/(4 pi delta^4)
 *                                                                               (madenci_oterkus.3)
 *   in a plane: 2 a = K_2 - 2 mu, b = 6 mu/(pi h delta^4),  d = 2/(pi h delta^3)
 *                                                                               (madenci_oterkus.4)
 *
 * Madenci, Oterkus, Peridynamic Theory and Its Applications (2014), chapter 4.  The influence
 * function is delta/|xi|; the weight of a bond holds dx/|xi|.  Their factor Lambda, the cosine
 * between a bond before and after, is 1 to second order in the displacement and is left out: with
 * it in theta alone the force would not be the gradient of an energy. */
#include "ordinary.h"

#include <math.h>

static struct ordinary_moduli moduli(const struct material *m, enum plane plane,
                                     const struct body *body, double weighted_volume,
                                     double isotropic)
{
    const double pi = acos(-1), dx = body->lattice->spacing, h = body->lattice->thickness,
                 horizon = body->family->horizon, delta = horizon * dx, mu = m->shear_modulus;
    const double b =
        plane == SPACE ? 15 * mu / (2 * pi * pow(delta, 5)) : 6 * mu / (pi * h * pow(delta, 4));
    const double d = plane == SPACE ? 9 / (4 * pi * pow(delta, 4)) : 2 / (pi * h * pow(delta, 3));
    if (!(weighted_volume > 0)) return (struct ordinary_moduli){0, 0, 0};
    return (struct ordinary_moduli){.dilatation = d * horizon / isotropic,
                                    .volumetric = ordinary_volumetric(m, plane),
                                    .distortion = 2 * b * horizon};
}

const struct ordinary_law ordinary_madenci_oterkus = {.by_length = false, .moduli = moduli};
