#include "mixture.h"

#include <math.h>

enum { BISECTIONS = 64 }; /* more than a double has digits */

static const double most_plastic_strain = 10; /* far beyond any tensile test */

double constituent_stress(const struct constituent *constituent, double strain)
{
    double low = 0, high = strain;
    if (hardening_stress(&constituent->law, 0) >= constituent->modulus * strain)
        return constituent->modulus * strain;
    for (int i = 0; i < BISECTIONS; i++) {
        double p = (low + high) / 2;
        if (p + hardening_stress(&constituent->law, p) / constituent->modulus < strain)
            low = p;
        else
            high = p;
    }
    return hardening_stress(&constituent->law, high);
}

double constituent_strain(const struct constituent *constituent, double stress)
{
    const struct hardening *law = &constituent->law;
    double low = 0, high = most_plastic_strain, elastic = stress / constituent->modulus;
    if (hardening_stress(law, 0) >= stress) return elastic;
    if (hardening_stress(law, high) < stress) return INFINITY;
    for (int i = 0; i < BISECTIONS; i++) {
        double p = (low + high) / 2;
        if (hardening_stress(law, p) < stress)
            low = p;
        else
            high = p;
    }
    return elastic + high;
}

double mixture_voigt(const struct constituent pair[2], double fraction, double strain)
{
    return (1 - fraction) * constituent_stress(&pair[0], strain) +
           fraction * constituent_stress(&pair[1], strain);
}

double mixture_reuss(const struct constituent pair[2], double fraction, double strain)
{
    /* At the stress of the stiffer one the mixture is stretched by more than strain, or just so. */
    double low = 0;
    double high = fmax(constituent_stress(&pair[0], strain), constituent_stress(&pair[1], strain));
    for (int i = 0; i < BISECTIONS; i++) {
        double stress = (low + high) / 2;
        double reached = (1 - fraction) * constituent_strain(&pair[0], stress) +
                         fraction * constituent_strain(&pair[1], stress);
        if (reached < strain)
            low = stress;
        else
            high = stress;
    }
    return (low + high) / 2;
}
