#include "curve.h"

#include "csv.h"
#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The order is part of the file format (docs/formats.md). */
static const char *const fixed_columns[] = {
    "time_s",        "force_left_N",        "force_right_N",
    "extension_m",   "engineering_strain",  "engineering_stress_Pa",
    "true_strain",   "true_stress_Pa",      "plastic_strain",
    "force_balance", "kinetic_to_internal", "energy_drift",
    "theta_Pa",
};
enum { FIXED_COLUMNS = sizeof fixed_columns / sizeof *fixed_columns };

struct curve curve_new(long n, const char *title)
{
    struct curve curve = {.n = n,
                          .title = memory_text(title),
                          .table = {.n_rows = n},
                          .section = NAN,
                          .gauge_length = NAN,
                          .youngs_modulus = NAN};
    for (int i = 0; i < FIXED_COLUMNS; i++) table_add(&curve.table, fixed_columns[i]);
    curve.strain = table_find(&curve.table, "engineering_strain");
    curve.stress = table_find(&curve.table, "engineering_stress_Pa");
    curve.true_strain = table_find(&curve.table, "true_strain");
    curve.true_stress = table_find(&curve.table, "true_stress_Pa");
    curve.plastic_strain = table_find(&curve.table, "plastic_strain");
    curve.hardening_rate = table_find(&curve.table, "theta_Pa");
    return curve;
}

static const double *demand(const struct input *input, const char *column)
{
    const double *values = table_find(&input->table, column);
    if (!values)
        die_user("%s: the history has no column %s, which a tension test has; --columns prints "
                 "what there is",
                 input->name, column);
    for (long i = 0; i < input->table.n_rows; i++)
        if (isnan(values[i]))
            die_user("%s: %s of record %ld is not a finite number: did the run fail?", input->name,
                     column, i + 1);
    return values;
}

static void copy_column(struct curve *curve, const struct input *input, const char *name)
{
    const double *from = table_find(&input->table, name);
    if (!from) return;
    double *to = table_find(&curve->table, name);
    if (!to) to = table_add(&curve->table, name);
    memcpy(to, from, (size_t)curve->n * sizeof *to);
}

/* A size from the choices, else from the file; it must be positive. */
static double size_of(const struct input *input, const char *attribute, double chosen)
{
    double value = isnan(chosen) ? attributes_number(&input->attributes, attribute, NAN) : chosen;
    if (!isnan(value) && !(value > 0 && isfinite(value)))
        die_user("%s: %s = %g, expected a positive number", input->name, attribute, value);
    return value;
}

static void balance_forces(struct curve *curve)
{
    const double *left = table_find(&curve->table, "force_left_N");
    const double *right = table_find(&curve->table, "force_right_N");
    double *balance = table_find(&curve->table, "force_balance");
    double largest = 0;
    for (long i = 0; i < curve->n; i++) {
        double force = fabs(right[i] - left[i]) / 2;
        if (force > largest) largest = force;
    }
    if (!(largest > 0)) return;
    for (long i = 0; i < curve->n; i++) balance[i] = fabs(right[i] + left[i]) / largest;
}

static void reduce_history(struct curve *curve, const struct input *input)
{
    const double *left = demand(input, "force_left_N"), *right = demand(input, "force_right_N");
    const double *extension = demand(input, "extension_m");
    if (isnan(curve->section))
        die_user("%s: the history does not say the section; give --section", input->name);
    if (isnan(curve->gauge_length))
        die_user("%s: the history does not say the gauge length; give --gauge-length", input->name);
    for (long i = 0; i < curve->n; i++) {
        curve->strain[i] = extension[i] / curve->gauge_length;
        curve->stress[i] = (right[i] - left[i]) / 2 / curve->section;
    }
}

/* values over size, where the table has no such column; what says how the size is given. */
static double *ratio(struct input *input, const char *column, const char *from, double size,
                     const char *what)
{
    double *values = table_find(&input->table, from);
    if (!values) return NULL;
    if (isnan(size))
        die_user("%s: a table of force and extension does not say the %s (for the column %s)",
                 input->name, what, column);
    double *made = table_add(&input->table, column);
    for (long i = 0; i < input->table.n_rows; i++) made[i] = values[i] / size;
    return made;
}

