#include "report.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

static const double giga = 1e9, mega = 1e6, percent = 100;
static const double deviation_limit = 0.01; /* of the slope from the modulus of the deck */
static const double noisy_share = 0.1;      /* error of Considere's strain over it */

/* An error that is 0 is none that is known. */
static double known(double error)
{
    return error > 0 ? error : NAN;
}

static void add_elastic(struct properties *list, const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    const struct measures *m = &analysis->measures;
    const struct elastic_line *line = &m->line;
    char *how = line->count > 0
                    ? memory_print("least squares over rows %ld to %ld",
                                   analysis->rows[line->first] + 1, analysis->rows[line->last] + 1)
                    : memory_text("not fitted to this curve");
    const bool poor = curve->measured && line->r_squared < straight_limit;
    properties_add(list, "modulus", "m_E", line->slope / giga, "GPa",
                   known(fmax(line->error, m->error[MEASURE_MODULUS])) / giga,
                   "slope of engineering stress on strain, %s", how)
        ->flag = line->flag ? line->flag
                 : poor     ? "not_straight"
                            : NULL;
    free(how);
    properties_add(list, "modulus_r_squared", "R2", line->r_squared, "1", NAN,
                   "coefficient of determination of the slope, %ld points", line->count);
    properties_add(
        list, "toe", "e0", line->toe, "1", known(m->error[MEASURE_TOE]),
        "strain where the straight part meets zero stress; subtracted from all extensions");
    if (isnan(curve->youngs_modulus) || line->count == 0) return;
    const double deviation = line->slope / curve->youngs_modulus - 1;
    properties_add(list, "modulus_deviation", "m_E/E-1", percent * deviation, "%", NAN,
                   "slope against the Young's modulus given to the solver, %g GPa",
                   curve->youngs_modulus / giga)
        ->flag = fabs(deviation) > deviation_limit ? "modulus_off" : NULL;
}

/* A row of measures[what], scaled; its flag where it is blank. */
static struct property *add_measure(struct properties *list, const struct analysis *analysis,
                                    enum measure what, const char *name, const char *symbol,
                                    double scale, const char *unit, const char *definition)
{
    const struct measures *m = &analysis->measures;
    return properties_add(list, name, symbol, m->value[what] / scale, unit,
                          isnan(m->value[what]) ? NAN : known(m->error[what] / scale), "%s",
                          definition);
}

/* Why there is none of what lies further on. */
static const char *not_reached(const struct analysis *analysis)
{
    return analysis->record.broken ? "broke_before" : "not_reached";
}

static void add_proofs(struct properties *list, const struct analysis *analysis)
{
    static const char *const offsets[] = {"0.01", "0.1", "0.2", "1.0"};
    const char *blank =
        isnan(analysis->measures.line.slope) ? "no_elastic_part" : not_reached(analysis);
    for (int k = 0; k < 4; k++) {
        const enum measure what = MEASURE_PROOF_001 + (enum measure)k;
        char *name = memory_print("proof_strength_%s", offsets[k]);
        char *symbol = memory_print("Rp%s", offsets[k]);
        char *definition = memory_print(
            "stress at the first crossing of s = m_E (e - e0 - %s %%), linear between points",
            offsets[k]);
        struct property *row =
            add_measure(list, analysis, what, name, symbol, mega, "MPa", definition);
        if (isnan(row->value)) row->flag = blank;
        free(name);
        free(symbol);
        free(definition);
    }
    struct property *row =
        add_measure(list, analysis, MEASURE_TOTAL_05, "total_extension_strength_0.5", "Rt0.5", mega,
                    "MPa", "stress at a total extension e - e0 of 0.5 %");
    if (isnan(row->value)) row->flag = not_reached(analysis);
}

/* Rp0.2 by the line through the ends of the first unloading, where there is one: its slope does
 * not depend on how straight the beginning of the test was. */
static void add_proof_by_loop(struct properties *list, const struct curve *curve,
                              const struct analysis *analysis)
{
    const struct excursion *loop = NULL;
    for (long i = analysis->record.count - 1; i >= 0; i--)
        if (analysis->record.excursions[i].kind == EXCURSION_LOOP)
            loop = &analysis->record.excursions[i];
    if (!loop) return;
    const double *e = curve->strain, *s = curve->stress;
    struct elastic_line line = {.slope = (s[loop->begin] - s[loop->bottom]) /
                                         (e[loop->begin] - e[loop->bottom])};
    line.toe = INFINITY; /* the corrected origin: the line of that slope that touches the rise */
    for (long i = 0; i < analysis->envelope.n && analysis->rows[i] <= loop->begin; i++)
        line.toe = fmin(line.toe,
                        analysis->envelope.strain[i] - analysis->envelope.stress[i] / line.slope);
    const double stress = strength_proof(&analysis->envelope, &line, measures_offsets[2]);
    properties_add(
        list, "proof_strength_0.2_loop", "Rp0.2(loop)", stress / mega, "MPa", NAN,
        "by the slope of the first unloading, %.4g GPa, from the line of that slope that touches "
        "the rise",
        line.slope / giga)
        ->flag = isnan(stress) ? not_reached(analysis) : NULL;
}

