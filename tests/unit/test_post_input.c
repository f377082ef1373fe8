/* From files to curves: histories and tables. */
#include "check.h"
#include "sections.h"
#include "taken.h"

#include "analysis.h"
#include "choices.h"
#include "csv.h"
#include "deck.h"
#include "dies.h"
#include "keys_options.h"
#include "memory.h"
#include "property.h"
#include "random.h"
#include "text_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[64];

static int choose_path(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/hs-test-post-%ld.e", (long)getpid());
    return 0;
}

static int remove_path(void **state)
{
    (void)state;
    unlink(path);
    return 0;
}

enum { RECORDS = 5, COLUMNS = 11, MOST_KEYS = 40 };

static const double section = 2e-6, length = 5e-3;

/* A gauge stretched by 0.001 a record under 100, 200, ... N, the left grip 1 N weaker. */
static struct history make_history(void)
{
    static const char *const names[COLUMNS] = {
        "force_left_N",       "force_right_N", "extension_m",          "kinetic_to_internal",
        "energy_drift",       "CG_stress_Pa",  "CG_true_stress_Pa",    "CG_strain",
        "UFG_true_stress_Pa", "UFG_strain",    "minimum_section_ratio"};
    struct history h = {.n_columns = COLUMNS, .n_records = RECORDS};
    h.columns = memory_new(COLUMNS, sizeof *h.columns);
    for (int j = 0; j < COLUMNS; j++) h.columns[j] = memory_text(names[j]);
    h.time = memory_new(RECORDS, sizeof *h.time);
    h.values = memory_new((size_t)RECORDS * COLUMNS, sizeof *h.values);
    for (int i = 0; i < RECORDS; i++) {
        const double record[COLUMNS] = {-100.0 * i + (i > 0),
                                        100.0 * i,
                                        length * 0.001 * i,
                                        0.002,
                                        -1e-5,
                                        40e6 * i,
                                        41e6 * i,
                                        0.0012 * i,
                                        80e6 * i,
                                        0.0008 * i,
                                        1 - 0.01 * i};
        h.time[i] = 1e-6 * i;
        memcpy(h.values + i * COLUMNS, record, sizeof record);
    }
    attributes_set_number(&h.attributes, "section_m2", section);
    attributes_set_number(&h.attributes, "gauge_length_m", length);
    attributes_set_number(&h.attributes, "youngs_modulus_Pa", 50e9);
    attributes_set_number(&h.attributes, "phase_CG_fraction", 0.6);
    attributes_set_number(&h.attributes, "phase_UFG_fraction", 0.4);
    attributes_set_text(&h.attributes, "program", "hsgen");
    return h;
}

static struct input write_and_read(struct history *history)
{
    taken_forget();
    struct spool output = spool_output(path);
    exodus_write_history(&output, history);
    spool_finish(&output);
    history_free(history);
    return input_read(path, NULL);
}

static void history_to_curve(void **state)
{
    (void)state;
    struct history history = make_history();
    struct input input = write_and_read(&history);
    assert_true(input.is_history);
    struct choices choices = choices_read(NULL);
    struct curve curve = curve_make(&input, &choices);
    assert_int_equal(curve.n, RECORDS);
    for (int i = 0; i < RECORDS; i++) {
        /* Half the difference of the grips' forces; the arithmetic is exact to rounding. */
        assert_near(curve.stress[i], (200.0 * i - (i > 0)) / 2 / section, 1e-6);
        assert_near(curve.strain[i], 0.001 * i, 1e-15);
    }
    assert_near(curve_force_imbalance(&curve, curve.n - 1), 1 / 399.5, 1e-12);
    assert_false(curve.measured);
    assert_string_equal(attributes_text(&curve.provenance, "generator_program"), "hsgen");

    struct partition shared = phases_at(&curve, 4);
    assert_string_equal(curve.phases[shared.hard].name, "UFG");
    /* q = (320 - 164) MPa / (0.0048 - 0.0032) */
    assert_relative(shared.factor, 156e6 / 0.0016, 1e-12);
    struct analysis found = analysis_make(&curve, &choices, true);
    struct properties list = analysis_report(&curve, &found, &choices, true);
    assert_near(property_value(&list, "reduction_of_area"), 4, 1e-9);
    assert_relative(property_value(&list, "partition_factor"), 156e6 / 0.0016 / 1e9, 1e-12);
    assert_near(property_value(&list, "CG_fraction"), 0.6, 0);
    properties_free(&list);
    analysis_free(&found);
    curve_free(&curve);
    input_free(&input);
}

