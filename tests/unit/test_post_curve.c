/* Curves made by hand, whose properties are known beforehand. */
#include "check.h"
#include "sections.h"

#include "analysis.h"
#include "bounds.h"
#include "difference.h"
#include "memory.h"
#include "mixture.h"
#include "property.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

static struct curve curve_of(long n, const double strain[], const double stress[])
{
    struct curve curve = curve_new(n, "by hand");
    memcpy(curve.strain, strain, (size_t)n * sizeof *strain);
    memcpy(curve.stress, stress, (size_t)n * sizeof *stress);
    return curve;
}

/* Uniaxial tension of a Voce solid, E = 200 GPa, from zero to engineering strain 0.45. */
static const double young = 200e9, voce_yield = 180e6, voce_saturation = 500e6, voce_rate = 5;

static double voce_stress(double p)
{
    return voce_yield + voce_saturation * (1 - exp(-voce_rate * p));
}

static struct curve voce_curve(long n)
{
    struct curve curve = curve_new(n, "voce");
    for (long i = 0; i < n; i++) {
        double share = (double)i / (double)(n - 1), e = 0.45 * share * share, eps = log1p(e);
        double stress = young * eps;
        if (stress > voce_yield) {
            double p = eps;
            /* p + sigma(p)/E = eps is a contraction. */
            for (int k = 0; k < 100; k++) p = eps - voce_stress(p) / young;
            stress = voce_stress(p);
        }
        curve.strain[i] = e;
        curve.stress[i] = stress / (1 + e);
    }
    return curve;
}

static void law_comes_back(void **state)
{
    (void)state;
    struct curve curve = voce_curve(601);
    struct choices choices = choices_read(NULL);
    struct analysis found = analysis_make(&curve, &choices, true);
    /* The chord of s = E ln(1+e)/(1+e) bends by 1.5 e, 0.05 % of E at 40 % of Rp0.2. */
    assert_relative(found.measures.line.slope, young, 1e-3);
    /* The measured slope stands for E in the plastic strain: an error of 1e-3 sigma/E < 4e-6 of it,
     * times the hardening rate b Q = 2.5 GPa is 1e4 Pa. */
    struct law_fit fit = true_curve_fit(&curve, hardening_fitted("voce"),
                                        found.measures.maximum.row, choices.fit_range);
    assert_near(fit.hardening.parameter[0], voce_yield, 5e4);
    assert_relative(fit.hardening.parameter[1], voce_saturation, 1e-3);
    assert_relative(fit.hardening.parameter[2], voce_rate, 1e-3);
    assert_true(fit.converged);

    /* d sigma/d eps = sigma with the elastic part: theta/(1 + theta/E) = sigma, by bisection. */
    double low = 0, high = 1;
    for (int i = 0; i < 60; i++) {
        double p = (low + high) / 2, theta = voce_saturation * voce_rate * exp(-voce_rate * p);
        *(theta / (1 + theta / young) > voce_stress(p) ? &low : &high) = p;
    }
    double uniform = low + voce_stress(low) / young;
    /* Points are 1e-3 apart there; the slope is that of a quadratic over 0.01. */
    assert_near(found.considere.strain, uniform, 2e-4);
    assert_near(log1p(found.measures.maximum.strain), uniform, 1e-3);
    /* Hardening rate half way: 0.1 % for the quadratic over the window. */
    long row = 300;
    double theta = voce_saturation * voce_rate * exp(-voce_rate * curve.plastic_strain[row]);
    assert_relative(curve.hardening_rate[row], theta, 1e-3);
    assert_true(isnan(curve.true_stress[found.measures.maximum.row + 1]));
    analysis_free(&found);
    curve_free(&curve);
}

