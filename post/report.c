#include "analysis.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

static const double giga = 1e9, mega = 1e6, percent = 100;

static const double quasi_static_limit = 0.01; /* kinetic over internal energy */
static const double balance_limit = 0.01;      /* difference of the grip forces over the largest */
static const double residual_limit = 1e-3;     /* free forces over reactions at rest */

/* Largest size of a column between two rows. */
static double largest(const double *values, long first, long last)
{
    double most = NAN;
    for (long i = first; values && i <= last; i++) most = fmax(most, fabs(values[i]));
    return most;
}

static void add_elastic(struct properties *list, const struct curve *curve,
                        const struct elastic_line *line)
{
    char *how = line->count > 0 ? memory_print("least squares over rows %ld to %ld",
                                               line->first + 1, line->last + 1)
                                : memory_text("not fitted to this curve");
    properties_add(list, "modulus", "m_E", line->slope / giga, "GPa", line->error / giga,
                   "slope of engineering stress on strain, %s", how)
        ->flag = line->flag;
    free(how);
    properties_add(list, "modulus_r_squared", "R2", line->r_squared, "1", NAN,
                   "coefficient of determination of the slope, %ld points", line->count);
    properties_add(
        list, "toe", "e0", line->toe, "1", NAN,
        "strain where the straight part meets zero stress; subtracted from all extensions");
    if (!isnan(curve->youngs_modulus) && line->count > 0)
        properties_add(list, "modulus_deviation", "m_E/E-1",
                       percent * (line->slope / curve->youngs_modulus - 1), "%", NAN,
                       "slope against the Young's modulus given to the solver, %g GPa",
                       curve->youngs_modulus / giga);
}

static void add_proof(struct properties *list, const struct curve *curve,
                      const struct elastic_line *line, const char *offset)
{
    char *name = memory_print("proof_strength_%s", offset), *symbol = memory_print("Rp%s", offset);
    double stress = strength_proof(curve, line, atof(offset) / percent);
    struct property *row = properties_add(
        list, name, symbol, stress / mega, "MPa", NAN,
        "stress at the first crossing of s = m_E (e - e0 - %s %%), linear between points", offset);
    if (isnan(stress)) row->flag = isnan(line->slope) ? "no_elastic_part" : "not_reached";
    free(name);
    free(symbol);
}

static void add_strengths(struct properties *list, const struct curve *curve,
                          const struct analysis *analysis, const struct choices *choices)
{
    static const char *const offsets[] = {"0.01", "0.1", "0.2", "1.0"};
    for (int k = 0; k < 4; k++) add_proof(list, curve, &analysis->line, offsets[k]);

    struct yield_point yield = strength_yield_point(curve, choices->yield_drop);
    const double *kinetic = table_find(&curve->table, "kinetic_to_internal");
    const char *flag = yield.row < 0                             ? "no_yield_point"
                       : kinetic[yield.row] > quasi_static_limit ? "not_quasi_static"
                                                                 : NULL;
    properties_add(list, "upper_yield_strength", "ReH", yield.upper / mega, "MPa", NAN,
                   "first maximum followed by a fall of more than %g %% of it and a new rise",
                   percent * choices->yield_drop)
        ->flag = flag;
    properties_add(list, "lower_yield_strength", "ReL", yield.lower / mega, "MPa", NAN,
                   "lowest stress between the upper yield point and the rise above it")
        ->flag = flag;
    properties_add(list, "tensile_strength", "Rm", analysis->maximum.stress / mega, "MPa", NAN,
                   "largest force over the initial section")
        ->flag = analysis->maximum.reached ? NULL : "not_reached";
    properties_add(list, "tensile_strength_reached", "", analysis->maximum.reached ? 1 : 0, "1",
                   NAN, "1 where the maximum lies inside the curve, 0 where it is its last point");
}

