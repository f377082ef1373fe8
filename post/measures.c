#include "measures.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RESAMPLES = 250 };

const double measures_offsets[4] = {0.0001, 0.001, 0.002, 0.01};

static const double smoothing_width =
    0.0005; /* of strain: that over which ISO 6892-1 seeks a yield point */
static const double level_share = 1e-4; /* of the stress: a maximum, ASTM E8 */
static const double total_extension = 0.005;

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

/* Yield point and maximum, which a plateau moves behind itself. */
static void find_marks(const struct loading *loading, const struct choices *choices,
                       struct measures *m)
{
    const struct curve *curve = loading->curve;
    double *smooth = memory_new((size_t)curve->n, sizeof *smooth), left;
    noise_smooth(curve->strain, curve->stress, curve->n, smoothing_width, loading->noise, smooth,
                 &left);
    const struct yield_record record = {curve->n,
                                        curve->strain,
                                        curve->stress,
                                        smooth,
                                        loading->noise.deviation,
                                        left,
                                        loading->noise.deviation > 0 ? smoothing_width : 0,
                                        m->line.slope,
                                        m->line.toe};
    const bool zero_slope = choices->standard == STANDARD_ASTM;
    m->yield = yield_point_find(&record, zero_slope ? level_share : choices->yield_drop);
    m->maximum =
        strength_maximum(curve, smooth, left, m->yield.row < 0 ? 0 : m->yield.end, loading->broken);
    free(smooth);
}

static void harden(const struct loading *loading, const struct choices *choices, struct measures *m)
{
    const struct elastic_line *line = &m->line;
    const double toe = line->toe, *e = loading->curve->strain, *s = loading->curve->stress;
    double uniform = m->maximum.strain - toe - m->maximum.stress / line->slope;
    if (m->uniform < m->maximum.row) uniform = e[m->uniform] - toe - s[m->uniform] / line->slope;
    const double low = fmax(choices->hardening_range[0], m->hardening);
    const double high = choices->hardening_range[1];
    const double modulus = choices->standard == STANDARD_ASTM ? INFINITY : m->modulus;
    m->cut_at_maximum = uniform < high;
    m->power_law =
        true_curve_power_law(loading->curve, line, modulus, m->uniform, low, fmin(high, uniform));
}

static void fill_values(const struct loading *loading, struct measures *m)
{
    const struct curve *curve = loading->curve;
    const struct elastic_line *line = &m->line;
    const double toe = isnan(line->toe) ? 0 : line->toe;
    double *value = m->value;
    value[MEASURE_MODULUS] = line->slope;
    value[MEASURE_TOE] = line->toe;
    for (int k = 0; k < 4; k++)
        value[MEASURE_PROOF_001 + k] = strength_proof(curve, line, measures_offsets[k]);
    value[MEASURE_TOTAL_05] = strength_total(curve, line, total_extension);
    value[MEASURE_UPPER] = m->yield.upper;
    value[MEASURE_LOWER] = m->yield.lower;
    value[MEASURE_YIELD_EXTENSION] = m->yield.extension;
    value[MEASURE_STRENGTH] = m->maximum.stress;
    const bool measured = m->maximum.row <= loading->strained;
    const double total = (measured ? m->maximum.strain : curve->strain[loading->strained]) - toe;
    value[MEASURE_EXTENSION] = total;
    value[MEASURE_PLASTIC_EXTENSION] = total - m->maximum.stress / line->slope;
    value[MEASURE_FRACTURE] = curve->strain[m->fracture] - toe;
    value[MEASURE_PLASTIC_FRACTURE] =
        value[MEASURE_FRACTURE] - curve->stress[m->fracture] / line->slope;
    value[MEASURE_EXPONENT] = m->power_law.exponent;
    value[MEASURE_COEFFICIENT] = m->power_law.strength;
}

struct measures measures_take(const struct loading *loading, const struct choices *choices,
                              struct elastic_line line)
{
    struct measures m = {.line = line};
    const struct curve *curve = loading->curve;
    m.modulus = plastic_modulus(curve, &line, choices);
    find_marks(loading, choices, &m);
    m.fracture = loading->strained;
    m.uniform = m.maximum.row < loading->strained ? m.maximum.row : loading->strained;
    if (m.yield.row >= 0)
        m.hardening = curve->strain[m.yield.row] + m.yield.extension - line.toe -
                      curve->stress[m.yield.end] / line.slope;
    harden(loading, choices, &m);
    fill_values(loading, &m);
    return m;
}

static struct curve trend_of(const struct loading *loading)
{
    const struct curve *from = loading->curve;
    long *rows = memory_new((size_t)from->n, sizeof *rows);
    for (long i = 0; i < from->n; i++) rows[i] = i;
    struct curve trend = curve_rows(from, from->n, rows);
    noise_trend(from->strain, trend.stress, from->n, loading->noise);
    if (loading->strain_noise > 0)
        noise_trend(from->strain, trend.strain, from->n, (struct noise){loading->strain_noise, 0});
    free(rows);
    return trend;
}

void measures_bootstrap(const struct loading *loading, const struct choices *choices,
                        struct measures *measures)
{
    const struct curve *from = loading->curve;
    const struct noise noise = loading->noise;
    const bool noisy = noise.deviation > 0 || loading->strain_noise > 0;
    if (!noisy || measures->line.count == 0) return;
    struct curve trend = trend_of(loading);
    const struct loading smooth = {&trend, loading->noise, loading->strain_noise, loading->strained,
                                   loading->broken};
    const struct measures reference =
        measures_take(&smooth, choices, strength_line(&trend, choices));
    double squares[MEASURES] = {0};
    long counts[MEASURES] = {0};
    double *strain = memory_new((size_t)from->n, sizeof *strain);
    double *stress = memory_new((size_t)from->n, sizeof *stress);
    memcpy(strain, trend.strain, (size_t)from->n * sizeof *strain);
    memcpy(stress, trend.stress, (size_t)from->n * sizeof *stress);
    struct random_stream *stream = random_new(1, "bootstrap");
    for (int k = 0; k < RESAMPLES; k++) {
        struct noise_sequence sequence = noise_begin(noise, stream);
        for (long i = 0; i < from->n; i++) {
            trend.strain[i] = strain[i] + loading->strain_noise * random_gaussian(stream);
            trend.stress[i] = stress[i] + noise_next(&sequence, stream);
        }
        const struct measures drawn =
            measures_take(&smooth, choices, strength_line(&trend, choices));
        for (int j = 0; j < MEASURES; j++) {
            const double change = drawn.value[j] - reference.value[j];
            if (!isfinite(change)) continue;
            squares[j] += change * change;
            counts[j]++;
        }
    }
    for (int j = 0; j < MEASURES; j++)
        measures->error[j] = counts[j] > RESAMPLES / 2 ? sqrt(squares[j] / (double)counts[j]) : NAN;
    random_free(stream);
    free(strain);
    free(stress);
    curve_free(&trend);
}