static void add_yield_point(struct properties *list, const struct analysis *analysis,
                            const struct choices *choices)
{
    const long row = analysis->measures.yield.row;
    const double *kinetic = table_find(&analysis->envelope.table, "kinetic_to_internal");
    const char *flag = row < 0                                    ? "no_yield_point"
                       : kinetic[row] > report_quasi_static_limit ? "not_quasi_static"
                                                                  : NULL;
    char *definition =
        choices->standard == STANDARD_ASTM
            ? memory_text(
                  "first maximum of zero slope, not exceeded over 0.05 % of strain, with a rise "
                  "behind it (ASTM E8)")
            : memory_print(
                  "highest stress before a fall of %g %% or more, not exceeded over 0.05 %% of "
                  "strain, with a rise behind it (ISO 6892-1)",
                  percent * choices->yield_drop);
    add_measure(list, analysis, MEASURE_UPPER, "upper_yield_strength", "ReH", mega, "MPa",
                definition)
        ->flag = flag;
    add_measure(
        list, analysis, MEASURE_LOWER, "lower_yield_strength", "ReL", mega, "MPa",
        "lowest stress of the plateau, without the initial transient where a later valley follows")
        ->flag = flag;
    add_measure(list, analysis, MEASURE_YIELD_EXTENSION, "yield_point_extension", "Ae", 1 / percent,
                "%",
                "from the upper yield point to where the steepest line of work hardening meets the "
                "last minimum")
        ->flag = flag;
    free(definition);
}

static void add_strength(struct properties *list, const struct analysis *analysis)
{
    const struct measures *m = &analysis->measures;
    add_measure(list, analysis, MEASURE_STRENGTH, "tensile_strength", "Rm", mega, "MPa",
                m->yield.row < 0
                    ? "largest force over the initial section"
                    : "largest force behind the yield plateau over the initial section")
        ->flag = m->maximum.reached ? NULL : "not_reached";
    properties_add(list, "tensile_strength_reached", "", m->maximum.reached ? 1 : 0, "1", NAN,
                   "1 where the maximum lies inside the curve, 0 where it is its last point");
}

static void add_extensions(struct properties *list, const struct curve *curve,
                           const struct analysis *analysis, const struct choices *choices)
{
    const struct measures *m = &analysis->measures;
    const bool stopped = analysis->strained < analysis->envelope.n - 1;
    const char *open = m->maximum.row > analysis->strained ? "strain_not_measured"
                       : m->maximum.reached                ? NULL
                                                           : "lower_bound";
    const char *end = stopped                     ? "strain_not_measured"
                      : analysis->record.unloaded ? "unloaded"
                      : analysis->record.broken   ? NULL
                                                  : "curve_ends";
    add_measure(list, analysis, MEASURE_EXTENSION, "extension_at_maximum_force", "Agt", 1 / percent,
                "%", "total extension at maximum force, e - e0; middle of the plateau")
        ->flag = open;
    add_measure(list, analysis, MEASURE_PLASTIC_EXTENSION, "plastic_extension_at_maximum_force",
                "Ag", 1 / percent, "%", "Agt - Rm/m_E")
        ->flag = open;
    properties_add(
        list, "plateau_width", "", percent * m->maximum.plateau, "%", NAN,
        "extension over which the stress stays within %g Rm, or three times its noise, of Rm",
        strength_plateau_share);
    char *definition =
        memory_print("e - e0 at the last point before the force falls below %g %% of its maximum, "
                     "else at the last point",
                     percent * choices->fracture_share);
    add_measure(list, analysis, MEASURE_FRACTURE, "extension_at_fracture", "At", 1 / percent, "%",
                definition)
        ->flag = end;
    free(definition);
    add_measure(list, analysis, MEASURE_PLASTIC_FRACTURE, "plastic_extension_at_fracture", "A",
                1 / percent, "%", "At - s/m_E at the fracture point, on the gauge length L0")
        ->flag = end;
    properties_add(list, "gauge_length", "L0", curve->gauge_length, "m", NAN,
                   "initial distance of the gauge planes");
    properties_add(list, "section", "S0", curve->section, "m2", NAN, "initial section");
    properties_add(list, "proportionality", "k", curve->gauge_length / sqrt(curve->section), "1",
                   NAN, "L0/sqrt(S0); 5.65 is the proportional test piece");
}

static void add_neck(struct properties *list, const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    const double *ratio = table_find(&curve->table, "minimum_section_ratio");
    const double *place = table_find(&curve->table, "minimum_section_x_m");
    long row = analysis->measures.fracture;
    if (ratio)
        properties_add(list, "reduction_of_area", "Z", percent * (1 - ratio[row]), "%", NAN,
                       "1 - smallest section/initial section at the fracture point; section from "
                       "the mean lateral stretch of a layer of nodes")
            ->flag = analysis->record.broken ? NULL : "curve_ends";
    if (ratio && curve->strain[row] > 0)
        properties_add(list, "localisation", "", -log(ratio[row]) / log1p(curve->strain[row]), "1",
                       NAN, "logarithmic strain of the smallest section over that of the gauge");
    if (place)
        properties_add(list, "neck_position", "x_neck", place[row], "m", NAN,
                       "where the section is smallest at the fracture point");
}