static void sizes_by_choice(void **state)
{
    (void)state;
    struct history history = make_history();
    struct input input = write_and_read(&history);
    const char *texts[MOST_KEYS] = {0};
    struct option_row rows[MOST_KEYS];
    assert_in_range(post_section.keys.count, 1, MOST_KEYS);
    keys_options(&post_section.keys, rows, texts);
    for (int i = 0; i < post_section.keys.count; i++) {
        if (strcmp(rows[i].name, "gauge-length") == 0) *rows[i].value = "10 mm";
        if (strcmp(rows[i].name, "section") == 0) *rows[i].value = "4 mm2";
        if (strcmp(rows[i].name, "fit-range") == 0) *rows[i].value = "0.01:0.2";
    }
    struct choices choices = choices_read(NULL);
    keys_read_options(&post_section.keys, texts, &choices);
    assert_near(choices.fit_range[0], 0.01, 0);
    assert_near(choices.fit_range[1], 0.2, 0);
    struct curve curve = curve_make(&input, &choices);
    assert_near(curve.strain[2], 0.001, 1e-15);
    assert_relative(curve.stress[2], 199.5 / 4e-6, 1e-12);
    curve_free(&curve);
    input_free(&input);
    keys_options_free(&post_section.keys, rows);
}

static void deck_within(void **state)
{
    (void)state;
    static const char text[] = "title: A study\n"
                               "post: {title: HS40, modulus_range: [0.05, 0.3], toe: 0,\n"
                               "       true_modulus: 210 GPa}\n";
    struct deck *deck = deck_parse(text, strlen(text), "deck");
    struct choices choices = choices_read(deck);
    assert_string_equal(choices.title, "HS40");
    assert_near(choices.modulus_range[0], 0.05, 0);
    assert_near(choices.modulus_range[1], 0.3, 0);
    assert_near(choices.toe, 0, 0);
    assert_near(choices.true_modulus, 210e9, 0);
    assert_true(isnan(choices.modulus));
    deck_free(deck);
}

static void table_there_and_back(void **state)
{
    (void)state;
    const char text[] =
        "# title: T\n# scale: 2.5\nengineering_strain,engineering_stress_MPa\r\n0,1.1\n0.1,\n 0.3 "
        ",-7e-3\n";
    struct attributes notes = {0};
    struct table table = text_table_read(text, "t.csv", NULL, &notes);
    assert_int_equal(table.n_rows, 3);
    assert_string_equal(attributes_text(&notes, "title"), "T");
    assert_near(attributes_number(&notes, "scale", 0), 2.5, 0);
    assert_near(table_find(&table, "engineering_stress_Pa")[0], 1.1e6, 1e-9);
    assert_true(isnan(table_find(&table, "engineering_stress_Pa")[1]));

    char *written;
    size_t size;
    FILE *file = open_memstream(&written, &size);
    csv_write(file, &table);
    fclose(file);
    assert_string_equal(written,
                        "engineering_strain,engineering_stress_MPa\n0,1.1\n0.1,\n0.3,-0.007\n");
    free(written);
    table_free(&table);
    attributes_free(&notes);
}

/* Against a search through all numbers of digits: of numbers that have so many, of their
 * neighbours, of all sizes, on either side of a power of ten. */
static void fewest_digits_that_read_back(void **state)
{
    (void)state;
    struct random_stream *stream = random_new(1, "digits");
    for (int i = 0; i < 20000; i++) {
        char given[40], expected[40];
        const int exponent = i % 61 - 30;
        const double mantissa = i % 3 == 0 ? 1 - pow(10, -(i % 17)) : random_gaussian(stream);
        snprintf(given, sizeof given, "%.*e", i % 18, mantissa * pow(10, exponent));
        const double value = i % 2 ? strtod(given, NULL) : nextafter(strtod(given, NULL), 0);
        int digits = 14;
        do snprintf(expected, sizeof expected, "%.*g", ++digits, value);
        while (strtod(expected, NULL) != value);

        char *written;
        size_t size;
        FILE *file = open_memstream(&written, &size);
        csv_number(file, value);
        fclose(file);
        assert_string_equal(written, expected);
        free(written);
    }
    random_free(stream);
}

/* The check value of POSIX cksum: printf 123456789 | cksum. */
static void checksum(void **state)
{
    (void)state;
    assert_true(input_checksum((const unsigned char *)"123456789", 9) == 930766865U);
    assert_true(input_checksum((const unsigned char *)"", 0) == 4294967295U);
}

