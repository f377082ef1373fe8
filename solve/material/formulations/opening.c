/* opening.c - from a fracture energy to the stretch, or the energy, at which single bonds break
 * (opening.h).
 *
 * A crack that opens has cut all bonds across it, so their energies add up to the fracture energy.
 * The sum is that of the continuum, an integral over the horizon (family_moment), not that of the
 * lattice: the value belongs to the material and its horizon, and what a lattice of few spacings a
 * horizon makes of it differs from it by direction.  An ordinary bond holds a share of its ends'
 * dilatation, too, which only the bonds across the crack make: the second term. */
#include "opening.h"

#include <math.h>

/* M_n/M_(n-1) [m] */
static double ratio(const struct family *family, const struct lattice *lattice, int n)
{
    return family_moment(family, n) / family_moment(family, n - 1) * lattice->spacing;
}

double opening_bond_based(const struct material *m, enum plane plane, const struct family *family,
                          const struct lattice *lattice)
{
    const double pi = acos(-1);
    if (plane == SPACE) return 2.25 * m->bulk_modulus * ratio(family, lattice, 4);
    return 4 / pi * material_bulk_modulus(m, plane) * ratio(family, lattice, 3);
}

double opening_ordinary(const struct material *m, enum plane plane, const struct family *family,
                        const struct lattice *lattice)
{
    const double pi = acos(-1), delta = family->horizon * lattice->spacing, mu = m->shear_modulus;
    if (plane == SPACE) {
        const double length = ratio(family, lattice, 5), t = 0.75 * length / delta;
        return 3.75 * mu * length + (m->bulk_modulus - 5 * mu / 3) * delta * t * t;
    }
    const double length = ratio(family, lattice, 4), t = 2 / pi * length / delta;
    return 8 / pi * mu * length + (material_bulk_modulus(m, plane) - 2 * mu) * delta * t * t;
}

double opening_madenci_oterkus(const struct material *m, enum plane plane,
                               const struct family *family, const struct lattice *lattice)
{
    const double pi = acos(-1), delta = family->horizon * lattice->spacing, mu = m->shear_modulus;
    if (plane == SPACE) return (3 * mu + (m->bulk_modulus - 5 * mu / 3) * 81 / 256) * delta;
    return (6 * mu / pi + (material_bulk_modulus(m, plane) - 2 * mu) * 16 / (9 * pi * pi)) * delta;
}

double opening_energy_density(const struct family *family, const struct lattice *lattice)
{
    const double pi = acos(-1), delta = family->horizon * lattice->spacing;
    if (lattice->dimensions == 2) return 1.5 / (lattice->thickness * pow(delta, 3));
    return 4 / (pi * pow(delta, 4));
}
