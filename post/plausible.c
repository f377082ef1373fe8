#include "analysis.h"
#include "die.h"
#include "memory.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

static const double giga = 1e9, mega = 1e6;
static const double least_modulus = 1e9, most_modulus = 1.2e12, most_strain = 3, most_stress = 2e10;
static const double most_elastic =
    0.1; /* strain, of the highest stress; bodies of atoms flow before */

/* What a metal has. */
static const double usual_modulus[2] = {1e10, 6e11}, usual_stress[2] = {2e7, 6e9};

struct unit {
    double factor; /* by which numbers are too large that were taken for pure numbers, or MPa */
    const char *name;
};

/* The likelier first. */
static const struct unit strains[] = {{1, NULL}, {100, "%"}, {1e6, "um/m"}};
static const struct unit stresses[] = {{1, NULL},    {1e6, "Pa"},          {1e-3, "GPa"},
                                       {1e3, "kPa"}, {145.0377377, "psi"}, {0.1450377377, "ksi"}};

enum { STRAINS = sizeof strains / sizeof *strains, STRESSES = sizeof stresses / sizeof *stresses };

struct seen {
    double modulus, strain, stress; /* Pa, -, Pa; the slope, and the largest ones */
};

static bool is_usual(const struct seen *seen, const struct unit *strain, const struct unit *stress)
{
    const double modulus = seen->modulus * strain->factor / stress->factor;
    const double highest = seen->stress / stress->factor;
    return modulus >= usual_modulus[0] && modulus <= usual_modulus[1] &&
           highest >= usual_stress[0] && highest <= usual_stress[1] &&
           highest <= most_elastic * modulus && seen->strain / strain->factor <= most_strain;
}

/* "the strain seems to be in %" and what to do. */
static char *say(const char *quantity, const char *unit)
{
    return memory_print(
        "the %s seems to be in %s: write the unit behind the name, as in '%s (%s)', "
        "or --columns-of %s=NAME:%s",
        quantity, unit, quantity, unit, quantity, unit);
}

static char *say_both(const char *strain, const char *stress)
{
    return memory_print(
        "the strain seems to be in %s and the stress in %s: write the units behind "
        "the names, as in 'strain (%s)', or --columns-of strain=NAME:%s,stress=NAME:%s",
        strain, stress, strain, strain, stress);
}

static char *cause_of(const struct seen *seen)
{
    for (int i = 1; i < STRAINS; i++)
        if (is_usual(seen, &strains[i], &stresses[0])) return say("strain", strains[i].name);
    for (int k = 1; k < STRESSES; k++)
        if (is_usual(seen, &strains[0], &stresses[k])) return say("stress", stresses[k].name);
    for (int i = 1; i < STRAINS; i++)
        for (int k = 1; k < STRESSES; k++)
            if (is_usual(seen, &strains[i], &stresses[k]))
                return say_both(strains[i].name, stresses[k].name);
    return memory_text("are the units of the columns right, does the strain come from an "
                       "extensometer, and does the "
                       "record begin before the body yields?");
}

static bool is_odd(const struct seen *seen)
{
    return seen->modulus < least_modulus || seen->modulus > most_modulus ||
           seen->strain > most_strain || seen->stress > most_stress ||
           seen->stress > most_elastic * seen->modulus;
}

void analysis_check_plausible(const struct curve *curve, const struct analysis *analysis)
{
    const struct curve *envelope = &analysis->envelope;
    const struct seen seen = {analysis->measures.line.slope,
                              gsl_stats_max(envelope->strain, 1, (size_t)envelope->n),
                              gsl_stats_max(envelope->stress, 1, (size_t)envelope->n)};
    if (!is_odd(&seen)) return;
    char *cause =
        curve->measured ? cause_of(&seen) : memory_text("are the units in the deck right?");
    char *text =
        memory_print("%s: the slope of the elastic part is %.3g GPa, the largest strain %.3g, the "
                     "largest stress "
                     "%.4g MPa; expected 1 GPa to 1.2 TPa, at most 3 and 20,000 MPa, and no stress "
                     "above a tenth "
                     "of the slope; %s",
                     curve->title, seen.modulus / giga, seen.strain, seen.stress / mega, cause);
    if (curve->measured) die_user("%s; --accept takes it as it is", text);
    warn("%s", text);
    free(cause);
    free(text);
}
