#include "analysis.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

/* E of the plastic strain: chosen, known to the solver, as the file says, or the measured slope. */
static double plastic_modulus(const struct curve *curve, const struct elastic_line *line,
                              const struct choices *choices)
{
    bool refitted = !isnan(choices->modulus_rows[0]) || !isnan(choices->modulus_range[0]);
    double recorded = attributes_number(&curve->provenance, "plastic_strain_modulus_Pa", NAN);
    if (!isnan(choices->modulus)) return choices->modulus;
    if (!isnan(curve->youngs_modulus)) return curve->youngs_modulus;
    return recorded > 0 && !refitted ? recorded : line->slope;
}

/* Force over the smallest section: a mean stress in the neck, with no correction for its
 * triaxiality. */
static void add_neck_stress(struct curve *curve)
{
    const double *ratio = table_find(&curve->table, "minimum_section_ratio");
    if (!ratio) return;
    double *stress = table_add(&curve->table, "neck_stress_Pa");
    for (long i = 0; i < curve->n; i++)
        if (ratio[i] > 0) stress[i] = curve->stress[i] / ratio[i];
}

static void note_rules(struct curve *curve, const struct analysis *analysis,
                       const struct choices *choices)
{
    struct attributes *notes = &curve->provenance;
    const struct elastic_line *line = &analysis->line;
    if (line->count > 0) {
        char *rows = memory_print("%ld to %ld", line->first + 1, line->last + 1);
        attributes_set_text(notes, "slope_rows", rows);
        free(rows);
    }
    if (!isnan(line->slope)) {
        attributes_set_number(notes, "slope_Pa", line->slope);
        attributes_set_number(notes, "toe_strain", line->toe);
    }
    if (!isnan(analysis->modulus))
        attributes_set_number(notes, "plastic_strain_modulus_Pa", analysis->modulus);
    if (!isnan(choices->true_modulus))
        attributes_set_number(notes, "true_modulus_Pa", choices->true_modulus);
    attributes_set_text(notes, "true_curve", "toe removed; up to the maximum force");
    attributes_set_number(notes, "slope_window", choices->window);
}

static struct power_law harden(const struct curve *curve, struct analysis *analysis,
                               const struct choices *choices)
{
    const struct elastic_line *line = &analysis->line;
    const struct strength_maximum *maximum = &analysis->maximum;
    double uniform = maximum->strain - line->toe - maximum->stress / line->slope;
    double low = choices->hardening_range[0], high = choices->hardening_range[1];
    analysis->cut_at_maximum = uniform < high;
    return true_curve_power_law(curve, line, maximum->row, low, fmin(high, uniform));
}

struct analysis analysis_make(struct curve *curve, const struct choices *choices)
{
    struct analysis analysis = {.line = strength_line(curve, choices),
                                .fit_range = {choices->fit_range[0], choices->fit_range[1]}};
    if (!isnan(choices->true_modulus)) {
        strength_correct(curve, &analysis.line, choices->true_modulus);
        analysis.line.error *= choices->true_modulus / analysis.line.slope;
        analysis.line.slope = choices->true_modulus;
        analysis.line.toe = 0;
        analysis.line.flag = "machine_compliance_removed";
    }
    analysis.maximum = strength_maximum(curve);
    analysis.fracture = strength_fracture_row(curve, choices->fracture_share, &analysis.broken);
    analysis.modulus = plastic_modulus(curve, &analysis.line, choices);

    long last = analysis.maximum.row;
    long reach = true_curve_reach(curve, last);
    true_curve_fill(curve, &analysis.line, analysis.modulus, reach, choices->window);
    analysis.considere = true_curve_considere(curve, analysis.modulus, reach);
    true_curve_cut(curve, last);
    analysis.power_law = harden(curve, &analysis, choices);
    add_neck_stress(curve);
    phases_add_factor(curve);
    note_rules(curve, &analysis, choices);
    return analysis;
}