static void add_energies(struct properties *list, const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    const struct elastic_line *line = &analysis->measures.line;
    double proof = strength_proof(curve, line, 0.002);
    properties_add(list, "toughness", "U_T",
                   strength_energy(curve, line, analysis->measures.fracture) / mega, "MJ/m3", NAN,
                   "area under the engineering curve from the toe to the fracture point")
        ->flag = analysis->record.broken ? NULL : "curve_ends";
    properties_add(list, "energy_to_maximum_force", "U_m",
                   strength_energy(curve, line, analysis->measures.maximum.row) / mega, "MJ/m3",
                   NAN, "area under the engineering curve from the toe to the maximum force");
    properties_add(list, "resilience", "U_r", proof * proof / (2 * line->slope) / mega, "MJ/m3",
                   NAN, "Rp0.2^2/(2 m_E)");
}

/* Plastic strain ratio, of tables with a strain across the specimen. */
static void add_ratio(struct properties *list, const struct analysis *analysis, const char *range)
{
    const struct measures *m = &analysis->measures;
    if (!table_find(&analysis->envelope.table, "transverse_strain")) return;
    const struct strain_ratio found = true_curve_ratio(
        &analysis->envelope, &m->line, m->modulus, m->uniform, m->power_law.low, m->power_law.high);
    char *symbol = memory_print("r%s", range);
    properties_add(
        list, "plastic_strain_ratio", symbol, found.ratio, "1", known(found.error),
        "-m/(1 + m), m the slope of the true plastic strain across on that along (ISO 10113), "
        "%ld points",
        found.count)
        ->flag = isnan(found.ratio) ? "too_few_points" : NULL;
    free(symbol);
}

static void add_hardening(struct properties *list, const struct analysis *analysis)
{
    const struct power_law *law = &analysis->measures.power_law;
    char *range = analysis->measures.cut_at_maximum
                      ? memory_print("%g-Ag", percent * law->low)
                      : memory_print("%g-%g", percent * law->low, percent * law->high);
    char *symbol = memory_print("n%s", range);
    char *squared =
        isnan(law->r_squared) ? memory_text("") : memory_print(", R2 %.5f", law->r_squared);
    const char *flag = isnan(law->exponent) ? "too_few_points" : NULL;
    properties_add(list, "hardening_exponent", symbol, law->exponent, "1",
                   known(fmax(law->error, analysis->measures.error[MEASURE_EXPONENT])),
                   "regression of ln(true stress) on ln(true plastic strain), engineering plastic "
                   "strain %g to %g %%, %ld points%s",
                   percent * law->low, percent * law->high, law->count, squared)
        ->flag = flag;
    free(squared);
    properties_add(list, "hardening_strength", "K", law->strength / mega, "MPa",
                   known(fmax(law->strength_error, analysis->measures.error[MEASURE_COEFFICIENT])) /
                       mega,
                   "true stress = K (true plastic strain)^n, as above")
        ->flag = flag;
    free(symbol);
    add_ratio(list, analysis, range);
    free(range);

    const struct considere *considere = &analysis->considere;
    double toe = isnan(analysis->measures.line.toe) ? 0 : analysis->measures.line.toe;
    double total = log1p(analysis->measures.maximum.strain - toe);
    const bool strained = analysis->measures.uniform == analysis->measures.maximum.row;
    flag = isnan(considere->strain) ? strained ? not_reached(analysis) : "strain_not_measured"
           : considere->error > noisy_share * considere->strain ? "noisy"
                                                                : NULL;
    properties_add(list, "considere_strain", "eps_u", considere->strain, "1", considere->error,
                   "true strain where d sigma/d eps falls to sigma; slopes of "
                   "quadratics over %.3g "
                   "of true strain",
                   analysis->window)
        ->flag = flag;
    properties_add(list, "considere_stress", "sigma_u", considere->stress / mega, "MPa",
                   considere->stress * considere->error / mega, "true stress there")
        ->flag = flag;
    properties_add(list, "true_strain_at_maximum_force", "ln(1+Agt)", total, "1", NAN,
                   "to be compared with eps_u")
        ->flag = analysis->measures.maximum.reached ? NULL : "lower_bound";
}

struct properties analysis_report(const struct curve *curve, const struct analysis *analysis,
                                  const struct choices *choices, bool fits)
{
    struct properties list = {0};
    add_elastic(&list, analysis);
    add_proofs(&list, analysis);
    add_proof_by_loop(&list, curve, analysis);
    add_yield_point(&list, analysis, choices);
    add_strength(&list, analysis);
    add_extensions(&list, curve, analysis, choices);
    add_neck(&list, analysis);
    add_energies(&list, analysis);
    add_hardening(&list, analysis);
    if (fits) report_fits(&list, analysis);
    report_phases(&list, analysis);
    report_quality(&list, curve, analysis);
    report_record(&list, curve, analysis);
    return list;
}