static void add_extensions(struct properties *list, const struct curve *curve,
                           const struct analysis *analysis, const struct choices *choices)
{
    const struct elastic_line *line = &analysis->line;
    const struct strength_maximum *maximum = &analysis->maximum;
    const char *open = maximum->reached ? NULL : "lower_bound";
    double toe = isnan(line->toe) ? 0 : line->toe, total = maximum->strain - toe;
    properties_add(list, "extension_at_maximum_force", "Agt", percent * total, "%", NAN,
                   "total extension at maximum force, e - e0; middle of the plateau")
        ->flag = open;
    properties_add(list, "plastic_extension_at_maximum_force", "Ag",
                   percent * (total - maximum->stress / line->slope), "%", NAN, "Agt - Rm/m_E")
        ->flag = open;
    properties_add(list, "plateau_width", "", percent * maximum->plateau, "%", NAN,
                   "extension over which the stress stays within %g Rm of Rm",
                   strength_plateau_share);
    double strain = curve->strain[analysis->fracture] - toe;
    double stress = curve->stress[analysis->fracture];
    const char *end = analysis->broken ? NULL : "curve_ends";
    properties_add(list, "extension_at_fracture", "At", percent * strain, "%", NAN,
                   "e - e0 at the last point before the force falls below %g %% of its maximum, "
                   "else at the last point",
                   percent * choices->fracture_share)
        ->flag = end;
    properties_add(list, "plastic_extension_at_fracture", "A",
                   percent * (strain - stress / line->slope), "%", NAN,
                   "At - s/m_E at the fracture point, on the gauge length L0")
        ->flag = end;
    properties_add(list, "gauge_length", "L0", curve->gauge_length, "m", NAN,
                   "initial distance of the gauge planes");
    properties_add(list, "section", "S0", curve->section, "m2", NAN, "initial section");
    properties_add(list, "proportionality", "k", curve->gauge_length / sqrt(curve->section), "1",
                   NAN, "L0/sqrt(S0); 5.65 is the proportional test piece");
}

static void add_neck(struct properties *list, const struct curve *curve,
                     const struct analysis *analysis)
{
    const double *ratio = table_find(&curve->table, "minimum_section_ratio");
    const double *place = table_find(&curve->table, "minimum_section_x_m");
    long row = analysis->fracture;
    if (ratio)
        properties_add(list, "reduction_of_area", "Z", percent * (1 - ratio[row]), "%", NAN,
                       "1 - smallest section/initial section at the fracture point; section from "
                       "the mean lateral stretch of a layer of nodes")
            ->flag = analysis->broken ? NULL : "curve_ends";
    if (ratio && curve->strain[row] > 0)
        properties_add(list, "localisation", "", -log(ratio[row]) / log1p(curve->strain[row]), "1",
                       NAN, "logarithmic strain of the smallest section over that of the gauge");
    if (place)
        properties_add(list, "neck_position", "x_neck", place[row], "m", NAN,
                       "where the section is smallest at the fracture point");
}

static void add_energies(struct properties *list, const struct curve *curve,
                         const struct analysis *analysis)
{
    const struct elastic_line *line = &analysis->line;
    double proof = strength_proof(curve, line, 0.002);
    properties_add(list, "toughness", "U_T",
                   strength_energy(curve, line, analysis->fracture) / mega, "MJ/m3", NAN,
                   "area under the engineering curve from the toe to the fracture point")
        ->flag = analysis->broken ? NULL : "curve_ends";
    properties_add(list, "energy_to_maximum_force", "U_m",
                   strength_energy(curve, line, analysis->maximum.row) / mega, "MJ/m3", NAN,
                   "area under the engineering curve from the toe to the maximum force");
    properties_add(list, "resilience", "U_r", proof * proof / (2 * line->slope) / mega, "MJ/m3",
                   NAN, "Rp0.2^2/(2 m_E)");
}