static void uniform_strain_in_closed_form(void **state)
{
    (void)state;
    const struct {
        const char *law;
        double parameter[HARDENING_PARAMETERS], expected;
    } cases[] = {
        {"hollomon", {800e6, 0.27}, 0.27},
        {"swift", {1069e6, 0.0243, 0.4823}, 0.4823 - 0.0243},
        {"linear", {200e6, 1700e6}, 1 - 200.0 / 1700},
        {"voce", {180e6, 500e6, 5}, log(500.0 * 6 / 680) / 5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hardening law = {.law = hardening_fitted(cases[i].law)};
        memcpy(law.parameter, cases[i].parameter, sizeof law.parameter);
        /* The root is found to a relative 1e-12. */
        assert_near(law_uniform_strain(&law), cases[i].expected, 1e-11);
    }
}

static void every_law_fits_itself(void **state)
{
    (void)state;
    const struct {
        const char *law;
        double parameter[HARDENING_PARAMETERS];
    } cases[] = {
        {"hollomon", {800e6, 0.27}},
        {"ludwik", {165e6, 1050e6, 0.67}},
        {"swift", {1069e6, 0.0243, 0.4823}},
        {"voce", {1260e6, 564e6, 238}},
        {"two_voce", {101e6, 81e6, 514e6, 500, 5.3}},
        {"linear", {200e6, 1700e6}},
    };
    enum { N = 60, CASES = sizeof cases / sizeof *cases };
    int fitted = 0;
    for (int i = 0; hardening_law(i); i++) fitted += hardening_law(i)->n_linear > 0;
    assert_int_equal(fitted, CASES);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hardening truth = {.law = hardening_fitted(cases[i].law)};
        memcpy(truth.parameter, cases[i].parameter, sizeof truth.parameter);
        double p[N], stress[N];
        for (int k = 0; k < N; k++) {
            p[k] = 0.001 + 0.25 * k * k / (N * N);
            stress[k] = hardening_stress(&truth, p[k]);
        }
        struct law_fit fit = law_fit(truth.law, p, stress, N);
        assert_true(fit.done);
        /* No noise: what is left is the polish, whose finite-difference Jacobian is good to 1e-8.
         */
        for (int k = 0; k < truth.law->n_linear + truth.law->n_shapes; k++)
            assert_relative(fit.hardening.parameter[k], truth.parameter[k], 1e-5);
    }
}

static void yield_point(void **state)
{
    (void)state;
    const double e[] = {0, 0.001, 0.002, 0.003, 0.01, 0.02, 0.05, 0.1};
    const double s[] = {0, 200e6, 300e6, 270e6, 265e6, 275e6, 350e6, 340e6};
    const struct yield_record record = {8, e, s, s, 0, 0, 0, NAN, NAN};
    struct yield_point found = yield_point_find(&record, 0.02);
    assert_near(found.upper, 300e6, 0);
    assert_near(found.lower, 265e6, 0);
    /* The fall behind Rm has no rise behind it: no yield point. */
    assert_true(isnan(yield_point_find(&record, 0.2).upper));
}

/* The first valley is the initial transient where another follows; what is exceeded within 0.05 %
 * of strain is no upper yield point. */
static void transient_and_span(void **state)
{
    (void)state;
    const double e[] = {0, 0.001, 0.002, 0.004, 0.006, 0.008, 0.02, 0.05, 0.1};
    const double s[] = {0, 200e6, 300e6, 250e6, 280e6, 270e6, 300e6, 350e6, 340e6};
    const struct yield_record record = {9, e, s, s, 0, 0, 0, NAN, NAN};
    struct yield_point found = yield_point_find(&record, 0.005);
    assert_near(found.upper, 300e6, 0);
    assert_near(found.lower, 270e6, 0);
    assert_int_equal(found.end, 5);
    /* The steepest line of hardening, over three rows, comes down to 270 MPa before the last
     * valley, where it begins. */
    assert_near(found.extension, 0.006, 1e-12);
    const double g[] = {0, 0.001, 0.002, 0.0021, 0.0024, 0.01, 0.02, 0.05, 0.1};
    const double t[] = {0, 200e6, 300e6, 297e6, 301e6, 310e6, 320e6, 350e6, 340e6};
    const struct yield_record soon = {9, g, t, t, 0, 0, 0, NAN, NAN};
    assert_true(isnan(yield_point_find(&soon, 0.005).upper));
}

static void plateau_and_fracture(void **state)
{
    (void)state;
    const double e[] = {0, 0.001, 0.1, 0.2, 0.3, 0.4, 0.5};
    const double s[] = {0, 200e6, 400e6, 400e6, 300e6, 30e6, 1e6};
    struct curve curve = curve_of(7, e, s);
    struct strength_maximum maximum = strength_maximum(&curve, s, 0, 0, false);
    assert_true(maximum.reached);
    assert_near(maximum.strain, 0.15, 1e-15);
    assert_near(maximum.plateau, 0.1, 1e-15);
    const struct elastic_line none = {.slope = NAN};
    const double shares[] = {0.1, 0.001};
    for (int k = 0; k < 2; k++) {
        struct record record = record_judge(&curve, &none, shares[k]);
        long *rows;
        struct curve envelope = record_envelope(&record, &curve, &rows);
        assert_int_equal(envelope.n, k == 0 ? 5 : 7);
        assert_int_equal(record.broken, k == 0);
        curve_free(&envelope);
        free(rows);
        record_free(&record);
    }
    curve_free(&curve);
}

/* E = 200 GPa, yield at 700 MPa, a break before Rp0.2, and a machine's zero behind it that swings
 * up and down: no yield point, no loops and no proof strength are there. */
