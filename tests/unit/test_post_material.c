/* From a curve to a section of the deck, and back. */
#include "check.h"
#include "sections.h"

#include "deck.h"
#include "dies.h"
#include "material_block.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

static const double young = 200e9;

/* Uniaxial tension of a law to true strain end, 12 rows elastic, then denser at yield. */
static struct curve curve_of(const struct hardening *law, double end)
{
    enum { ELASTIC = 12, N = 260 };
    struct curve curve = curve_new(N, "made");
    curve.measured = true;
    const double first = hardening_stress(law, 0);
    for (int i = 0; i < N; i++) {
        const double share = (double)(i - ELASTIC) / (N - 1 - ELASTIC),
                     p = i < ELASTIC ? 0 : end * share * share;
        const double stress = i < ELASTIC ? first * i / ELASTIC : hardening_stress(law, p);
        const double strain = p + stress / young;
        curve.strain[i] = expm1(strain);
        curve.stress[i] = stress * exp(-strain);
    }
    return curve;
}

static struct material material_of(struct curve *curve, const char *law)
{
    struct choices choices = choices_read(NULL);
    choices.modulus = young;
    choices.toe = 0;
    struct analysis analysis = analysis_make(curve, &choices, true);
    struct material material = material_make("M", curve, &analysis, law);
    material.density = 7800;
    material.poissons_ratio = 0.3;
    analysis_free(&analysis);
    return material;
}

/* The law as the solver reads what is printed. */
static struct hardening read_back(const struct material *material, const struct curve *curve)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    material_print(file, material, curve, "corner");
    fclose(file);
    struct deck *deck = deck_parse(text, size, "printed");
    struct deck_node map = deck_get(deck_get(deck_root(deck), "materials"), "M");
    assert_string_equal(deck_string(deck_get(map, "model")), "corner");
    assert_relative(deck_number(deck_get(map, "density"), "kg/m3", 0, 1e6), 7800, 1e-9);
    assert_relative(deck_number(deck_get(map, "youngs_modulus"), "Pa", 0, 1e15), young, 1e-5);
    struct hardening law = hardening_read(deck_get(map, "hardening"));
    deck_free(deck);
    free(text);
    return law;
}

static const struct {
    const char *law;
    double parameter[HARDENING_PARAMETERS], end;
} cases[] = {
    {"hollomon", {500e6, 0.2, 50e6}, 0.15},
    {"ludwik", {165e6, 700e6, 0.67}, 0.25},
    {"swift", {900e6, 0.01, 0.25}, 0.2},
    {"voce", {300e6, 260e6, 9}, 0.15},
    {"two_voce", {100e6, 80e6, 400e6, 400, 5}, 0.2},
    {"linear", {200e6, 400e6}, 0.3},
};
enum { CASES = sizeof cases / sizeof *cases };

static void every_law_comes_back_through_the_deck(void **state)
{
    (void)state;
    int fitted = 0;
    for (int i = 0; hardening_law(i); i++) fitted += hardening_law(i)->n_linear > 0;
    assert_int_equal(fitted, CASES);
    for (int i = 0; i < CASES; i++) {
        struct hardening truth = {.law = hardening_fitted(cases[i].law)};
        memcpy(truth.parameter, cases[i].parameter, sizeof truth.parameter);
        struct curve curve = curve_of(&truth, cases[i].end);
        const char *const laws[] = {cases[i].law, "tabulated", NULL};
        /* A law: six printed digits.  A table: within 0.1 % of Rm, and what lies between its
         * points. */
        const double tolerances[] = {2e-4, 2e-3, 2e-3};
        for (int k = 0; k < 3; k++) {
            struct material material = material_of(&curve, laws[k]);
            struct hardening law = read_back(&material, &curve);
            if (laws[k]) assert_string_equal(law.law->variant.name, laws[k]);
            for (double p = 1e-3; p < 0.95 * cases[i].end; p += 0.01)
                assert_relative(hardening_stress(&law, p), hardening_stress(&truth, p),
                                tolerances[k]);
            hardening_free(&law);
            material_free(&material);
        }
        curve_free(&curve);
    }
}

/* Stresses that fall are pooled by least squares: the table's fit of 1, 3, 2, 4 is 1, 2.5, 2.5, 4.
 */
static void tables_do_not_fall(void **state)
{
    (void)state;
    const double sigma[] = {0, 100e6, 200e6, 220e6, 260e6, 240e6, 280e6, 300e6},
                 p[] = {0, 0, 0, 0.01, 0.02, 0.03, 0.04, 0.05};
    struct curve curve = curve_new(8, "falls");
    curve.measured = true;
    for (int i = 0; i < 8; i++) {
        const double strain = p[i] + sigma[i] / young;
        curve.strain[i] = expm1(strain);
        curve.stress[i] = sigma[i] * exp(-strain);
    }
    struct material material = material_of(&curve, "tabulated");
    const double found = hardening_stress(&material.hardening, 0.02);
    assert_near(found, 250e6, 1e3);
    assert_near(hardening_stress(&material.hardening, 0.03), 250e6, 1e3);
    for (int i = 1; i < material.hardening.n_points; i++)
        assert_true(material.hardening.stress[i] >= material.hardening.stress[i - 1]);
    assert_near(material.hardening.stress[0], 200e6, 1e3);
    material_free(&material);
    curve_free(&curve);
}

/* What no law has: a knee of its own, and a plateau. */
static void what_no_law_has_is_a_table(void **state)
{
    (void)state;
    struct hardening knee = {.law = hardening_fitted("linear"), .parameter = {200e6, 300e6}};
    struct curve curve = curve_of(&knee, 0.2);
    for (long i = 0; i < curve.n; i++)
        if (curve.strain[i] > 0.1) curve.stress[i] += (curve.strain[i] - 0.1) * 1.5e9;
    struct material material = material_of(&curve, NULL);
    assert_string_equal(material.hardening.law->variant.name, "tabulated");
    assert_non_null(strstr(material.reason, "no law is within 0.5 % of Rm"));
    /* far fewer points than rows, all within the share */
    assert_in_range(material.hardening.n_points, 3, 30);
    assert_true(material.root_mean_square < 1e-3 * 400e6);
    material_free(&material);
    curve_free(&curve);
}

static void make_of_elastic(const void *argument)
{
    struct curve curve = *(const struct curve *)argument;
    material_of(&curve, NULL);
}

static void an_elastic_curve_has_no_law(void **state)
{
    (void)state;
    struct curve curve = curve_new(5, "elastic");
    curve.measured = true;
    for (int i = 0; i < 5; i++) {
        curve.strain[i] = 1e-4 * i;
        curve.stress[i] = young * 1e-4 * i;
    }
    assert_dies(EXIT_USER, "too few for a hardening law", make_of_elastic, &curve);
    curve_free(&curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_law_comes_back_through_the_deck),
        cmocka_unit_test(tables_do_not_fall),
        cmocka_unit_test(what_no_law_has_is_a_table),
        cmocka_unit_test(an_elastic_curve_has_no_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
