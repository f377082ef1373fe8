#include "check.h"

#include "units.h"

#include <float.h>
#include <string.h>

static void test_units_become_si(void **state)
{
    static const struct {
        const char *text, *unit;
        double value;
    } cases[] = {
        {"25 um", "m", 25e-6},
        {"25 µm", "m", 25e-6},
        {"5 mm", "m", 5e-3},
        {"5mm", "m", 5e-3},
        {"+.5 mm", "m", 0.5e-3},
        {"0.2e-3", "m", 0.2e-3},
        {"8900 kg/m3", "kg/m3", 8900},
        {"8.9 g/cm3", "kg/m3", 8900},
        {"1e4 /s", "1/s", 1e4},
        {"4000 1/s", "1/s", 4000},
        {"4 kHz", "1/s", 4000},
        {"185 MPa", "Pa", 185e6},
        {"185 N/mm2", "Pa", 185e6},
        {"2 MJ/m3", "Pa", 2e6},
        {"2 MJ/m3", "J/m3", 2e6},
        {"210 GPa", "Pa", 210e9},
        {"-10 m/s", "m/s", -10},
        {"0.05 us", "s", 0.05e-6},
        {"40 %", "1", 0.4},
        {"0.31", "1", 0.31},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double value = 0;
        const char *fault = units_read(cases[i].text, cases[i].unit, &value);
        if (fault != NULL) fail_msg("%s: %s", cases[i].text, fault);
        /* Two roundings: of the factor and of the product. */
        assert_relative(value, cases[i].value, 2 * DBL_EPSILON);
        double same = 0;
        assert_true(units_read_any(cases[i].text, &same));
        assert_true(same == value);
    }
    static const char *const none[] = {"", "CG", "5 foo", "2 spacings", "0x14", "nan", "20 degC"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_false(units_read_any(none[i], &(double){0}));
}

/* Lattice sizes are quotients of such numbers: they must come out as if written in metres. */
static void test_decimal_prefixes_are_exact(void **state)
{
    double size, spacing;
    (void)state;
    assert_null(units_read("5 mm", "m", &size));
    assert_null(units_read("25 um", "m", &spacing));
    assert_true(size == 5e-3);
    assert_true(spacing == 25e-6);
}

static void test_wrong_units_are_named(void **state)
{
    static const struct {
        const char *text, *unit, *message;
    } cases[] = {
        {"5 mm", "Pa", "'mm' is a length, expected a stress in Pa"},
        {"5 s", "1/s", "'s' is a time, expected a rate in 1/s"}, /* UDUNITS would invert it */
        {"5 Pa", "1", "'Pa' is a stress, expected a pure number"},
        {"5 foo", "m", "unknown unit 'foo', expected a length in m"},
        {"5 m 2", "m", "'m 2' is not a unit"},
        {"5 3", "m", "'3' is not a unit"},
        {"5,3", "1", "unknown unit ',3'"},
        {"20 degC", "K", "'degC' has an origin of its own"},
        {"0x14", "1", "'0x14' is not a number"},
        {"-0x14", "1", "'-0x14' is not a number"},
        {"nan", "1", "'nan' is not a number"},
        {"inf", "m", "'inf' is not a number"},
        {"--5", "1", "'--5' is not a number"},
        {".", "m", "'.' is not a number"},
        {"", "m", "'' is not a number"},
        {"mm", "m", "'mm' is not a number"},
        {"1e999", "m", "'1e999' is too large"},
        {"1e308 km", "m", "number too large in 'km'"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double value = 7;
        const char *fault = units_read(cases[i].text, cases[i].unit, &value);
        if (fault == NULL || strstr(fault, cases[i].message) == NULL)
            fail_msg("%s: said \"%s\", expected \"%s\"", cases[i].text, fault ? fault : "nothing",
                     cases[i].message);
        assert_true(value == 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_units_become_si),
        cmocka_unit_test(test_decimal_prefixes_are_exact),
        cmocka_unit_test(test_wrong_units_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