static void nothing_behind_the_fracture(void **state)
{
    (void)state;
    enum { ELASTIC = 70, BREAK = 90, N = 190 };
    struct curve curve = curve_new(N, "broken");
    for (long i = 0; i < N; i++) {
        curve.strain[i] = 5e-5 * (double)i;
        curve.stress[i] = i <= ELASTIC ? young * curve.strain[i]
                          : i <= BREAK ? 700e6 + 1e9 * 5e-5 * (double)(i - ELASTIC)
                                       : 2e6 * sin(0.7 * (double)i);
    }
    for (int k = 0; k < 4; k++) {
        struct choices choices = choices_read(NULL);
        curve.measured = k % 2;
        /* The fall over three rows, which the line of Rp0.2 meets at 509 MPa. */
        if (k == 2)
            for (long i = 1; i < 4; i++) curve.stress[BREAK + i] = 701e6 - 2e8 * (double)i;
        struct analysis found = analysis_make(&curve, &choices, true);
        struct properties list = analysis_report(&curve, &found, &choices, true);
        static const char *const blanks[] = {"proof_strength_0.2", "proof_strength_1.0",
                                             "upper_yield_strength", "lower_yield_strength",
                                             "total_extension_strength_0.5"};
        for (size_t b = 0; b < sizeof blanks / sizeof *blanks; b++)
            assert_true(isnan(property_value(&list, blanks[b])));
        assert_string_equal(property_of(&list, "proof_strength_0.2")->flag, "broke_before");
        assert_near(property_value(&list, "proof_strength_0.01"), 700.1, 0.01);
        assert_near(property_value(&list, "tensile_strength"), 701, 1e-9);
        assert_near(property_value(&list, "tensile_strength_reached"), 1, 0);
        /* Within a plateau of 1e-4 Rm, two rows. */
        assert_near(property_value(&list, "extension_at_maximum_force"), 0.45, 0.01);
        assert_near(property_value(&list, "extension_at_fracture"), k < 2 ? 0.45 : 0.465, 1e-6);
        assert_int_equal(found.record.count, 0);
        properties_free(&list);
        analysis_free(&found);
    }
    curve_free(&curve);
}

/* Whatever comes, there is an answer or a blank. */
static void poor_curves(void **state)
{
    (void)state;
    const double none[] = {0, 0, 0, 0, 0}, rising[] = {0, 1e-4, 2e-4, 3e-4, 4e-4};
    const double elastic[] = {0, 2e7, 4e7, 6e7, 8e7}, falling[] = {5e6, 4e6, 3e6, 2e6, -1e6};
    const struct {
        long n;
        const double *strain, *stress;
    } cases[] = {{1, none, none},    {1, rising + 1, elastic + 1}, {5, none, none},
                 {5, rising, none},  {5, rising, elastic},         {5, rising, falling},
                 {5, none, elastic}, {2, rising, elastic},         {5, falling, rising}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct curve curve = curve_of(cases[i].n, cases[i].strain, cases[i].stress);
        struct choices choices = choices_read(NULL);
        struct analysis found = analysis_make(&curve, &choices, true);
        struct properties list = analysis_report(&curve, &found, &choices, true);
        assert_true(list.count > 40);
        assert_true(isnan(property_value(&list, "proof_strength_0.2")));
        assert_true(isnan(property_value(&list, "considere_strain")));
        properties_free(&list);
        analysis_free(&found);
        curve_free(&curve);
    }
}

static struct hardening straight(double yield, double modulus)
{
    return (struct hardening){.law = hardening_fitted("linear"), .parameter = {yield, modulus}};
}

/* Two linear hardeners: each bound is a formula. */
static void mixtures(void **state)
{
    (void)state;
    const struct constituent pair[2] = {{straight(200e6, 1e9), 200e9},
                                        {straight(1200e6, 2e9), 200e9}};
    double fraction = 0.4, strain = 0.05;
    /* p + (Y + H p)/E = eps */
    double soft = (strain - 200e6 / 200e9) / (1 + 1e9 / 200e9);
    double hard = (strain - 1200e6 / 200e9) / (1 + 2e9 / 200e9);
    double voigt = 0.6 * (200e6 + 1e9 * soft) + 0.4 * (1200e6 + 2e9 * hard);
    assert_relative(mixture_voigt(pair, fraction, strain), voigt, 1e-12);
    /* The hard one stays elastic: eps = s/E + 0.6 (s - Y)/H. */
    double reuss = (strain + 0.6 * 200e6 / 1e9) / (1 / 200e9 + 0.6 / 1e9);
    assert_relative(mixture_reuss(pair, fraction, strain), reuss, 1e-12);
    /* Below first yield both are Hooke's law. */
    assert_relative(mixture_voigt(pair, fraction, 5e-4), 1e8, 1e-12);
    assert_relative(mixture_reuss(pair, fraction, 5e-4), 1e8, 1e-12);
    assert_relative(mixture_voigt(pair, 0, strain), constituent_stress(&pair[0], strain), 1e-12);
    assert_relative(mixture_reuss(pair, 1, strain), constituent_stress(&pair[1], strain), 1e-12);
}

