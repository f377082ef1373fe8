/* ordinary_linear.c - the linear peridynamic solid.
 *
 *   m_i = sum_j w |xi|^2 V_j,  a = w |xi|,  theta_i = (n/m_i) sum_j w |xi| e V_j
 *                                                                               (ordinary_linear.1)
 *   in space: n = 3, b = 15 mu/m, k = K - 5 mu/3                                (ordinary_linear.2)
 *   in a plane: n = 2, b = 8 mu/m, k = K_2 - 2 mu                               (ordinary_linear.3)
 *
 * Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, eq. (96)-(104); in a plane Le,
 * Chan, Schwartz, Int. J. Numer. Methods Engrg. 98 (2014) 547.  K_2 is the bulk modulus of the
 * plane.  m is that of the bonds that exist at the start.
 *
 * The springs of length changes alone would have one Poisson's ratio, as bond-based materials do;
 * the term in theta gives K its own value, whatever the springs make of it (k may be below 0).  D
 * and b are divided by the node's own weighted volume, so that theta is exact at a surface, too,
 * where all bonds stretch alike. */
#include "ordinary.h"

double ordinary_volumetric(const struct material *m, enum plane plane)
{
    const double of_springs = plane == SPACE ? 5 * m->shear_modulus / 3 : 2 * m->shear_modulus;
    return material_bulk_modulus(m, plane) - of_springs;
}

static struct ordinary_moduli moduli(const struct material *m, enum plane plane,
                                     const struct body *body, double weighted_volume,
                                     double isotropic)
{
    (void)body, (void)isotropic;
    if (!(weighted_volume > 0)) return (struct ordinary_moduli){0, 0, 0};
    return (struct ordinary_moduli){.dilatation = (plane == SPACE ? 3 : 2) / weighted_volume,
                                    .volumetric = ordinary_volumetric(m, plane),
                                    .distortion = (plane == SPACE ? 15 : 8) * m->shear_modulus /
                                                  weighted_volume};
}

const struct ordinary_law ordinary_linear = {.by_length = true, .moduli = moduli};