/* s = sigma / (1 + e), e = exp(eps) - 1: exact up to the maximum force. */
static void take_true(struct input *input, double **strain, double **stress)
{
    const double *eps = table_find(&input->table, "true_strain");
    const double *sigma = table_find(&input->table, "true_stress_Pa");
    if (*strain || *stress || !eps || !sigma) return;
    *strain = table_add(&input->table, "engineering_strain");
    *stress = table_add(&input->table, "engineering_stress_Pa");
    for (long i = 0; i < input->table.n_rows; i++) {
        (*strain)[i] = expm1(eps[i]);
        (*stress)[i] = sigma[i] / exp(eps[i]);
    }
}

static void take_measured(struct curve *curve, struct input *input)
{
    double *strain = table_find(&input->table, "engineering_strain");
    double *stress = table_find(&input->table, "engineering_stress_Pa");
    take_true(input, &strain, &stress);
    if (!strain)
        strain = ratio(input, "engineering_strain", "extension_m", curve->gauge_length,
                       "gauge length; give --gauge-length, as in '50 mm'");
    if (!stress)
        stress = ratio(input, "engineering_stress_Pa", "force_N", curve->section,
                       "section; give --section, as in '20 mm2'");
    if (!strain || !stress)
        die_user("%s: no column of %s", input->name,
                 strain ? "stress or force" : "strain or extension");
    for (long i = 0; i < curve->n; i++) {
        if (isnan(strain[i]) || isnan(stress[i]))
            die_user("%s: row %ld of numbers has no strain or no stress", input->name, i + 1);
        curve->strain[i] = strain[i];
        curve->stress[i] = stress[i];
    }
}

/* Where the columns of a phase are; of those that are not there NULL. */
static void link_phase(struct curve *curve, struct curve_phase *phase)
{
    static const char *const endings[] = {"stress_Pa", "true_stress_Pa", "strain"};
    const double **places[] = {&phase->stress, &phase->true_stress, &phase->strain};
    for (int k = 0; k < 3; k++) {
        char *name = memory_print("%s_%s", phase->name, endings[k]);
        *places[k] = table_find(&curve->table, name);
        free(name);
    }
}

/* A phase is whatever stands before "_true_stress_Pa" in a column's name. */
static void find_phases(struct curve *curve, const struct input *input)
{
    static const char ending[] = "_true_stress_Pa";
    for (int j = 0; j < input->table.n_columns && curve->n_phases < CURVE_PHASES; j++) {
        const char *column = input->table.columns[j].name;
        size_t length = strlen(column), tail = strlen(ending);
        if (length <= tail || strcmp(column + length - tail, ending) != 0) continue;
        struct curve_phase *phase = &curve->phases[curve->n_phases++];
        phase->name = memory_print("%.*s", (int)(length - tail), column);
        char *names[] = {memory_print("%s_stress_Pa", phase->name), memory_text(column),
                         memory_print("%s_strain", phase->name),
                         memory_print("%s_plastic_strain", phase->name),
                         memory_print("phase_%s_fraction", phase->name)};
        for (int k = 0; k < 4; k++) copy_column(curve, input, names[k]);
        phase->fraction = attributes_number(&input->attributes, names[4], NAN);
        link_phase(curve, phase);
        for (int k = 0; k < 5; k++) free(names[k]);
    }
}

/* HS40.e and runs/HS40.csv are both called HS40. */
static char *title_of(const struct input *input, const struct choices *choices)
{
    if (choices->title) return memory_text(choices->title);
    const char *title = attributes_text(&input->attributes, "title");
    if (title) return memory_text(title);
    const char *slash = strrchr(input->name, '/'), *base = slash ? slash + 1 : input->name;
    const char *dot = strrchr(base, '.');
    return memory_print("%.*s", (int)(dot && dot > base ? dot - base : (long)strlen(base)), base);
}

