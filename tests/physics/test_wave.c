/* A pulse runs along a thin bar with the speed sqrt(E/rho). */
#include "check.h"

#include "small_body.h"
#include "verlet.h"

/* The bar is struck at its left end: v = exp(-(x/width)^2), at rest in place.  Half of the motion's
 * even continuation runs to the right. */
static void strike(struct small_body *small, double width)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        small->body.v[0][site] = 1e-3 * exp(-pow((at[0] + 0.5) / width, 2));
    }
}

/* Where the pulse is: mean x of the kinetic energy [m]. */
static double centre_of(const struct small_body *small)
{
    double sum = 0, moment = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        double v = small->body.v[0][site];
        sum += v * v;
        moment += v * v * at[0] * SMALL_SPACING;
    }
    return moment / sum;
}

/* Speed over sqrt(E/rho), less one.  width of the pulse in spacings. */
static double speed_error(const char *stabilisation, double horizon, int width)
{
    struct small_body small;
    struct boundary nothing = small_free_boundary();
    const int length = 12 * width;
    small_body_new(&small,
                   &(struct small_case){
                       {length, 3, 3}, horizon, 0, stabilisation, small_elastic, .n_phases = 1});
    const struct material *nickel = &small.materials.items[0];
    const double exact = sqrt(nickel->youngs_modulus / nickel->density);
    const double dt = 2.5e-9, first = 3 * width * SMALL_SPACING / exact,
                 second = 8 * width * SMALL_SPACING / exact;
    strike(&small, width);
    struct integration integration =
        integration_new(true, dt, 0, &small.materials, &small.body, &nothing, small.model);
    while (integration.time < first)
        verlet_step(&integration, &small.body, &nothing, small.model, true, false);
    const double start = integration.time, from = centre_of(&small);
    while (integration.time < second)
        verlet_step(&integration, &small.body, &nothing, small.model, true, false);
    double speed = (centre_of(&small) - from) / (integration.time - start);
    integration_free(&integration);
    boundary_free(&nothing);
    small_body_free(&small);
    return speed / exact - 1;
}

/* A lattice wave of wave number k is slower by (k spacing)^2 c: gradients over two spacings (and
 * more at a wider horizon), and the bar's lateral inertia.  So the error falls as the square of the
 * pulse's width: to a quarter, within a tenth of that for the next order; at 12 spacings it is
 * below 0.5 % at horizon 1 and 1 % at 2. */
static void test_speed(void **state)
{
    (void)state;
    const char *laws[] = {small_mix, small_capped};
    for (int law = 0; law < 2; law++)
        for (int horizon = 1; horizon <= 2; horizon++) {
            double coarse = speed_error(laws[law], horizon, 6);
            double fine = speed_error(laws[law], horizon, 12);
            assert_near(fine, 0, 0.005 * horizon);
            assert_relative(fine, coarse / 4, 0.1);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_speed),
    };
    return cmocka_run_group_tests_name("wave", tests, small_ranks_start, small_ranks_stop);
}
