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
