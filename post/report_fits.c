#include "memory.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>

static const double mega = 1e6;

static void add_fit(struct properties *list, const struct law_fit *fit)
{
    const struct hardening_law *law = fit->hardening.law;
    const char *of = law->variant.name, *flag = law_fit_flag(fit);
    char *points = fit->count > 0 ? memory_print("true plastic strain %.4g to %.4g, %ld points",
                                                 fit->first, fit->last, fit->count)
                                  : memory_text("no points");
    for (int k = 0; k < law->n_linear + law->n_shapes; k++) {
        bool stress = k < law->n_linear;
        double scale = stress ? mega : 1;
        char *name = memory_print("%s_%s", of, law->parameters[k].name);
        properties_add(list, name, law->parameters[k].symbol, fit->hardening.parameter[k] / scale,
                       stress ? "MPa" : "1", fit->error[k] / scale, "sigma = %s, %s",
                       law->variant.help, points)
            ->flag = flag;
        free(name);
    }
    free(points);
    if (!fit->done) return;
    const struct {
        const char *name, *symbol, *unit, *definition;
        double value;
    } rows[] = {
        {"rms", "RMS", "MPa", "root mean square of the residuals", fit->root_mean_square / mega},
        {"max_error", "max", "MPa", "largest residual", fit->largest / mega},
        {"akaike", "AIC", "1", "n ln(mean square/MPa2) + 2 (parameters + 1)", fit->akaike},
        {"uniform_strain", "eps_u,p", "1", "plastic strain where d sigma/d eps_p = sigma",
         law_uniform_strain(&fit->hardening)},
    };
    for (int k = 0; k < 4; k++) {
        char *name = memory_print("%s_%s", of, rows[k].name);
        properties_add(list, name, rows[k].symbol, rows[k].value, rows[k].unit, NAN, "%s: %s", of,
                       rows[k].definition)
            ->flag = flag;
        free(name);
    }
}

void report_fits(struct properties *list, const struct analysis *analysis)
{
    const struct hardening_law *law;
    for (int i = 0; (law = hardening_law(i)); i++) {
        if (law->n_linear == 0) continue;
        struct law_fit fit = true_curve_fit(&analysis->envelope, law, analysis->measures.uniform,
                                            analysis->fit_range);
        add_fit(list, &fit);
    }
}
