/* The force derives from an energy: symmetric tangent, elastic and in plastic flow, of a body with
 * two phases and free surfaces; and it is the energy's gradient. */
#include "check.h"

#include "memory.h"
#include "small_body.h"

#include "random.h"

#include <stdlib.h>
#include <string.h>

static uint8_t chequers(const int size[3], const int at[3])
{
    (void)size;
    return (uint8_t)((at[0] / 2 + at[1] / 3 + at[2] / 2) % 2);
}

struct field {
    double *component[3];
};

static struct field field_new(const struct small_body *small, const char *purpose)
{
    struct field field;
    struct random_stream *stream = random_new(7, purpose);
    for (int a = 0; a < 3; a++) {
        field.component[a] = memory_new((size_t)small->body.grid.n_sites, sizeof(double));
        for (int64_t i = 0; i < small->body.grid.n_sites; i++)
            if (small_body_has(small, i))
                field.component[a][i] = SMALL_SPACING * (2 * random_uniform(stream) - 1);
    }
    random_free(stream);
    return field;
}

static void field_free(struct field *field)
{
    for (int a = 0; a < 3; a++) free(field->component[a]);
}

static void move(struct small_body *small, const struct field *field, double factor)
{
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < small->body.grid.n_sites; i++)
            small->body.u[a][i] += factor * field->component[a][i];
}

/* a . (f(u + h b) - f(u - h b))/2h */
static double second_derivative(struct small_body *small, const struct field *a,
                                const struct field *b, double h, bool frozen)
{
    double product[2];
    for (int side = 0; side < 2; side++) {
        const double way = side ? -h : h;
        move(small, b, way);
        small_body_force(small, false, frozen);
        product[side] = small_body_product(small, a->component, small->body.f);
        move(small, b, -way);
    }
    return (product[0] - product[1]) / (2 * h);
}

static void check_symmetry(struct small_body *small, double h, bool frozen, double tolerance)
{
    struct field a = field_new(small, "first"), b = field_new(small, "second");
    double ab = second_derivative(small, &a, &b, h, frozen);
    double ba = second_derivative(small, &b, &a, h, frozen);
    double aa = second_derivative(small, &a, &a, h, frozen);
    /* a . K b of two random fields is small against the rounding of a . K a */
    assert_near(ab, ba, tolerance * fabs(aa));
    assert_true(fabs(ab) > 100 * tolerance * fabs(aa)); /* and yet not all noise */
    assert_true(aa < 0);
    field_free(&a);
    field_free(&b);
}

static void body_of(struct small_body *small, const char *stabilisation, double horizon,
                    int influence)
{
    small_body_new(small, &(struct small_case){{9, 8, 7},
                                               horizon,
                                               influence,
                                               stabilisation,
                                               small_two_phases,
                                               .n_phases = 2,
                                               .phase = chequers});
}

static const double stretch[9] = {0.02, 0.004, 0, 0, -0.009, 0.002, 0, 0, -0.0095};
static const double more[9] = {0.021, 0.0042, 0, 0, -0.00945, 0.0021, 0, 0, -0.00998};

static void test_elastic_tangent(void **state)
{
    (void)state;
    const char *laws[] = {small_mix, small_capped};
    for (int horizon = 1; horizon <= 3; horizon++)
        for (int law = 0; law < 2; law++) {
            struct small_body small;
            body_of(&small, laws[law], horizon, law);
            small_body_deform(&small, stretch);
            /* steps of 1e-5 in strain: differences exact to 1e-10, rounding 1e-16/1e-5 */
            check_symmetry(&small, 1e-5, true, 1e-8);
            small_body_free(&small);
        }
}

/* Every point loads: a step of 0.1 % beyond a state that has flowed by 2 %; the perturbations of
 * 1e-6 turn none of them back. */
static void test_tangent_in_plastic_flow(void **state)
{
    (void)state;
    const char *laws[] = {small_mix, small_capped};
    for (int horizon = 1; horizon <= 3; horizon++)
        for (int law = 0; law < 2; law++) {
            struct small_body small;
            double range[2];
            body_of(&small, laws[law], horizon, 0);
            small_body_deform(&small, stretch);
            small_body_force(&small, true, false);
            small_body_plastic_range(&small, range);
            assert_true(range[0] > 0.01);
            small_body_deform(&small, more);
            check_symmetry(&small, 1e-6, false, 1e-7); /* third differences; rounding 1e-16/1e-6 */
            small_body_free(&small);
        }
}

/* Bonds beyond their cap: a noise of 0.1 % of the spacing, some twenty caps. */
static void test_tangent_of_slipping_bonds(void **state)
{
    (void)state;
    struct small_body small;
    body_of(&small, small_capped, 1, 0);
    small_body_deform(&small, stretch);
    small_body_force(&small, true, false);
    small_body_deform(&small, more);
    small_body_shake(&small, 1e-3, 3);
    /* the kinks of the bonds and points that change branch within the step */
    check_symmetry(&small, 1e-8, false, 1e-5);
    small_body_free(&small);
}

/* V f . a = -(Pi(u + h a) - Pi(u - h a))/2h at finite elastic strain. */
static void test_force_is_the_gradient_of_the_energy(void **state)
{
    (void)state;
    const char *laws[] = {small_mix, small_capped};
    const double h = 1e-5;
    for (int horizon = 1; horizon <= 3; horizon++)
        for (int law = 0; law < 2; law++) {
            struct small_body small;
            body_of(&small, laws[law], horizon, 0);
            small_body_deform(&small, stretch);
            small_body_shake(&small, 0.01, 5);
            struct field a = field_new(&small, "way");
            small_body_force(&small, false, true);
            double force =
                small.body.volume * small_body_product(&small, a.component, small.body.f);
            move(&small, &a, h);
            double above = small_body_elastic_energy(&small);
            move(&small, &a, -2 * h);
            double below = small_body_elastic_energy(&small);
            move(&small, &a, h);
            /* third derivative times h^2, relative to the second: 1e-8 of a . K a h = some 1e-7 */
            assert_relative(-(above - below) / (2 * h), force, 1e-6);
            field_free(&a);
            small_body_free(&small);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_elastic_tangent),
        cmocka_unit_test(test_tangent_in_plastic_flow),
        cmocka_unit_test(test_tangent_of_slipping_bonds),
        cmocka_unit_test(test_force_is_the_gradient_of_the_energy),
    };
    return cmocka_run_group_tests_name("tangent", tests, small_ranks_start, small_ranks_stop);
}
