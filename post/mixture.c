#include "mixture.h"

#include "root.h"

#include <math.h>

static const double most_plastic_strain = 10; /* far beyond any tensile test */

/* A constituent, or two, and what is to be reached. */
struct target {
    const struct constituent *constituent;
    double fraction, wanted;
};

static double excess_strain(double p, void *context)
{
    const struct target *t = context;
    return p + hardening_stress(&t->constituent->law, p) / t->constituent->modulus - t->wanted;
}

double constituent_stress(const struct constituent *constituent, double strain)
{
    if (hardening_stress(&constituent->law, 0) >= constituent->modulus * strain)
        return constituent->modulus * strain;
    struct target target = {.constituent = constituent, .wanted = strain};
    return hardening_stress(&constituent->law, root_between(excess_strain, &target, 0, strain));
}

static double excess_stress(double p, void *context)
{
    const struct target *t = context;
    return hardening_stress(&t->constituent->law, p) - t->wanted;
}

double constituent_strain(const struct constituent *constituent, double stress)
{
    const struct hardening *law = &constituent->law;
    const double elastic = stress / constituent->modulus;
    if (hardening_stress(law, 0) >= stress) return elastic;
    if (hardening_stress(law, most_plastic_strain) < stress) return INFINITY;
    struct target target = {.constituent = constituent, .wanted = stress};
    return elastic + root_between(excess_stress, &target, 0, most_plastic_strain);
}

double mixture_voigt(const struct constituent pair[2], double fraction, double strain)
{
    return (1 - fraction) * constituent_stress(&pair[0], strain) +
           fraction * constituent_stress(&pair[1], strain);
}

/* Bounded: a constituent that never reaches the stress is stretched without end. */
static double excess_mixture(double stress, void *context)
{
    const struct target *t = context;
    const double reached = (1 - t->fraction) * constituent_strain(&t->constituent[0], stress) +
                           t->fraction * constituent_strain(&t->constituent[1], stress);
    return fmin(reached, 2 * most_plastic_strain) - t->wanted;
}

double mixture_reuss(const struct constituent pair[2], double fraction, double strain)
{
    /* At the stress of the stiffer one the mixture is stretched by more than strain, or just so. */
    double high = fmax(constituent_stress(&pair[0], strain), constituent_stress(&pair[1], strain));
    struct target target = {pair, fraction, strain};
    const double stress = root_between(excess_mixture, &target, 0, high);
    return isnan(stress) ? high : stress; /* just so, to rounding */
}
