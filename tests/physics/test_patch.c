/* Patch test with free surfaces: a bar in uniform uniaxial stress is in equilibrium at every node,
 * faces, edges and corners of the section included, and the grips carry stress times section. */
#include "check.h"

#include "small_body.h"

/* Sections with re-entrant corners: an angle, and a tube. */
static uint8_t angle(const int size[3], const int at[3])
{
    return at[1] > size[1] / 2 && at[2] > size[2] / 2 ? ABSENT : 0;
}
static uint8_t tube(const int size[3], const int at[3])
{
    bool hollow = at[1] > 1 && at[1] < size[1] - 2 && at[2] > 1 && at[2] < size[2] - 2;
    return hollow ? ABSENT : 0;
}
static uint8_t box(const int size[3], const int at[3])
{
    (void)size, (void)at;
    return 0;
}

/* Forces of the nodes that no end of the bar reaches, and the force of the left end on the rest. */
static void check_equilibrium(const struct small_body *small, double stress)
{
    /* force <- stress <- gradient, and one bond of the stabilisation between them */
    const int depth = 3 * small->family.reach + 1, length = small->lattice.size[0];
    double reaction = 0;
    int64_t section = 0;
    assert_true(length > 2 * depth + 1);
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        section += at[0] == 0;
        if (at[0] < length / 2) reaction += small->body.f[0][site] * small->body.volume;
        /* rounding: u of 30 spacings at 1e-16, a stiffness of E per spacing, E/stress up to 1e3 */
        for (int a = 0; a < 3 && at[0] >= depth && at[0] < length - depth; a++)
            assert_near(small->body.f[a][site] * SMALL_SPACING / stress, 0, 2e-10);
    }
    double area = (double)section * SMALL_SPACING * SMALL_SPACING;
    assert_relative(reaction, stress * area, 1e-10); /* the same rounding, averaged */
}

static void check_bar(double horizon, int influence, const char *stabilisation,
                      uint8_t (*section)(const int size[3], const int at[3]))
{
    const struct small_case bar = {{(int)(6 * horizon) + 8, 7, 6},
                                   horizon,
                                   influence,
                                   stabilisation,
                                   small_nickel,
                                   .phase = section};
    /* elastic, the first flow, and in large steps up to 25 % */
    static const double strains[] = {2e-4, 8e-4, 1.5e-3, 4e-3, 0.02, 0.06, 0.12, 0.18, 0.25};
    struct small_body small;
    small_body_new(&small, &bar);
    struct small_point point = small_point_new(&small.materials);
    for (int k = 0; k < 9; k++) {
        small_point_stretch(&point, &small.materials, strains[k]);
        small_body_deform(&small, point.H);
        small_body_force(&small, true, false);
        check_equilibrium(&small, point.stress);
    }
    assert_true(small_point_plastic(&point) > 0.2);
    double range[2];
    small_body_plastic_range(&small, range);
    assert_relative(range[0], small_point_plastic(&point), 1e-10);
    assert_relative(range[1], small_point_plastic(&point), 1e-10);
    small_body_free(&small);
}

static void test_box(void **state)
{
    (void)state;
    for (int horizon = 1; horizon <= 3; horizon++)
        for (int influence = 0; influence < 2; influence++) {
            check_bar(horizon, influence, small_mix, box);
            check_bar(horizon, influence, small_capped, box);
        }
}

static void test_angle_and_tube(void **state)
{
    (void)state;
    for (int horizon = 1; horizon <= 2; horizon++) {
        check_bar(horizon, 0, small_mix, angle);
        check_bar(horizon, 0, small_capped, angle);
        check_bar(horizon, 0, small_mix, tube);
        check_bar(horizon, 0, small_capped, tube);
    }
    check_bar(1, 0, "{law: mix, share: 1}", angle);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_box),
        cmocka_unit_test(test_angle_and_tube),
    };
    return cmocka_run_group_tests_name("patch", tests, small_ranks_start, small_ranks_stop);
}