static void differences(void **state)
{
    (void)state;
    const double e[] = {0, 0.01, 0.02, 0.03}, s[] = {0, 100e6, 200e6, 300e6};
    const double f[] = {0, 0.03}, t[] = {0, 330e6};
    struct curve reference = curve_of(4, e, s), curve = curve_of(2, f, t);
    const double open[2] = {NAN, NAN};
    struct difference found = difference_of(&curve, &reference, open);
    assert_int_equal(found.count, 3);
    /* Ten per cent everywhere, to rounding. */
    assert_near(found.largest, 0.1, 1e-14);
    assert_near(found.mean, 0.1, 1e-14);
    assert_near(found.root_mean_square, 0.1, 1e-14);
    curve_free(&curve);
    curve_free(&reference);
}

/* A soft phase yields far below Rp0.2, behind which the slope is 120 GPa for 210, and a hard one at
 * 790 MPa. */
static const double soft_slope = 210e9, soft_behind = 120e9;

struct soft {
    double yield, noise;
    bool measured;
    double within; /* the slope: the half that is steeper ends up to a tenth of it too far */
};

static struct curve soft_curve(const struct soft *soft)
{
    struct curve curve = curve_new(4000, "two phases");
    struct random_stream *stream = random_new(7, "noise");
    const double first = soft->yield / soft_slope,
                 second = first + (790e6 - soft->yield) / soft_behind;
    curve.measured = soft->measured;
    for (long i = 0; i < curve.n; i++) {
        const double e = curve.strain[i] = 0.02 * (double)i / (double)curve.n;
        curve.stress[i] = soft_slope * fmin(e, first) +
                          soft_behind * fmax(fmin(e, second) - first, 0) +
                          4e9 * fmax(e - second, 0) + soft->noise * random_gaussian(stream);
    }
    random_free(stream);
    return curve;
}

/* Rp0.2 is where soft_slope (e - 0.002) meets the slope behind the yield. */
static void slope_is_that_before_a_soft_phase_yields(void **state)
{
    (void)state;
    const struct soft cases[] = {{180e6, 0, false, 1e-9},
                                 {50e6, 0, false, 1e-9}, /* below a tenth of Rp0.2 */
                                 {180e6, 0, true, 0.03},
                                 {180e6, 1e6, true, 0.03},
                                 {130e6, 1e6, true, 0.03}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const double ratio = soft_behind / soft_slope, way = 0.002 * soft_slope,
                     proof = (cases[k].yield * (1 - ratio) + way) / (1 - ratio) - way;
        struct curve curve = soft_curve(&cases[k]);
        struct choices choices = choices_read(NULL);
        struct analysis found = analysis_make(&curve, &choices, false);
        assert_relative(found.measures.line.slope, soft_slope, cases[k].within);
        assert_string_equal(found.measures.line.flag, "straight_start");
        /* By the formula a slope that is 3 % off moves it by 4.3 %; rows are 5e-6 apart. */
        assert_relative(found.measures.value[MEASURE_PROOF_02], proof,
                        cases[k].measured ? 0.043 : 1e-4);
        analysis_free(&found);
        curve_free(&curve);
    }
}

/* A start with waves is no elastic slope, however straight. */
static void waves_are_no_straight_start(void **state)
{
    (void)state;
    struct curve curve = soft_curve(&(struct soft){180e6, 0, false, 0});
    double *kinetic = table_add(&curve.table, "kinetic_to_internal");
    for (long i = 0; i < curve.n; i++) kinetic[i] = 0.02;
    struct choices choices = choices_read(NULL);
    struct analysis found = analysis_make(&curve, &choices, false);
    assert_null(found.measures.line.flag);
    assert_true(found.measures.line.slope < 0.9 * soft_slope);
    analysis_free(&found);
    curve_free(&curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(law_comes_back),
        cmocka_unit_test(uniform_strain_in_closed_form),
        cmocka_unit_test(every_law_fits_itself),
        cmocka_unit_test(yield_point),
        cmocka_unit_test(transient_and_span),
        cmocka_unit_test(plateau_and_fracture),
        cmocka_unit_test(poor_curves),
        cmocka_unit_test(mixtures),
        cmocka_unit_test(differences),
        cmocka_unit_test(nothing_behind_the_fracture),
        cmocka_unit_test(slope_is_that_before_a_soft_phase_yields),
        cmocka_unit_test(waves_are_no_straight_start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