static void add_hardening(struct properties *list, const struct analysis *analysis)
{
    const struct power_law *law = &analysis->power_law;
    char *range = analysis->cut_at_maximum
                      ? memory_print("%g-Ag", percent * law->low)
                      : memory_print("%g-%g", percent * law->low, percent * law->high);
    char *symbol = memory_print("n%s", range);
    const char *flag = isnan(law->exponent) ? "too_few_points" : NULL;
    properties_add(list, "hardening_exponent", symbol, law->exponent, "1", law->error,
                   "regression of ln(true stress) on ln(true plastic strain), engineering plastic "
                   "strain %g to %g %%, %ld points, R2 %.5f",
                   percent * law->low, percent * law->high, law->count, law->r_squared)
        ->flag = flag;
    properties_add(list, "hardening_strength", "K", law->strength / mega, "MPa",
                   law->strength_error / mega, "true stress = K (true plastic strain)^n, as above")
        ->flag = flag;
    free(symbol);
    free(range);

    const struct considere *considere = &analysis->considere;
    double toe = isnan(analysis->line.toe) ? 0 : analysis->line.toe;
    double total = log1p(analysis->maximum.strain - toe);
    flag = isnan(considere->strain) ? "not_reached" : NULL;
    properties_add(list, "considere_strain", "eps_u", considere->strain, "1", NAN,
                   "true strain where d sigma/d eps first falls to sigma; local quadratic slope")
        ->flag = flag;
    properties_add(list, "considere_stress", "sigma_u", considere->stress / mega, "MPa", NAN,
                   "true stress there")
        ->flag = flag;
    properties_add(list, "true_strain_at_maximum_force", "ln(1+Agt)", total, "1", NAN,
                   "to be compared with eps_u")
        ->flag = analysis->maximum.reached ? NULL : "lower_bound";
}

/* The data do not fix a parameter that is smaller than its standard error, or a shape that has left
 * the range where such laws are found. */
static bool ill_determined(const struct law_fit *fit)
{
    const struct hardening_law *law = fit->hardening.law;
    const double *value = fit->hardening.parameter, *shape = value + law->n_linear;
    for (int k = 0; k < law->n_linear + law->n_shapes; k++)
        if (fit->error[k] > fabs(value[k])) return true;
    for (int k = 0; k < law->n_shapes; k++)
        if (shape[k] < law->range[k].low || shape[k] > law->range[k].high) return true;
    return false;
}

static const char *flag_of(const struct law_fit *fit)
{
    if (!fit->done) return "too_few_points";
    if (!fit->converged) return "not_converged";
    return ill_determined(fit) ? "ill_determined" : NULL;
}

