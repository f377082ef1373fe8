/* The two digitised curves: values worked out independently when they were digitised and fitted.
 * Each tolerance is half a unit of the last printed digit. */
#include "check.h"
#include "sections.h"

#include "analysis.h"
#include "property.h"

#include <stdlib.h>

struct case_of {
    const char *path;
    struct choices choices;
    struct curve curve;
    struct analysis analysis;
    struct properties properties;
};

static void run(struct case_of *c)
{
    struct input input = input_read(c->path, NULL);
    c->curve = curve_make(&input, &c->choices);
    input_free(&input);
    c->analysis = analysis_make(&c->curve, &c->choices, true);
    c->properties = analysis_report(&c->curve, &c->analysis, &c->choices, true);
}

static void drop(struct case_of *c)
{
    properties_free(&c->properties);
    analysis_free(&c->analysis);
    curve_free(&c->curve);
}

static struct case_of nickel_200(void)
{
    struct case_of c = {.path = "tests/data/ni200_cg.csv", .choices = choices_read(NULL)};
    c.choices.modulus_rows[0] = 1;
    c.choices.modulus_rows[1] = 3;
    return c;
}

static struct case_of torsion_nickel(void)
{
    struct case_of c = {.path = "tests/data/hpt_ni_ufg.csv", .choices = choices_read(NULL)};
    c.choices.modulus_rows[0] = 1;
    c.choices.modulus_rows[1] = 4;
    return c;
}

static void expect(const struct case_of *c, const char *name, double value, double tolerance)
{
    double found = property_value(&c->properties, name);
    if (!(fabs(found - value) <= tolerance))
        fail_msg("%s = %.8g, expected %.8g within %.2g", name, found, value, tolerance);
}

/* How many rows the law is fitted to. */
static void expect_points(const struct case_of *c, const char *law, long count)
{
    struct law_fit fit = true_curve_fit(&c->curve, hardening_fitted(law),
                                        c->analysis.measures.uniform, c->analysis.fit_range);
    assert_int_equal(fit.count, count);
}

static void coarse_grained(void **state)
{
    (void)state;
    struct case_of c = nickel_200();
    run(&c);
    expect(&c, "modulus", 191.14, 0.005);
    expect(&c, "toe", -4.4e-6, 0.05e-6);
    expect(&c, "proof_strength_0.1", 169.51, 0.005);
    expect(&c, "proof_strength_0.2", 183.06, 0.005);
    expect(&c, "proof_strength_1.0", 207.16, 0.005);
    expect(&c, "tensile_strength", 430.53, 0.005);
    expect(&c, "tensile_strength_reached", 0, 0);
    expect(&c, "extension_at_maximum_force", 25.13, 0.005);
    expect(&c, "plastic_extension_at_maximum_force", 24.91, 0.005);
    expect(&c, "toughness", 87.87, 0.005);
    drop(&c);
}

static void coarse_grained_exponent(void **state)
{
    (void)state;
    struct case_of c = nickel_200();
    c.choices.toe = 0;
    run(&c);
    /* 0.3507 was cut, not rounded: 0.35075. */
    expect(&c, "hardening_exponent", 0.35075, 0.00005);
    expect(&c, "hardening_strength", 889.0, 0.05);
    assert_int_equal(c.analysis.measures.power_law.count, 12);
    drop(&c);

    c = nickel_200();
    c.choices.toe = 0;
    c.choices.hardening_range[0] = 0.10;
    run(&c);
    expect(&c, "hardening_exponent", 0.3985, 0.00005);
    expect(&c, "hardening_strength", 985.6, 0.05);
    assert_int_equal(c.analysis.measures.power_law.count, 6);
    drop(&c);
}

static void ultra_fine_grained(void **state)
{
    (void)state;
    struct case_of c = torsion_nickel();
    run(&c);
    expect(&c, "modulus", 41.06, 0.005);
    expect(&c, "toe", 0.005359, 0.5e-6);
    expect(&c, "proof_strength_0.1", 1243.76, 0.005);
    expect(&c, "proof_strength_0.2", 1450.18, 0.005);
    expect(&c, "tensile_strength", 1766.67, 0.005);
    expect(&c, "tensile_strength_reached", 1, 0);
    expect(&c, "extension_at_maximum_force", 5.94, 0.005);
    expect(&c, "plastic_extension_at_maximum_force", 1.637, 0.0005);
    expect(&c, "extension_at_fracture", 11.02, 0.005);
    expect(&c, "plastic_extension_at_fracture", 7.669, 0.0005);
    expect(&c, "toughness", 147.13, 0.005);
    assert_true(isnan(property_value(&c.properties, "hardening_exponent")));
    drop(&c);
}

