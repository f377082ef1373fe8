/* Hardening laws against their formulas, their tables against the laws, and what the deck refuses.
 */
#include "dies.h"

#include "deck.h"
#include "flow_curve.h"

#include <stdlib.h>
#include <string.h>

static struct hardening read_law(const char *text)
{
    struct deck *deck = deck_parse(text, strlen(text), "test");
    struct hardening law = hardening_read(deck_root(deck));
    deck_free(deck);
    return law;
}

#define LINEAR   "{law: linear, yield: 182 MPa, modulus: 850 MPa}"
#define SWIFT    "{law: swift, yield: 182 MPa, strength: 900 MPa, exponent: 0.4}"
#define LUDWIK   "{law: ludwik, yield: 182 MPa, strength: 900 MPa, exponent: 0.5}"
#define HOLLOMON "{law: hollomon, yield: 182 MPa, strength: 900 MPa, exponent: 0.4}"
#define VOCE     "{law: voce, yield: 182 MPa, saturation: 513 MPa, rate: 5.32}"
#define STRONG   "{law: voce, yield: 1260 MPa, saturation: 565 MPa, rate: 238.5}"
#define TWO_VOCE                                                                                   \
    "{law: two_voce, yield: 182 MPa, saturation: 300 MPa, rate: 5, saturation_2: 100 MPa, "        \
    "rate_2: 80}"
#define TABLE "{law: tabulated, points: [[0, 180 MPa], [0.05, 300 MPa], [0.25, 500 MPa]]}"

static double linear(double p)
{
    return 182 + 850 * p;
}
static double swift(double p)
{
    return 900 * pow(pow(182.0 / 900, 1 / 0.4) + p, 0.4);
}
static double ludwik(double p)
{
    return 182 + 900 * sqrt(p);
}
static double hollomon(double p)
{
    return fmax(182, 900 * pow(p, 0.4));
}
static double voce(double p)
{
    return 182 + 513 * (1 - exp(-5.32 * p));
}
static double strong(double p)
{
    return 1260 + 565 * (1 - exp(-238.5 * p));
}
static double two_voce(double p)
{
    return 182 + 300 * (1 - exp(-5 * p)) + 100 * (1 - exp(-80 * p));
}
static double table(double p)
{
    return p < 0.05 ? 180 + 2400 * p : p < 0.25 ? 300 + 1000 * (p - 0.05) : 500;
}

/* A law, its formula in MPa, and where its slope jumps. */
static const struct {
    const char *text;
    double (*formula)(double p);
    double kinks[2];
} laws[] = {
    {LINEAR, linear, {-1, -1}},     {SWIFT, swift, {-1, -1}},
    {LUDWIK, ludwik, {-1, -1}},     {HOLLOMON, hollomon, {0.01840, -1}}, /* (182/900)^(1/0.4) */
    {VOCE, voce, {-1, -1}},         {STRONG, strong, {-1, -1}},
    {TWO_VOCE, two_voce, {-1, -1}}, {TABLE, table, {0.05, 0.25}},
};
enum { LAWS = sizeof laws / sizeof *laws };

static const double strains[] = {0, 1e-6, 1e-5, 1e-4, 2e-3, 0.0171, 0.049, 0.06, 0.2, 0.7, 2, 10};
enum { STRAINS = sizeof strains / sizeof *strains };

static void test_formulas_and_slopes(void **state)
{
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        struct hardening law = read_law(laws[k].text);
        for (int i = 0; i < STRAINS; i++) {
            const double p = strains[i], h = 1e-4 * p;
            /* the same formula with other roundings */
            assert_relative(hardening_stress(&law, p), 1e6 * laws[k].formula(p), 1e-14);
            if (p == 0) continue;
            /* differences: h^2/p^2 = 1e-8 of the slope, rounding of both stresses over h */
            double slope = 1e6 * (laws[k].formula(p + h) - laws[k].formula(p - h)) / (2 * h);
            assert_near(hardening_slope(&law, p), slope,
                        1e-7 * fabs(slope) + 1e-14 * hardening_stress(&law, p) / h);
        }
        hardening_free(&law);
    }
}

/* A law that joins the table has to join the list above. */
static void test_the_list_has_every_law(void **state)
{
    (void)state;
    for (int i = 0; hardening_law(i); i++) {
        char start[64];
        snprintf(start, sizeof start, "{law: %s,", hardening_law(i)->variant.name);
        bool found = false;
        for (int k = 0; k < LAWS; k++) found |= strncmp(laws[k].text, start, strlen(start)) == 0;
        if (!found) fail_msg("no test of the law %s", hardening_law(i)->variant.name);
    }
}

static void test_kinks_and_ends(void **state)
{
    (void)state;
    struct hardening points = read_law(TABLE), power = read_law(HOLLOMON), none = hardening_none();
    assert_relative(hardening_slope(&points, 0.05), 1000e6, 1e-12); /* to the right */
    assert_relative(hardening_slope(&points, 0), 2400e6, 1e-12);
    assert_true(hardening_slope(&points, 0.25) == 0);
    assert_true(hardening_stress(&points, 3) == 500e6);
    assert_true(hardening_slope(&power, 0.01) == 0);
    assert_true(hardening_stress(&none, 1) > 1e14 && hardening_slope(&none, 1) == 0);
    assert_string_equal(power.law->variant.name, "hollomon");
    hardening_free(&points);
    hardening_free(&power);
}

