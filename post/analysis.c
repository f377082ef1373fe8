#include "analysis.h"

#include "die.h"
#include "memory.h"
#include "noise.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

static const double rounding =
    1e-6; /* of the highest stress, below which noise is that of written digits */
static const double filtered_share =
    1.3; /* of the noise by rows: more of it is correlated, as behind a filter */
static const double filtered_least = 0.3; /* correlation behind a filter */

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
    const struct elastic_line *line = &analysis->measures.line;
    if (line->count > 0) {
        char *rows = memory_print("%ld to %ld", analysis->rows[line->first] + 1,
                                  analysis->rows[line->last] + 1);
        attributes_set_text(notes, "slope_rows", rows);
        free(rows);
    }
    if (!isnan(line->slope)) {
        attributes_set_number(notes, "slope_Pa", line->slope);
        attributes_set_number(notes, "toe_strain", line->toe);
    }
    if (!isnan(analysis->measures.modulus))
        attributes_set_number(notes, "plastic_strain_modulus_Pa", analysis->measures.modulus);
    if (!isnan(choices->true_modulus))
        attributes_set_number(notes, "true_modulus_Pa", choices->true_modulus);
    attributes_set_text(notes, "true_curve", "toe removed; up to the maximum force");
    attributes_set_number(notes, "slope_window", analysis->window);
}

/* Rows that a user counts, in the curve, as rows of the envelope. */
static void renumber(const struct analysis *analysis, const struct curve *curve,
                     struct choices *choices)
{
    double *rows = choices->modulus_rows;
    if (isnan(rows[0])) return;
    if (rows[1] > (double)curve->n)
        die_user("modulus_rows: row %g of a curve of %ld", rows[1], curve->n);
    long first = 0, last = analysis->envelope.n - 1;
    while (first < last && (double)analysis->rows[first] < rows[0] - 1) first++;
    while (last > first && (double)analysis->rows[last] > rows[1] - 1) last--;
    rows[0] = (double)first + 1;
    rows[1] = (double)last + 1;
}

static void correct(struct analysis *analysis, struct curve *curve, struct elastic_line *line,
                    double modulus)
{
    strength_correct(curve, line, modulus);
    strength_correct(&analysis->envelope, line, modulus);
    line->error *= modulus / line->slope;
    line->slope = modulus;
    line->toe = 0;
    line->flag = "machine_compliance_removed";
}

/* Columns of the envelope back to the rows of the curve they are of. */
static void copy_back(const struct analysis *analysis, struct curve *curve)
{
    const struct curve *from = &analysis->envelope;
    for (long i = 0; i < from->n; i++) {
        const long row = analysis->rows[i];
        curve->true_strain[row] = from->true_strain[i];
        curve->true_stress[row] = from->true_stress[i];
        curve->plastic_strain[row] = from->plastic_strain[i];
        curve->hardening_rate[row] = from->hardening_rate[i];
    }
}

static void make_true_curve(struct analysis *analysis, const struct choices *choices)
{
    struct curve *curve = &analysis->envelope;
    const struct measures *m = &analysis->measures;
    const double noise = noise_of_means(analysis->noise);
    const long last = m->uniform;
    const long reach = last < m->maximum.row ? last : true_curve_reach(curve, last);
    analysis->window = true_curve_window(curve, last, choices->window, noise);
    true_curve_fill(curve, &m->line, m->modulus, reach, analysis->window);
    const struct slopes slopes = {m->modulus, m->yield.end > 0 ? m->yield.end : 0, reach, noise,
                                  analysis->window};
    analysis->considere = true_curve_considere(curve, &slopes);
    true_curve_cut(curve, last);
}

/* Which of stress and strain scatters more about the elastic line. */
static void compare_noise(struct curve *curve, const struct choices *choices)
{
    const double noise = noise_of(curve->strain, curve->stress, curve->n);
    if (!curve->measured) return;
    const struct elastic_line line = strength_line(curve, choices);
    const double strain = noise_of_strain(curve->strain, curve->n, line.first, line.count);
    curve->strain_is_noisier = strain > 0 && strain * line.slope > noise;
}

/* By the rows; and by what scatters more about the elastic line: correlated, it is what a filter
 * leaves of the noise of the stress, else it is the strain's. */
static void find_noise(struct analysis *analysis, const struct elastic_line *line)
{
    const struct curve *curve = &analysis->envelope;
    const double digits = rounding * gsl_stats_max(curve->stress, 1, (size_t)curve->n);
    struct noise *noise = &analysis->noise;
    analysis->strain_noise = noise_of_strain(curve->strain, curve->n, line->first, line->count);
    noise->deviation = noise_of(curve->strain, curve->stress, curve->n);
    if (noise->deviation <= digits) noise->deviation = 0;
    if (line->count == 0) return;
    struct noise along =
        noise_about_line(curve->strain + line->first, curve->stress + line->first, line->count);
    const double known = pow(line->slope * analysis->strain_noise, 2),
                 more = sqrt(fmax(pow(along.deviation, 2) - known, 0));
    if (more <= fmax(filtered_share * noise->deviation, 10 * digits)) return;
    if (along.correlation > filtered_least && noise->deviation > 0)
        *noise = noise_filtered(curve->stress, curve->n);
    else if (along.correlation <= filtered_least)
        analysis->strain_noise =
            sqrt(known + pow(more, 2) - pow(noise->deviation, 2)) / line->slope;
}

struct analysis analysis_make(struct curve *curve, const struct choices *choices, bool errors)
{
    struct analysis analysis = {0};
    struct choices chosen = *choices;
    record_turn(curve);
    add_neck_stress(curve);
    phases_add_factor(curve);
    compare_noise(curve, choices);
    const struct elastic_line rough = strength_line(curve, choices);
    analysis.record = record_judge(curve, &rough, choices->fracture_share);
    analysis.envelope = record_envelope(&analysis.record, curve, &analysis.rows);
    renumber(&analysis, curve, &chosen);
    struct elastic_line line = strength_line(&analysis.envelope, &chosen);
    if (curve->measured) find_noise(&analysis, &line);
    if (!analysis.envelope.strain_is_noisier &&
        analysis.strain_noise * line.slope > analysis.noise.deviation) {
        analysis.envelope.strain_is_noisier = true;
        line = strength_line(&analysis.envelope, &chosen);
    }
    if (!isnan(choices->true_modulus)) correct(&analysis, curve, &line, choices->true_modulus);

    const struct curve *envelope = &analysis.envelope;
    analysis.strained = envelope->n - 1;
    while (analysis.strained > 0 && analysis.rows[analysis.strained] > analysis.record.strained)
        analysis.strained--;
    const struct loading loading = {envelope, analysis.noise, analysis.strain_noise,
                                    analysis.strained, analysis.record.broken};
    analysis.measures = measures_take(&loading, &chosen, line);
    if (errors) measures_bootstrap(&loading, &chosen, &analysis.measures);
    make_true_curve(&analysis, choices);
    copy_back(&analysis, curve);
    analysis.fit_range[0] = fmax(choices->fit_range[0], log1p(analysis.measures.hardening));
    analysis.fit_range[1] = choices->fit_range[1];
    note_rules(curve, &analysis, choices);
    return analysis;
}

void analysis_free(struct analysis *analysis)
{
    record_free(&analysis->record);
    curve_free(&analysis->envelope);
    free(analysis->rows);
    *analysis = (struct analysis){0};
}
