/* Extrapolation over the resolution: values whose limit and order are known. */
#include "check.h"
#include "extrapolation.h"

#include <math.h>

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_order_comes_back),
        cmocka_unit_test(a_published_example),
        cmocka_unit_test(two_spacings_take_the_order_given),
        cmocka_unit_test(values_without_an_order_take_the_one_given),
        cmocka_unit_test(one_spacing_has_no_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
