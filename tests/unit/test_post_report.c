/* The report of a history whose every number is known: each property against its own formula, and
 * errors of fits against changes of unit. */
#include "check.h"
#include "sections.h"

#include "analysis.h"
#include "memory.h"
#include "property.h"

#include <stdlib.h>
#include <string.h>

/* E (e - e0) up to the yield stress, a straight rise to the strength, a straight fall to a fifth of
 * it, the rest. */
enum { ROWS = 4001, PEAK = 2000, LAST_BEARING = 3999 };
static const double young = 200e9, toe = 1e-3, yield = 200e6, rise = 20e9, section = 2e-6,
                    gauge = 5e-3;

static double strain_of(long row)
{
    return 1e-5 * (double)row;
}

static double stress_of(long row)
{
    const double e = strain_of(row) - toe, at_yield = yield / young;
    const double strength = yield + rise * (strain_of(PEAK) - toe - at_yield);
    if (row == ROWS - 1) return 0.01 * strength;
    if (row > PEAK) return strength * (1 - 0.8 * (double)(row - PEAK) / (LAST_BEARING - PEAK));
    return e < 0 ? 0 : e < at_yield ? young * e : yield + rise * (e - at_yield);
}

/* kinetic: over internal energy, from half of the strength on; ten times as much before. */
static struct input history(double kinetic)
{
    struct input input = {.name = memory_text("made"), .is_history = true};
    static const char *const names[] = {"time_s",
                                        "force_left_N",
                                        "force_right_N",
                                        "extension_m",
                                        "kinetic_to_internal",
                                        "energy_drift",
                                        "minimum_section_ratio",
                                        "CG_stress_Pa",
                                        "CG_true_stress_Pa",
                                        "CG_strain",
                                        "UFG_stress_Pa",
                                        "UFG_true_stress_Pa",
                                        "UFG_strain"};
    enum { COLUMNS = sizeof names / sizeof *names };
    double *column[COLUMNS];
    input.table.n_rows = ROWS;
    for (int k = 0; k < COLUMNS; k++) column[k] = table_add(&input.table, names[k]);
    for (long i = 0; i < ROWS; i++) {
        const double s = stress_of(i), e = strain_of(i);
        const double values[COLUMNS] = {1e-6 * (double)i,
                                        -s * section,
                                        s * section,
                                        e * gauge,
                                        s < stress_of(PEAK) / 2 && i < PEAK ? 10 * kinetic
                                                                            : kinetic,
                                        1e-5,
                                        exp(-3 * e),
                                        0.5 * s,
                                        0.5 * s * (1 + e),
                                        1.2 * e,
                                        1.7 * s,
                                        1.7 * s * (1 + e),
                                        0.7 * e};
        for (int k = 0; k < COLUMNS; k++) column[k][i] = values[k];
    }
    attributes_set_number(&input.attributes, "section_m2", section);
    attributes_set_number(&input.attributes, "gauge_length_m", gauge);
    attributes_set_number(&input.attributes, "phase_CG_fraction", 0.7);
    attributes_set_number(&input.attributes, "phase_UFG_fraction", 0.3);
    return input;
}

struct made {
    struct input input;
    struct choices choices;
    struct curve curve;
    struct analysis analysis;
    struct properties list;
};

static struct made report_of(double kinetic)
{
    struct made made = {.input = history(kinetic), .choices = choices_read(NULL)};
    made.curve = curve_make(&made.input, &made.choices);
    made.analysis = analysis_make(&made.curve, &made.choices, true);
    made.list = analysis_report(&made.curve, &made.analysis, &made.choices, true);
    return made;
}

static void made_free(struct made *made)
{
    properties_free(&made->list);
    analysis_free(&made->analysis);
    curve_free(&made->curve);
    input_free(&made->input);
}

/* Rows of a straight line give it back to round-off, which grows by the distance of the rows from
 * the toe. */
static const double exact = 1e-10;