struct spoiling {
    const char *column;    /* taken out or, with a value, spoilt */
    const char *attribute; /* set to value */
    double value;
};

static void read_spoilt(const void *argument)
{
    const struct spoiling *spoiling = argument;
    struct history history = make_history();
    for (int j = 0; spoiling->column && j < history.n_columns; j++) {
        if (strcmp(history.columns[j], spoiling->column) != 0) continue;
        if (isnan(spoiling->value))
            history.values[2 * COLUMNS + j] = NAN;
        else
            history.columns[j][0] = 'x';
    }
    if (spoiling->attribute)
        attributes_set_number(&history.attributes, spoiling->attribute, spoiling->value);
    struct input input = write_and_read(&history);
    struct choices choices = choices_read(NULL);
    curve_make(&input, &choices);
}

static const struct option_row *find_option(const struct option_row rows[], const char *name)
{
    for (int i = 0; i < post_section.keys.count; i++)
        if (strcmp(rows[i].name, name) == 0) return &rows[i];
    fail_msg("no option --%s", name);
    return NULL;
}

static void options_are_keys(void **state)
{
    (void)state;
    const char *texts[MOST_KEYS];
    struct option_row rows[MOST_KEYS];
    keys_options(&post_section.keys, rows, texts);
    const struct option_row *row = find_option(rows, "hardening-range");
    assert_string_equal(row->argument, "A:B");
    assert_non_null(strstr(row->help, "plastic strain for n and K, at most Ag (0.02:0.2)"));
    assert_string_equal(find_option(rows, "gauge-length")->argument, "LENGTH");
    assert_string_equal(find_option(rows, "section")->argument, "AREA");
    assert_string_equal(find_option(rows, "title")->argument, "TEXT");
    assert_non_null(strstr(find_option(rows, "window")->help, "(0.01)"));
    assert_non_null(strstr(find_option(rows, "toe")->help, "(from the fit of the slope)"));
    keys_options_free(&post_section.keys, rows);
}

static void take_option(const void *argument)
{
    const char *const *words = argument;
    const char *texts[MOST_KEYS] = {0};
    struct choices choices;
    for (int i = 0; i < post_section.keys.count; i++)
        if (strcmp(post_section.keys.rows[i].name, words[0]) == 0) texts[i] = words[1];
    keys_read_options(&post_section.keys, texts, &choices);
}

static void wrong_options(void **state)
{
    (void)state;
    const struct {
        const char *words[2], *message;
    } wrong[] = {
        {{"window", "2"}, "--window: 2 is out of range, expected 1e-09 to 1\n"},
        {{"gauge_length", "2 s"}, "--gauge-length: "},
        {{"modulus", "0 MPa"}, "--modulus: 0 MPa is out of range, expected 1 to 1e+15 Pa"},
        {{"fit_range", "0.1"}, "--fit-range: '0.1', expected A:B"},
        {{"fit_range", "0.1:0.1"}, "--fit-range: '0.1:0.1', the first must be below the second"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_dies(EXIT_USER, wrong[i].message, take_option, wrong[i].words);
}

static void spoilt_histories(void **state)
{
    (void)state;
    const struct {
        struct spoiling spoiling;
        const char *message;
    } cases[] = {
        {{"force_left_N", NULL, 0}, "no column force_left_N"},
        {{"extension_m", NULL, 0}, "no column extension_m"},
        {{"force_right_N", NULL, NAN}, "force_right_N of record 3 is not a finite number"},
        {{NULL, "section_m2", 0}, "section_m2 = 0, expected a positive number"},
        {{NULL, "gauge_length_m", -1}, "gauge_length_m = -1, expected a positive number"},
        {{NULL, "section_m2", NAN}, "give --section"},
        {{NULL, "gauge_length_m", NAN}, "give --gauge-length"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_dies(EXIT_USER, cases[i].message, read_spoilt, &cases[i].spoiling);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(history_to_curve),
        cmocka_unit_test(sizes_by_choice),
        cmocka_unit_test(deck_within),
        cmocka_unit_test(table_there_and_back),
        cmocka_unit_test(fewest_digits_that_read_back),
        cmocka_unit_test(checksum),
        cmocka_unit_test(spoilt_histories),
        cmocka_unit_test(options_are_keys),
        cmocka_unit_test(wrong_options),
    };
    return cmocka_run_group_tests(tests, choose_path, remove_path);
}