/* Is p within two cells of the table (3 % of p) of a kink? */
static bool near_kink(int law, double p)
{
    for (int k = 0; k < 2; k++)
        if (fabs(p - laws[law].kinks[k]) < 0.04 * laws[law].kinks[k]) return true;
    return false;
}

/* Relative errors that flow_curve.h states: 1e-9; Ludwik's start is infinitely steep, which the
 * first cells (4e-6 of strain each) cannot follow; at a kink an eighth of a cell, 1.6 % of p, times
 * the change of slope, here up to 2 GPa. */
static double table_tolerance(int law, double p)
{
    if (laws[law].formula == ludwik && p < 1e-3) return p < 4e-6 ? 2e-3 : 2e-3 * pow(p / 4e-6, -3);
    return near_kink(law, p) ? 2e9 * 0.016 * p / 8 / 180e6 : 1e-9;
}

static void check_table(int law, const struct hardening *exact, const double *table)
{
    double before = 0;
    for (double p = 1e-8; p < 4; p *= 1.0037) {
        const int64_t cell = flow_cell(0, p);
        const double stress = flow_stress(table, cell, p);
        assert_relative(stress, hardening_stress(exact, p), table_tolerance(law, p));
        assert_true(stress >= before * (1 - 1e-15)); /* never softens, but for its rounding */
        before = stress;
        if (near_kink(law, p) || laws[law].formula == ludwik) continue;
        /* enters as a correction of 3 mu = 240 GPa: 1e-7 of that */
        assert_near(flow_slope(table, cell, p), hardening_slope(exact, p), 24e3);
    }
}

static void test_tables_follow_the_laws(void **state)
{
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        struct hardening law = read_law(laws[k].text);
        const struct hardening *const pointer[] = {&law};
        double *curves = flow_curves_new(1, pointer, pointer);
        check_table(k, &law, curves);
        /* beyond the last cell along its tangent */
        const int64_t last = flow_cell(0, 5);
        assert_relative(flow_stress(curves, last, 5),
                        hardening_stress(&law, curves[last]) +
                            (5 - curves[last]) * hardening_slope(&law, curves[last]),
                        1e-12); /* roundings */
        free(curves);
        hardening_free(&law);
    }
}

/* The curve of a bond between two phases is the mean of theirs; its plastic work the integral. */
static void test_means_and_work(void **state)
{
    (void)state;
    struct hardening soft = read_law(VOCE), hard = read_law(STRONG);
    const struct hardening *const first[] = {&soft, &soft}, *const second[] = {&soft, &hard};
    double *curves = flow_curves_new(2, first, second);
    for (int i = 0; i < STRAINS - 1; i++) {
        const double p = strains[i];
        const int64_t own = flow_cell(0, p), mean = flow_cell(1, p);
        assert_relative(flow_stress(curves, mean, p), 0.5e6 * (voce(p) + strong(p)), 1e-9);
        double work = 1e6 * (182 * p + 513 * (p + expm1(-5.32 * p) / 5.32));
        assert_relative(flow_work(curves, own, p), work, 1e-9); /* as its integrand */
    }
    free(curves);
    hardening_free(&soft);
    hardening_free(&hard);
}

static void read_and_drop(const void *text)
{
    struct hardening law = read_law(text);
    hardening_free(&law);
}

static void test_what_the_deck_refuses(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"{law: vote, yield: 1 MPa}", "voce"},
        {"{law: voce, yield: 1 MPa, saturation: 1 MPa}", "rate"},
        {"{law: voce, yield: 1 MPa, saturation: 1 MPa, rte: 5}", "rate"},
        {"{law: voce, yield: 1 kg, saturation: 1 MPa, rate: 5}", "test:1:"},
        {"{law: linear, yield: 100 MPa, modulus: -1 MPa}", "test:1:"},
        {"{law: ludwik, yield: 1 MPa, strength: 1 MPa, exponent: 2}", "test:1:"},
        {"{law: swift, yield: 2 MPa, strength: 1 MPa, exponent: 0.5}", "above the strength"},
        {"{law: tabulated, points: [[0, 1 MPa]]}", "two points"},
        {"{law: tabulated, points: [[0.1, 1 MPa], [0.2, 2 MPa]]}", "plastic strain 0"},
        {"{law: tabulated, points: [[0, 1 MPa], [0, 2 MPa]]}", "must rise"},
        {"{law: tabulated, points: [[0, 2 MPa], [1, 1 MPa]]}", "must not fall"},
        {"{law: tabulated, points: [[0, 2 MPa], [1]]}", "[plastic strain, true stress]"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_dies(EXIT_USER, wrong[i][1], read_and_drop, wrong[i][0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_list_has_every_law),
        cmocka_unit_test(test_formulas_and_slopes),
        cmocka_unit_test(test_kinks_and_ends),
        cmocka_unit_test(test_tables_follow_the_laws),
        cmocka_unit_test(test_means_and_work),
        cmocka_unit_test(test_what_the_deck_refuses),
    };
    return cmocka_run_group_tests_name("hardening", tests, NULL, NULL);
}