static void elastic_line(void **state)
{
    (void)state;
    struct made made = report_of(1e-3);
    /* s = E (e - e0 - 0.2 %) on the rise. */
    const double proof = yield + 0.002 / (1 / rise - 1 / young);
    long first = 0, last = 0;
    while (stress_of(first) < 0.1 * proof) first++;
    while (stress_of(last + 1) <= 0.4 * proof) last++;
    assert_int_equal(made.analysis.measures.line.first, first);
    assert_int_equal(made.analysis.measures.line.last, last);
    assert_relative(made.analysis.measures.line.slope, young, exact);
    assert_relative(made.analysis.measures.line.toe, toe, exact);
    assert_relative(1e6 * property_value(&made.list, "proof_strength_0.2"), proof, 1e-9);
    assert_relative(1e6 * property_value(&made.list, "resilience"), proof * proof / (2 * young),
                    1e-9);
    made_free(&made);
}

static void true_curve_starts_at_the_toe(void **state)
{
    (void)state;
    struct made made = report_of(1e-3);
    for (long i = 500; i <= PEAK; i += 500) {
        const double stretch = 1 + strain_of(i) - toe;
        assert_relative(made.curve.true_strain[i], log(stretch), 1e-9);
        assert_relative(made.curve.true_stress[i], stress_of(i) * stretch, 1e-12);
    }
    made_free(&made);
}

static void neck_and_sizes(void **state)
{
    (void)state;
    struct made made = report_of(1e-3);
    const double strain = strain_of(LAST_BEARING);
    const double *neck = table_find(&made.curve.table, "neck_stress_Pa");
    assert_non_null(neck);
    assert_relative(neck[LAST_BEARING], stress_of(LAST_BEARING) * exp(3 * strain), 1e-12);
    assert_relative(property_value(&made.list, "reduction_of_area"), 100 * (1 - exp(-3 * strain)),
                    1e-12);
    assert_relative(property_value(&made.list, "localisation"), 3 * strain / log1p(strain), 1e-12);
    assert_relative(property_value(&made.list, "proportionality"), gauge / sqrt(section), 1e-14);
    made_free(&made);
}

/* Means of the phases, 0.7 x 0.5 + 0.3 x 1.7 of the whole; q = (1.7 - 0.5) s (1 + e)/((1.2 - 0.7)
 * e). */
static void shares_of_the_phases(void **state)
{
    (void)state;
    struct made made = report_of(1e-3);
    const double e = strain_of(PEAK), s = stress_of(PEAK);
    assert_relative(property_value(&made.list, "mixture_share"), 0.86, 1e-12);
    assert_relative(1e9 * property_value(&made.list, "partition_factor"),
                    1.2 * s * (1 + e) / (0.5 * e), 1e-12);
    made_free(&made);
}

static void what_is_quasi_static(void **state)
{
    (void)state;
    /* Before half of the strength there is ten times as much, which does not count; the limit is
     * 0.01. */
    const struct {
        double kinetic;
        const char *flag;
    } cases[] = {{0.0099, NULL}, {0.0101, "not_quasi_static"}};
    for (int k = 0; k < 2; k++) {
        struct made made = report_of(cases[k].kinetic);
        const struct property *row = property_of(&made.list, "kinetic_to_internal");
        assert_relative(row->value, cases[k].kinetic, 1e-14);
        assert_true(cases[k].flag ? row->flag && strcmp(row->flag, cases[k].flag) == 0
                                  : row->flag == NULL);
        made_free(&made);
    }
}

/* Voce's law with a fixed scatter of 2 MPa; from 1e-3 to 0.12 of plastic strain in that unit. */
enum { POINTS = 80 };
static void scattered_points(double unit, double pascals, double p[POINTS], double stress[POINTS])
{
    for (int k = 0; k < POINTS; k++) {
        p[k] = unit * (1e-3 + 0.12 * k / POINTS);
        stress[k] = pascals * (200e6 + 300e6 * (1 - exp(-20 * p[k] / unit)) + 2e6 * sin(37.0 * k) +
                               (k == 50 ? 9e6 : 0));
    }
}

/* Errors have the units of what they are of.  Both fits end where their polish does, at 1e-5 of a
 * parameter. */
static void errors_of_fits_change_with_the_unit(void **state)
{
    (void)state;
    double p[POINTS], stress[POINTS];
    scattered_points(1, 1, p, stress);
    const struct law_fit one = law_fit(hardening_fitted("voce"), p, stress, POINTS);
    scattered_points(2, 3, p, stress);
    const struct law_fit other = law_fit(hardening_fitted("voce"), p, stress, POINTS);
    static const double factor[3] = {3, 3, 0.5}; /* yield, saturation, rate */
    for (int k = 0; k < 3; k++) {
        assert_relative(other.hardening.parameter[k], factor[k] * one.hardening.parameter[k], 1e-4);
        assert_true(one.error[k] > 1e-3 * one.hardening.parameter[k]);
        assert_relative(other.error[k], factor[k] * one.error[k], 1e-3);
    }
}

