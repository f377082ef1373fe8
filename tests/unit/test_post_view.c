/* The numbers behind a picture of fields: colours, ranges, prefixes, ticks. */
#include "check.h"

#include "colours.h"
#include "memory.h"
#include "scale.h"

#include <stdlib.h>

/* CIELAB lightness of an sRGB colour (IEC 61966-2-1, CIE 15). */
static double lightness(const double colour[3])
{
    static const double weights[3] = {0.2126, 0.7152, 0.0722};
    double luminance = 0;
    for (int k = 0; k < 3; k++) {
        double c = colour[k];
        luminance += weights[k] * (c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4));
    }
    return luminance > 0.008856 ? 116 * cbrt(luminance) - 16 : 903.3 * luminance;
}

/* Tolerance 1: just noticeable.  Control points have three digits, between them sRGB is linear. */
static void test_equal_steps_look_equal(void **state)
{
    (void)state;
    double before = 0;
    for (int k = 0; k <= 100; k++) {
        double colour[3];
        colour_of(k / 100.0, colour);
        for (int c = 0; c < 3; c++) assert_true(colour[c] >= 0 && colour[c] <= 1);
        assert_near(lightness(colour), 15 + 0.75 * k, 1);
        assert_true(lightness(colour) > before);
        before = lightness(colour);
    }
}

static void test_beyond_the_ends(void **state)
{
    double end[3], beyond[3], none[3];
    (void)state;
    colour_of(1, end);
    colour_of(7, beyond);
    assert_memory_equal(end, beyond, sizeof end);
    colour_of(0, end);
    colour_of(-INFINITY, beyond);
    assert_memory_equal(end, beyond, sizeof end);
    colour_of(NAN, none);
    assert_true(none[0] == none[1] && none[1] == none[2]);
}

static void expect_range(double low, double high, double expected_low, double expected_high)
{
    double range[2] = {low, high};
    scale_widen(range);
    assert_true(range[0] == expected_low && range[1] == expected_high);
}

static void test_range_of_what_was_found(void **state)
{
    (void)state;
    expect_range(1, 3, 1, 3);
    expect_range(2, 2, 1, 3);
    expect_range(-2, -2, -3, -1);
    expect_range(0, 0, 0, 1);
    expect_range(INFINITY, -INFINITY, 0, 1);
}

/* texts: the ticks, each followed by a blank. */
static void expect_ticks(double low, double high, const char *si, const char *unit,
                         const char *texts)
{
    struct scale scale = scale_make((const double[]){low, high}, si, 5);
    char *all = memory_text("");
    for (int k = 0; k < scale.n_ticks; k++) {
        char *text = scale_text(&scale, scale.ticks[k]), *longer = memory_print("%s%s ", all, text);
        free(text);
        free(all);
        all = longer;
    }
    assert_string_equal(scale.unit, unit);
    assert_string_equal(all, texts);
    free(all);
    scale_free(&scale);
}

static void test_ticks(void **state)
{
    (void)state;
    expect_ticks(0, 1, "1", "", "0.0 0.2 0.4 0.6 0.8 1.0 ");
    expect_ticks(0, 0.0221, "1", "", "0.000 0.005 0.010 0.015 0.020 ");
    expect_ticks(12.3e6, 951e6, "Pa", "MPa", "200 400 600 800 ");
    expect_ticks(-2e-6, 2e-6, "m", "µm", "-2 -1 0 1 2 ");
    expect_ticks(-3e13, 2e13, "N/m3", "TN/m³", "-30 -20 -10 0 10 20 ");
    expect_ticks(1e6, 5e6, "1", "", "1e+06 2e+06 3e+06 4e+06 5e+06 ");
    expect_ticks(0, 4e-7, "1", "", "0 1e-07 2e-07 3e-07 4e-07 ");
    expect_ticks(999, 1000, "m/s", "km/s", "0.9990 0.9992 0.9994 0.9996 0.9998 1.0000 ");
}

static void expect_quantity(double value, const char *unit, const char *expected)
{
    char *text = scale_quantity(value, unit);
    assert_string_equal(text, expected);
    free(text);
}

static void test_quantities(void **state)
{
    (void)state;
    expect_quantity(3.408e-6, "s", "3.408 µs");
    expect_quantity(0, "s", "0 s");
    expect_quantity(1e-3, "m", "1 mm");
    expect_quantity(-25e-6, "m", "-25 µm");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_equal_steps_look_equal),
        cmocka_unit_test(test_beyond_the_ends),
        cmocka_unit_test(test_range_of_what_was_found),
        cmocka_unit_test(test_ticks),
        cmocka_unit_test(test_quantities),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
