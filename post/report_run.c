#include "memory.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>

static const double giga = 1e9, mega = 1e6;

const double report_quasi_static_limit = 0.01; /* kinetic over internal energy */
static const double balance_limit = 0.01;      /* difference of the grip forces over the largest */
static const double residual_limit = 1e-3;     /* free forces over reactions at rest */

/* Largest size of a column between two rows. */
static double largest(const double *values, long first, long last)
{
    double most = NAN;
    for (long i = first; values && i <= last; i++) most = fmax(most, fabs(values[i]));
    return most;
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

void report_phases(struct properties *list, const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    struct partition state = phases_at(curve, analysis->measures.maximum.row);
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

void report_quality(struct properties *list, const struct curve *whole,
                    const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    if (curve->measured) return;
    long first = 0;
    while (curve->stress[first] < analysis->measures.maximum.stress / 2) first++;
    double imbalance = curve_force_imbalance(whole, analysis->rows[analysis->measures.fracture]);
    const double *unsteady = table_find(&curve->table, "unsteady_to_internal");
    double kinetic = largest(table_find(&curve->table, "kinetic_to_internal"), first,
                             analysis->measures.fracture);
    double drift = largest(table_find(&whole->table, "energy_drift"), 0, whole->n - 1);
    properties_add(list, "force_imbalance", "r_F", imbalance, "1", NAN,
                   "largest |F_right + F_left| up to the fracture over the largest |F|; above 0.01 "
                   "the grips disagree")
        ->flag = imbalance > balance_limit ? "not_balanced" : NULL;
    properties_add(
        list, "kinetic_to_internal", "KE/IE", kinetic, "1", NAN,
        "largest ratio of the energies from half of Rm to the fracture point; the uniform "
        "stretching is part of it")
        ->flag = !unsteady && kinetic > report_quasi_static_limit ? "not_quasi_static" : NULL;
    if (unsteady) {
        double beyond = largest(unsteady, first, analysis->measures.maximum.row);
        properties_add(list, "unsteady_to_internal", "KE'/IE", beyond, "1", NAN,
                       "kinetic energy beyond the uniform stretching over internal energy, largest "
                       "from half of Rm to Rm; above 0.01 the test is not quasi-static")
            ->flag = beyond > report_quasi_static_limit ? "not_quasi_static" : NULL;
    }
    const double rest = largest(table_find(&whole->table, "residual"), 0, whole->n - 1);
    if (rest > 0)
        properties_add(list, "residual", "r", rest, "1", NAN,
                       "largest residual of a load step: forces out of balance over the reactions; "
                       "above 0.001 the test is not in equilibrium")
            ->flag = rest > residual_limit ? "not_in_equilibrium" : NULL;
    properties_add(list, "energy_drift", "", drift, "1", NAN,
                   "largest drift of the energy balance");
}

static void add_count(struct properties *list, const char *name, long count, const char *definition)
{
    properties_add(list, name, "", (double)count, "1", NAN, "%s", definition);
}

void report_record(struct properties *list, const struct curve *curve,
                   const struct analysis *analysis)
{
    if (!curve->measured) return;
    const struct record *record = &analysis->record;
    properties_add(
        list, "noise", "", analysis->noise.deviation / mega, "MPa", NAN,
        "standard deviation of the stress, by its second and fourth differences from row to row, "
        "or about the elastic line where a filter hides it from them");
    properties_add(list, "noise_correlation", "", analysis->noise.correlation, "1", NAN,
                   "of the noise of a row with that of the next one");
    properties_add(list, "strain_noise", "", analysis->strain_noise, "1", NAN,
                   "that of the strain, where it goes back and forth");
    add_count(list, "loops", record_count(record, EXCURSION_LOOP),
              "unloadings with reloading, left out");
    add_count(list, "holds", record_count(record, EXCURSION_HOLD),
              "relaxations at standing strain, left out");
    add_count(list, "serrations", record_count(record, EXCURSION_SERRATION),
              "falls of stress regained elastically while the strain goes on, left out");
    add_count(list, "spikes", record->spikes,
              "one to three rows in which stress or strain leaps as no body's can and comes back, "
              "left out");
}