/* The file's facts travel on, but the deck and the program that wrote this table of ours. */
static void keep_facts(struct curve *curve, const struct input *input)
{
    struct attributes *to = &curve->provenance;
    attributes_set_text(to, "title", curve->title);
    attributes_set_text(to, "input", input->name);
    char *checksum = memory_print("%u %ld", input->checksum, input->bytes);
    attributes_set_text(to, "input_cksum", checksum);
    free(checksum);
    for (int i = 0; i < input->attributes.count; i++) {
        const struct attribute *fact = &input->attributes.items[i];
        bool maker = strcmp(fact->name, "program") == 0 || strcmp(fact->name, "command") == 0;
        if ((maker && !input->is_history) || (fact->text && strchr(fact->text, '\n'))) continue;
        if (attributes_text(to, fact->name)) continue;
        char *name = memory_print("%s%s", maker ? "generator_" : "", fact->name);
        if (fact->text)
            attributes_set_text(to, name, fact->text);
        else
            attributes_set_number(to, name, fact->number);
        free(name);
    }
    if (!isnan(curve->section)) attributes_set_number(to, "section_m2", curve->section);
    if (!isnan(curve->gauge_length))
        attributes_set_number(to, "gauge_length_m", curve->gauge_length);
}

struct curve curve_make(struct input *input, const struct choices *choices)
{
    static const char *const recorded[] = {"time_s",
                                           "force_left_N",
                                           "force_right_N",
                                           "extension_m",
                                           "kinetic_to_internal",
                                           "energy_drift",
                                           "unsteady_to_internal",
                                           "residual",
                                           "transverse_strain",
                                           "minimum_section_ratio",
                                           "minimum_section_x_m"};
    char *title = title_of(input, choices);
    struct curve curve = curve_new(input->table.n_rows, title);
    free(title);
    curve.section = size_of(input, "section_m2", choices->section);
    curve.gauge_length = size_of(input, "gauge_length_m", choices->gauge_length);
    curve.youngs_modulus = size_of(input, "youngs_modulus_Pa", NAN);
    if (input->is_history)
        reduce_history(&curve, input);
    else
        take_measured(&curve, input);
    for (size_t i = 0; i < sizeof recorded / sizeof *recorded; i++)
        copy_column(&curve, input, recorded[i]);
    balance_forces(&curve);
    find_phases(&curve, input);
    curve.measured = isnan(curve_force_imbalance(&curve, curve.n - 1)) && !input->is_history &&
                     !attributes_text(&input->attributes, "mixture");
    keep_facts(&curve, input);
    return curve;
}

double curve_force_imbalance(const struct curve *curve, long last)
{
    const double *balance = table_find(&curve->table, "force_balance");
    double largest = NAN;
    for (long i = 0; i <= last; i++) largest = fmax(largest, balance[i]);
    return largest;
}

void curve_write(FILE *file, const struct curve *curve)
{
    for (int i = 0; i < curve->provenance.count; i++) {
        const struct attribute *fact = &curve->provenance.items[i];
        fprintf(file, "# %s: ", fact->name);
        if (fact->text)
            for (const char *c = fact->text; *c; c++)
                fputc(*c == '\n' || *c == '\r' ? ' ' : *c, file);
        else
            csv_number(file, fact->number);
        fputc('\n', file);
    }
    csv_write(file, &curve->table);
}

struct curve curve_rows(const struct curve *curve, long n, const long rows[])
{
    struct curve part = curve_new(n, curve->title);
    for (int j = 0; j < curve->table.n_columns; j++) {
        const struct column *from = &curve->table.columns[j];
        double *to = table_find(&part.table, from->name);
        if (!to) to = table_add(&part.table, from->name);
        for (long i = 0; i < n; i++) to[i] = from->values[rows[i]];
    }
    part.measured = curve->measured;
    part.strain_is_noisier = curve->strain_is_noisier;
    part.section = curve->section;
    part.gauge_length = curve->gauge_length;
    part.youngs_modulus = curve->youngs_modulus;
    for (int i = 0; i < curve->provenance.count; i++) {
        const struct attribute *fact = &curve->provenance.items[i];
        if (fact->text)
            attributes_set_text(&part.provenance, fact->name, fact->text);
        else
            attributes_set_number(&part.provenance, fact->name, fact->number);
    }
    for (part.n_phases = 0; part.n_phases < curve->n_phases; part.n_phases++) {
        struct curve_phase *phase = &part.phases[part.n_phases];
        phase->name = memory_text(curve->phases[part.n_phases].name);
        phase->fraction = curve->phases[part.n_phases].fraction;
        link_phase(&part, phase);
    }
    return part;
}

void curve_free(struct curve *curve)
{
    free(curve->title);
    for (int i = 0; i < curve->n_phases; i++) free(curve->phases[i].name);
    table_free(&curve->table);
    attributes_free(&curve->provenance);
    *curve = (struct curve){0};
}