static void measures_of_a_fit(void **state)
{
    (void)state;
    double p[POINTS], stress[POINTS], squares = 0, most = 0, below = 0;
    scattered_points(1, 1, p, stress);
    const struct law_fit fit = law_fit(hardening_fitted("voce"), p, stress, POINTS);
    for (int k = 0; k < POINTS; k++) {
        const double off = hardening_stress(&fit.hardening, p[k]) - stress[k];
        squares += off * off;
        most = fmax(most, fabs(off));
        below = fmax(below, off);
    }
    assert_true(
        below <
        0.9 *
            most); /* the worst point lies above the fit, which is below it: a negative residual */
    assert_relative(fit.largest, most, 1e-12);
    assert_relative(fit.root_mean_square, sqrt(squares / POINTS), 1e-12);
    /* Three parameters and the variance (Burnham, Anderson, Model Selection (2002), section 2.4).
     */
    assert_relative(fit.akaike, POINTS * log(squares / POINTS / 1e12) + 2 * 4, 1e-12);
}

/* The stress of Hollomon's law with a scatter: what a yield stress would add is below its error,
 * and flagged. */
static void parameters_below_their_errors_are_flagged(void **state)
{
    (void)state;
    enum { N = 300 };
    struct curve curve = curve_new(N, "power");
    int below = 0;
    for (int i = 0; i < N; i++) {
        const double p = 0.25 * i * i / (double)(N * N),
                     tau = i ? 800e6 * pow(p, 0.27) * (1 + 2e-2 * sin(31.0 * i)) : 0,
                     stretch = exp(p + tau / young);
        curve.strain[i] = stretch - 1;
        curve.stress[i] = tau / stretch;
    }
    curve.youngs_modulus = young;
    struct choices choices = choices_read(NULL);
    struct analysis analysis = analysis_make(&curve, &choices, true);
    struct properties list = analysis_report(&curve, &analysis, &choices, true);
    for (int i = 0; i < list.count; i++) {
        const struct property *row = &list.items[i];
        if (strncmp(row->definition, "sigma = ", 8) != 0 || !(row->uncertainty > fabs(row->value)))
            continue;
        below++;
        assert_true(row->flag && strcmp(row->flag, "ill_determined") == 0);
    }
    assert_true(below > 0);
    properties_free(&list);
    analysis_free(&analysis);
    curve_free(&curve);
}

/* ln K has the error of the regression, whatever the unit of stress: K's is in that unit. */
static void error_of_the_power_law(void **state)
{
    (void)state;
    enum { N = 400 };
    double error[2], exponent[2];
    for (int k = 0; k < 2; k++) {
        struct curve curve = curve_new(N, "power");
        for (int i = 0; i < N; i++) {
            const double e = 0.2 * i / N, s = fmin(young * e, 500e6 * pow(e + 1e-9, 0.2));
            curve.strain[i] = e;
            curve.stress[i] = (k ? 5 : 1) * s * (1 + 1e-3 * sin(17.0 * i)) / (1 + e);
        }
        struct choices choices = choices_read(NULL);
        choices.modulus_rows[0] = 1;
        choices.modulus_rows[1] = 3;
        struct analysis analysis = analysis_make(&curve, &choices, true);
        error[k] = analysis.measures.power_law.strength_error;
        exponent[k] = analysis.measures.power_law.error;
        analysis_free(&analysis);
        curve_free(&curve);
    }
    assert_relative(error[1], 5 * error[0], 1e-6);
    assert_relative(exponent[1], exponent[0], 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastic_line),
        cmocka_unit_test(true_curve_starts_at_the_toe),
        cmocka_unit_test(neck_and_sizes),
        cmocka_unit_test(shares_of_the_phases),
        cmocka_unit_test(what_is_quasi_static),
        cmocka_unit_test(errors_of_fits_change_with_the_unit),
        cmocka_unit_test(measures_of_a_fit),
        cmocka_unit_test(parameters_below_their_errors_are_flagged),
        cmocka_unit_test(error_of_the_power_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
