#include "analysis.h"
#include "die.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

static const double giga = 1e9;
static const double least_modulus = 1e9, most_modulus = 1.2e12, most_strain = 3, most_stress = 2e10;
static const double usual_modulus[2] = {1e10, 6e11};

/* What makes of a metal's modulus the one that is there. */
static const struct {
    double factor; /* by which it is too small */
    const char *cause;
} mistakes[] = {
    {100, "the strain seems to be in per cent: write the unit, as in 'strain (%)', or --columns-of "
          "strain=NAME:%"},
    {1e-6, "the stress seems to be in Pa: write the unit, as in 'stress (Pa)', or --columns-of "
           "stress=NAME:Pa"},
    {1e-3, "the stress seems to be in kPa, or the strain in units of 0.1 %: write the units behind "
           "the names"},
    {1e3, "the stress seems to be in GPa: write the unit, as in 'stress (GPa)', or --columns-of "
          "stress=NAME:GPa"},
    {1e-1,
     "the strain seems to be in per cent and the stress in kPa: write the units behind the names"},
    {6.894757e-3, "the stress seems to be in psi: write the unit, as in 'stress (psi)'"},
    {1e5,
     "the strain seems to be in per cent and the stress in GPa: write the units behind the names"},
};

static const char *cause_of(double modulus)
{
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        const double right = modulus * mistakes[i].factor;
        if (right >= usual_modulus[0] && right <= usual_modulus[1]) return mistakes[i].cause;
    }
    return "are the units of the columns right, and does the strain come from an extensometer?";
}

void analysis_check_plausible(const struct curve *curve, const struct analysis *analysis)
{
    const double slope = analysis->measures.line.slope;
    const double strain = gsl_stats_max(curve->strain, 1, (size_t)curve->n);
    const double stress = gsl_stats_max(curve->stress, 1, (size_t)curve->n);
    const bool odd = slope < least_modulus || slope > most_modulus;
    if (!odd && !(strain > most_strain) && !(stress > most_stress)) return;
    const char *text = "%s: the slope of the elastic part is %.3g GPa, the largest strain %.3g, "
                       "the largest stress %.4g "
                       "MPa; expected 1 GPa to 1.2 TPa, at most 3 and 20,000 MPa; %s%s";
    if (curve->measured)
        die_user(text, curve->title, slope / giga, strain, stress / 1e6, cause_of(slope),
                 "; --accept takes it as it is");
    warn(text, curve->title, slope / giga, strain, stress / 1e6, "are the units in the deck right?",
         "");
}
