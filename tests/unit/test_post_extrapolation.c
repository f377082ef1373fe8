/* Extrapolation over the resolution: values whose limit and order are known. */
#include "check.h"
#include "sensitivity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* f = limit + c h^p at the spacings given. */
static void fill(const double spacing[], int count, double limit, double order, double values[])
{
    for (int i = 0; i < count; i++) values[i] = limit + 7 * pow(spacing[i], order);
}

static void an_order_comes_back(void **state)
{
    (void)state;
    /* Ratios that are not all the same, as of 25, 12.5 and 8.33 um. */
    const double spacing[] = {1.0 / 3, 0.5, 1};
    for (double order = 0.75; order < 3; order += 0.25) {
        double values[3];
        fill(spacing, 3, 100, order, values);
        const struct limit limit = limit_of(spacing, values, 3, 1);
        assert_true(limit.observed);
        /* Round off of values of 100: 1e-14 over differences of 0.1 at least. */
        assert_near(limit.order, order, 1e-10);
        assert_near(limit.value, 100, 1e-10);
        assert_near(limit.band, 1.25 * 7 * pow(spacing[0], order), 1e-9);
    }
}

/* The worked example of the NPARC alliance's tutorial on grid convergence, three grids of pressure
 * recovery: order 1.78618479, limit 0.971300304, index of the finest grid 0.103080 % of its value.
 * Its program has single precision: 6e-8 of values whose differences are 2e-3 is 3e-5 of these, of
 * the order and of the index. */
static void a_published_example(void **state)
{
    (void)state;
    const double spacing[] = {1, 2, 4}, values[] = {0.97050, 0.96854, 0.96178};
    const struct limit limit = limit_of(spacing, values, 3, 2);
    assert_true(limit.observed);
    assert_near(limit.order, 1.78618479, 3e-5);
    assert_near(limit.value, 0.971300304, 1e-7);
    assert_near(100 * limit.band / values[0], 0.103080, 1e-5);
}

static void two_spacings_take_the_order_given(void **state)
{
    (void)state;
    const double spacing[] = {1, 2}, values[] = {11, 14};
    const struct limit first = limit_of(spacing, values, 2, 1),
                       second = limit_of(spacing, values, 2, 2);
    assert_false(first.observed);
    assert_near(first.value, 8, 1e-12);
    assert_near(first.band, 9, 1e-12);
    assert_near(second.value, 10, 1e-12);
    assert_near(second.band, 3, 1e-12);
}

static void values_without_an_order_take_the_one_given(void **state)
{
    (void)state;
    const double spacing[] = {1, 2, 4};
    const double back_and_forth[] = {10, 11, 9}, too_slow[] = {10, 11, 12},
                 too_fast[] = {10, 11, 30};
    const double *const all[] = {back_and_forth, too_slow, too_fast};
    for (int i = 0; i < 3; i++) {
        const struct limit limit = limit_of(spacing, all[i], 3, 1);
        assert_false(limit.observed);
        assert_near(limit.order, 1, 0);
        assert_near(limit.value, 9, 1e-12);
        assert_near(limit.band, 3, 1e-12);
    }
}

static void one_spacing_has_no_limit(void **state)
{
    (void)state;
    const double spacing[] = {1}, values[] = {10};
    assert_true(isnan(limit_of(spacing, values, 1, 1).value));
}

/* Seeds 1 to 3 as they are, 100, 121 and 140, and changed, where 2 failed, 103 and 147: a change of
 * (3 + 7)/2 with the deviation 4/sqrt(2), however far the seeds lie apart.  Of all seeds it would
 * be 4.67. */
static void changes_are_of_the_same_seeds(void **state)
{
    (void)state;
    enum { COUNT = 5 };
    static const double values[COUNT] = {100, 121, 140, 103, 147};
    static const char *const seeds[COUNT] = {"1", "2", "3", "1", "3"};
    char *words[2][2] = {{"none", "seed"}, {"horizon 2", "seed"}};
    struct varied_item items[COUNT][2];
    struct label labels[COUNT];
    struct properties lists[COUNT] = {0};
    for (int k = 0; k < COUNT; k++) {
        const bool changed = k > 2;
        items[k][0] = (struct varied_item){"sensitivity", words[changed][0], VARIED_SENSITIVITY};
        items[k][1] = (struct varied_item){"seed", (char *)seeds[k], VARIED_SCATTER};
        labels[k] = (struct label){.title = changed ? "B" : "A",
                                   .file = "file",
                                   .varied = (char *)seeds[k],
                                   .values = {2, items[k]}};
        properties_add(&lists[k], "strength", "R", values[k], "MPa", NAN, "none");
    }
    const struct group groups[] = {{.title = "A", .first = 0}, {.title = "B", .first = 3}};
    char *text;
    size_t length;
    FILE *file = open_memstream(&text, &length);
    sensitivities_write(file, NULL, 0, groups, 2, lists, labels, COUNT, 1);
    fclose(file);
    char *unchanged = strstr(text, "\nA,strength,R,MPa,none,"), *row = strstr(text, ",horizon 2,");
    assert_non_null(unchanged);
    assert_non_null(row);
    double value, change, percent, deviation, deviation_of_change;
    int curves, left_out;
    assert_int_equal(sscanf(row, ",horizon 2,%lf,%lf,%lf,,%lf,%lf,%d,%d", &value, &change, &percent,
                            &deviation, &deviation_of_change, &curves, &left_out),
                     7);
    assert_near(value, 125, 1e-9);
    assert_near(change, 5, 1e-9);
    assert_near(percent, 100 * 5.0 / 120, 1e-9);
    assert_near(deviation, 44 / sqrt(2), 1e-9);
    assert_near(deviation_of_change, 4 / sqrt(2), 1e-9);
    assert_int_equal(curves, 2);
    assert_int_equal(left_out, 1);
    assert_int_equal(
        sscanf(unchanged, "\nA,strength,R,MPa,none,%lf,,,,%lf,,%d", &value, &deviation, &curves),
        3);
    assert_near(value, 361.0 / 3, 1e-9);
    assert_int_equal(curves, 3);
    free(text);
    for (int k = 0; k < COUNT; k++) properties_free(&lists[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_order_comes_back),
        cmocka_unit_test(a_published_example),
        cmocka_unit_test(two_spacings_take_the_order_given),
        cmocka_unit_test(values_without_an_order_take_the_one_given),
        cmocka_unit_test(one_spacing_has_no_limit),
        cmocka_unit_test(changes_are_of_the_same_seeds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
