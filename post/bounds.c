#include "bounds.h"

#include "die.h"
#include "memory.h"
#include "mixture.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 601 };

static const double default_end = 0.3;

static struct constituent constituent_of(const struct curve *curve, const struct analysis *analysis,
                                         const struct law *law)
{
    for (int k = 0; k < LAW_COUNT; k++)
        if (analysis->fits[k].law == law && analysis->fits[k].done && analysis->modulus > 0)
            return (struct constituent){analysis->fits[k], analysis->modulus};
    die_user("%s: too few points for the law %s up to maximum force; see --fit-range", curve->title,
             law->name);
}

static void note_constituent(struct curve *curve, const char *key, const struct curve *from,
                             const struct constituent *constituent)
{
    const struct law_fit *fit = &constituent->law;
    char *text = memory_print("%s: E = %.6g Pa, sigma = %s", from->title, constituent->modulus,
                              fit->law->formula);
    for (int k = 0; k < fit->law->n_linear + fit->law->n_shapes; k++) {
        char *longer = memory_print("%s, %s = %.6g%s", text, fit->law->parameters[k].symbol,
                                    fit->parameter[k], k < fit->law->n_linear ? " Pa" : "");
        free(text);
        text = longer;
    }
    char *all = memory_print("%s; fitted over plastic strain %.4g to %.4g, extrapolated beyond",
                             text, fit->first, fit->last);
    attributes_set_text(&curve->provenance, key, all);
    free(all);
    free(text);
}

struct curve bounds_curve(enum bound bound, const struct curve pair[2],
                          const struct analysis analyses[2], const struct law *law, double fraction,
                          const double range[2])
{
    struct constituent constituents[2] = {constituent_of(&pair[0], &analyses[0], law),
                                          constituent_of(&pair[1], &analyses[1], law)};
    const char *name = bound == BOUND_VOIGT ? "Voigt" : "Reuss";
    char *title = memory_print("%s (%g %% %s)", name, 100 * fraction, pair[1].title);
    struct curve curve = curve_new(POINTS, title);
    free(title);
    attributes_set_text(&curve.provenance, "title", curve.title);
    attributes_set_text(&curve.provenance, "mixture",
                        bound == BOUND_VOIGT ? "iso-strain" : "iso-stress");
    attributes_set_number(&curve.provenance, "fraction_of_second", fraction);
    note_constituent(&curve, "first", &pair[0], &constituents[0]);
    note_constituent(&curve, "second", &pair[1], &constituents[1]);

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