static void add_fit(struct properties *list, const struct law_fit *fit)
{
    const struct hardening_law *law = fit->hardening.law;
    const char *of = law->variant.name, *flag = flag_of(fit);
    for (int k = 0; k < law->n_linear + law->n_shapes; k++) {
        bool stress = k < law->n_linear;
        double scale = stress ? mega : 1;
        char *name = memory_print("%s_%s", of, law->parameters[k].name);
        properties_add(list, name, law->parameters[k].symbol, fit->hardening.parameter[k] / scale,
                       stress ? "MPa" : "1", fit->error[k] / scale,
                       "sigma = %s, true plastic strain %.4g to %.4g, %ld points",
                       law->variant.help, fit->first, fit->last, fit->count)
            ->flag = flag;
        free(name);
    }
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

static void add_fits(struct properties *list, const struct curve *curve,
                     const struct analysis *analysis)
{
    const struct hardening_law *law;
    for (int i = 0; (law = hardening_law(i)); i++) {
        if (law->n_linear == 0) continue;
        struct law_fit fit = true_curve_fit(curve, law, analysis->maximum.row, analysis->fit_range);
        add_fit(list, &fit);
    }
}

static void add_phase(struct properties *list, const struct curve *curve, int k,
                      const struct partition *state)
{
    const struct curve_phase *phase = &curve->phases[k];
    bool hard = k == state->hard;
    const struct {
        const char *quantity, *symbol, *unit, *definition;
        double value;
    } rows[] = {
        {"stress", "sigma", "MPa", "mean axial Cauchy stress at maximum force",
         (hard ? state->hard_stress : state->soft_stress) / mega},
        {"strain", "e", "1", "mean axial nominal strain at maximum force",
         hard ? state->hard_strain : state->soft_strain},
        {"fraction", "f", "1", "volume fraction in the gauge", phase->fraction},
    };
    for (int i = 0; i < 3; i++) {
        char *name = memory_print("%s_%s", phase->name, rows[i].quantity);
        char *symbol = memory_print("%s_%s", rows[i].symbol, phase->name);
        properties_add(list, name, symbol, rows[i].value, rows[i].unit, NAN, "%s",
                       rows[i].definition);
        free(name);
        free(symbol);
    }
}

static void add_phases(struct properties *list, const struct curve *curve,
                       const struct analysis *analysis)
{
    struct partition state = phases_at(curve, analysis->maximum.row);
    if (state.hard < 0) return;
    for (int k = 0; k < 2; k++) add_phase(list, curve, k, &state);
    properties_add(
        list, "partition_factor", "q", state.factor / giga, "GPa", NAN,
        "(sigma_%s - sigma_%s)/(e_%s - e_%s) at maximum force; 0 is equal stress (Reuss), "
        "infinite is equal strain (Voigt)",
        curve->phases[state.hard].name, curve->phases[state.soft].name,
        curve->phases[state.soft].name, curve->phases[state.hard].name);
    properties_add(list, "mixture_share", "", state.mixture, "1", NAN,
                   "sum of fraction times mean nominal stress over the engineering stress");
}

static void add_quality(struct properties *list, const struct curve *curve,
                        const struct analysis *analysis)
{
    if (curve->measured) return;
    long first = 0;
    while (curve->stress[first] < analysis->maximum.stress / 2) first++;
    double imbalance = curve_force_imbalance(curve);
    const double *unsteady = table_find(&curve->table, "unsteady_to_internal");
    double kinetic =
        largest(table_find(&curve->table, "kinetic_to_internal"), first, analysis->fracture);
    double drift = largest(table_find(&curve->table, "energy_drift"), 0, curve->n - 1);
    properties_add(list, "force_imbalance", "r_F", imbalance, "1", NAN,
                   "largest |F_right + F_left| over the largest |F|; above 0.01 the grips disagree")
        ->flag = imbalance > balance_limit ? "not_balanced" : NULL;
    properties_add(
        list, "kinetic_to_internal", "KE/IE", kinetic, "1", NAN,
        "largest ratio of the energies from half of Rm to the fracture point; the uniform "
        "stretching is part of it")
        ->flag = !unsteady && kinetic > quasi_static_limit ? "not_quasi_static" : NULL;
    if (unsteady) {
        double beyond = largest(unsteady, first, analysis->maximum.row);
        properties_add(list, "unsteady_to_internal", "KE'/IE", beyond, "1", NAN,
                       "kinetic energy beyond the uniform stretching over internal energy, largest "
                       "from half of Rm to Rm; above 0.01 the test is not quasi-static")
            ->flag = beyond > quasi_static_limit ? "not_quasi_static" : NULL;
    }
    const double rest = largest(table_find(&curve->table, "residual"), 0, curve->n - 1);
    if (rest > 0)
        properties_add(list, "residual", "r", rest, "1", NAN,
                       "largest residual of a load step: forces out of balance over the reactions; "
                       "above 0.001 the test is not in equilibrium")
            ->flag = rest > residual_limit ? "not_in_equilibrium" : NULL;
    properties_add(list, "energy_drift", "", drift, "1", NAN,
                   "largest drift of the energy balance");
}

struct properties analysis_report(const struct curve *curve, const struct analysis *analysis,
                                  const struct choices *choices)
{
    struct properties list = {0};
    add_elastic(&list, curve, &analysis->line);
    add_strengths(&list, curve, analysis, choices);
    add_extensions(&list, curve, analysis, choices);
    add_neck(&list, curve, analysis);
    add_energies(&list, curve, analysis);
    add_hardening(&list, analysis);
    add_fits(&list, curve, analysis);
    add_phases(&list, curve, analysis);
    add_quality(&list, curve, analysis);
    return list;
}
