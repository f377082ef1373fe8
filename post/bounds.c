#include "bounds.h"

#include "die.h"
#include "memory.h"
#include "mixture.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 601 };

static const double default_end = 0.3;

static void note_constituent(struct curve *curve, const char *key, const struct curve *from,
                             double modulus, const struct law_fit *fit)
{
    const struct hardening_law *law = fit->hardening.law;
    char *text =
        memory_print("%s: E = %.6g Pa, sigma = %s", from->title, modulus, law->variant.help);
    for (int k = 0; k < law->n_linear + law->n_shapes; k++)
        text = memory_append(text, ", %s = %.6g%s", law->parameters[k].symbol,
                             fit->hardening.parameter[k], k < law->n_linear ? " Pa" : "");
    char *all = memory_print("%s; fitted over plastic strain %.4g to %.4g, extrapolated beyond",
                             text, fit->first, fit->last);
    attributes_set_text(&curve->provenance, key, all);
    free(all);
    free(text);
}

/* Fits the law to one of the two curves, and notes it in the mixture's. */
static struct constituent constituent_of(struct curve *curve, const char *key,
                                         const struct curve *from, const struct analysis *analysis,
                                         const struct hardening_law *law)
{
    struct law_fit fit =
        true_curve_fit(&analysis->envelope, law, analysis->measures.uniform, analysis->fit_range);
    if (!fit.done || !(analysis->measures.modulus > 0))
        die_user("%s: too few points for the law %s up to maximum force; see --fit-range",
                 from->title, law->variant.name);
    note_constituent(curve, key, from, analysis->measures.modulus, &fit);
    return (struct constituent){fit.hardening, analysis->measures.modulus};
}

struct curve bounds_curve(enum bound bound, const struct curve pair[2],
                          const struct analysis analyses[2], const struct hardening_law *law,
                          double fraction, const double range[2])
{
    const char *name = bound == BOUND_VOIGT ? "Voigt" : "Reuss";
    char *title = memory_print("%s (%g %% %s)", name, 100 * fraction, pair[1].title);
    struct curve curve = curve_new(POINTS, title);
    free(title);
    attributes_set_text(&curve.provenance, "title", curve.title);
    attributes_set_text(&curve.provenance, "mixture",
                        bound == BOUND_VOIGT ? "iso-strain" : "iso-stress");
    attributes_set_number(&curve.provenance, "fraction_of_second", fraction);
    const struct constituent constituents[2] = {
        constituent_of(&curve, "first", &pair[0], &analyses[0], law),
        constituent_of(&curve, "second", &pair[1], &analyses[1], law)};

    double first = isnan(range[0]) ? 0 : range[0], last = isnan(range[1]) ? default_end : range[1];
    for (long i = 0; i < POINTS; i++) {
        /* Closer together where the curve bends. */
        double place = (double)i / (POINTS - 1);
        curve.strain[i] = first + (last - first) * place * place;
        double strain = log1p(curve.strain[i]);
        double stress = bound == BOUND_VOIGT ? mixture_voigt(constituents, fraction, strain)
                                             : mixture_reuss(constituents, fraction, strain);
        curve.stress[i] = stress / (1 + curve.strain[i]);
        curve.true_strain[i] = strain;
        curve.true_stress[i] = stress;
    }
    return curve;
}