static void coarse_grained_laws(void **state)
{
    (void)state;
    struct case_of c = nickel_200();
    c.choices.toe = 0;
    c.choices.modulus = 200e9;
    run(&c);
    expect_points(&c, "voce", 27);
    expect(&c, "voce_yield", 182.10, 0.005);
    expect(&c, "voce_saturation", 513.01, 0.005);
    expect(&c, "voce_rate", 5.3204, 0.00005);
    expect(&c, "voce_rms", 1.12, 0.005);
    expect(&c, "voce_max_error", 3.6, 0.05);
    expect(&c, "voce_uniform_strain", 0.2895, 0.00005);
    expect(&c, "swift_strength", 1068.97, 0.005);
    expect(&c, "swift_offset", 0.02431, 0.000005);
    expect(&c, "swift_exponent", 0.4823, 0.00005);
    expect(&c, "swift_uniform_strain", 0.458, 0.0005);
    expect(&c, "ludwik_yield", 165.44, 0.005);
    expect(&c, "ludwik_strength", 1050.8, 0.05);
    expect(&c, "ludwik_exponent", 0.6728, 0.00005);
    expect(&c, "ludwik_uniform_strain", 0.544, 0.0005);
    expect(&c, "hollomon_strength", 766.2, 0.05);
    expect(&c, "hollomon_exponent", 0.271, 0.0005);
    expect(&c, "linear_yield", 197.8, 0.06);
    expect(&c, "linear_modulus", 1692, 0.5);
    expect(&c, "linear_uniform_strain", 0.883, 0.0005);
    drop(&c);
}

static void coarse_grained_two_terms(void **state)
{
    (void)state;
    struct case_of c = nickel_200();
    c.choices.toe = 0;
    c.choices.modulus = 200e9;
    c.choices.fit_range[0] = 2e-4;
    run(&c);
    expect_points(&c, "two_voce", 38);
    expect(&c, "two_voce_yield", 101.40, 0.005);
    expect(&c, "two_voce_saturation", 80.90, 0.005);
    expect(&c, "two_voce_rate", 1741.7, 0.05);
    expect(&c, "two_voce_saturation_2", 513.72, 0.005);
    expect(&c, "two_voce_rate_2", 5.3022, 0.00005);
    expect(&c, "two_voce_rms", 1.05, 0.005);
    expect(&c, "two_voce_max_error", 2.1, 0.05);
    expect(&c, "two_voce_uniform_strain", 0.290, 0.0005);
    drop(&c);
}

/* The machine's compliance removed with E = 200 GPa: rows 6 to 10. */
static void ultra_fine_grained_law(void **state)
{
    (void)state;
    struct case_of c = torsion_nickel();
    c.choices.true_modulus = 200e9;
    c.choices.fit_range[0] = 0.0015;
    run(&c);
    expect_points(&c, "voce", 5);
    expect(&c, "voce_yield", 1259.76, 0.005);
    expect(&c, "voce_saturation", 564.49, 0.005);
    expect(&c, "voce_rate", 238.51, 0.005);
    expect(&c, "voce_rms", 0.18, 0.005);
    expect(&c, "voce_uniform_strain", 0.0181, 0.00005);
    expect(&c, "hollomon_strength", 2794.7, 0.05);
    expect(&c, "hollomon_exponent", 0.101, 0.0005);
    /* Plastic quantities do not depend on the machine. */
    expect(&c, "plastic_extension_at_maximum_force", 1.637, 0.0005);
    expect(&c, "proof_strength_0.2", 1450.18, 0.005);
    drop(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coarse_grained),           cmocka_unit_test(coarse_grained_exponent),
        cmocka_unit_test(ultra_fine_grained),       cmocka_unit_test(coarse_grained_laws),
        cmocka_unit_test(coarse_grained_two_terms), cmocka_unit_test(ultra_fine_grained_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
