/* What the stress of J2 plasticity owes to mechanics: frames, volume, energy, and a state that is
 * written when the point flows and only then. */
#include "one_point.h"

static const char voce[] = "{law: voce, yield: 182.1 MPa, saturation: 513 MPa, rate: 5.32}";

/* c = a b */
static void multiply(const double a[9], const double b[9], double c[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            c[3 * i + j] = 0;
            for (int k = 0; k < 3; k++) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
        }
}

static void rotation(double angle, double R[9])
{
    const double n[3] = {2.0 / 7, -3.0 / 7, 6.0 / 7}, c = cos(angle), s = sin(angle);
    const double cross[9] = {0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
    for (int i = 0; i < 9; i++)
        R[i] = (i % 4 == 0) * c + (1 - c) * n[i / 3] * n[i % 3] + s * cross[i];
}

/* A path of general deformations; with turned != 0 each of them is followed by another rotation. */
static void general_path(struct point *point, double turned, double P[9])
{
    for (int n = 1; n <= 20; n++) {
        const double t = n / 20.0;
        const double F[9] = {1 + 0.05 * t, 0.06 * t * t, 0.01 * t,
                             -0.03 * t,    1 - 0.03 * t, 0.02 * sin(5 * t),
                             0.04 * t,     -0.01 * t,    1 - 0.02 * t * t};
        double R[9], RF[9], back[9], unturned[9];
        rotation(turned * n, R);
        multiply(R, F, RF);
        for (int k = 0; k < 9; k++) RF[k] -= k % 4 == 0;
        deform(point, RF, true);
        for (int k = 0; k < 9; k++) {
            back[k] = R[3 * (k % 3) + k / 3];
            unturned[k] = point->strip.P[k][0];
        }
        multiply(back, unturned, P);
    }
}

/* F -> R F gives P -> R P and the same state, with another rotation in each step. */
static void test_turns_with_the_frame(void **state)
{
    (void)state;
    struct point still, turned;
    double P[9], Q[9];
    point_new(&still, voce, 210e9, 0.31);
    point_new(&turned, voce, 210e9, 0.31);
    general_path(&still, 0, P);
    general_path(&turned, 0.7, Q);
    assert_true(still.state[6] > 0.05);
    /* E times the rounding of 20 steps' strains */
    for (int k = 0; k < 9; k++) assert_near(Q[k], P[k], 1e-14 * 210e9);
    for (int k = 0; k <= J2_PLASTIC; k++) assert_near(turned.state[k], still.state[k], 1e-13);
    point_free(&still);
    point_free(&turned);
}

/* Plastic flow keeps the volume: det Cp = 1. */
static void test_flow_keeps_the_volume(void **state)
{
    (void)state;
    struct point point;
    double P[9];
    point_new(&point, voce, 210e9, 0.31);
    general_path(&point, 0.3, P);
    const double *C = point.state;
    double determinant = C[0] * (C[1] * C[2] - C[4] * C[4]) - C[3] * (C[3] * C[2] - C[4] * C[5]) +
                         C[5] * (C[3] * C[4] - C[1] * C[5]);
    assert_near(determinant, 1, 1e-10); /* 20 steps of the series for strains of 1 %: 1e-12 each */
    point_free(&point);
}

/* P = d psi/dF by differences of the stored energy, elastic at 5 % of strain. */
static void test_stress_is_the_gradient_of_the_energy(void **state)
{
    (void)state;
    struct point point;
    const double H[9] = {0.05, 0.02, -0.01, 0.03, -0.02, 0.01, 0.02, -0.03, 0.01}, h = 1e-5;
    point_new(&point, "{law: linear, yield: 1000 GPa, modulus: 0}", 210e9, 0.31);
    deform(&point, H, false);
    double P[9];
    for (int k = 0; k < 9; k++) P[k] = point.strip.P[k][0];
    for (int k = 0; k < 9; k++) {
        double side[2];
        for (int s = 0; s < 2; s++) {
            double moved[9];
            memcpy(moved, H, sizeof moved);
            moved[k] += s ? -h : h;
            deform(&point, moved, false);
            side[s] = point.strip.stored[0];
        }
        /* third derivative ~ 10 E times h^2; rounding 1e-16 of the energy over h */
        assert_near((side[0] - side[1]) / (2 * h), P[k], 1e-8 * 210e9);
    }
    point_free(&point);
}

/* A point that does not flow keeps its state to the last bit; nothing is written without commit. */
static void test_state_is_kept(void **state)
{
    (void)state;
    struct point point;
    double before[J2_STATE];
    point_new(&point, voce, 210e9, 0.31);
    stretch(&point, 1.01);
    memcpy(before, point.state, sizeof before);
    deform(&point, (const double[9]){0.02}, false);
    assert_memory_equal(before, point.state, sizeof before);
    stretch(&point, 1.0095); /* unloads */
    assert_memory_equal(before, point.state, sizeof before);
    point_free(&point);
}

/* stored + plastic energy = work of the stress along the path, in steps of 1e-4 by the trapezoidal
 * rule: error (1e-4)^2 of the curvature, 1e-6 at first yield. */
static void test_work_is_stored_or_plastic(void **state)
{
    (void)state;
    struct point point;
    point_new(&point, voce, 210e9, 0.31);
    double work = 0, before = 0;
    for (int n = 1; n <= 500; n++) {
        stretch(&point, 1 + 1e-4 * n);
        work += 0.5 * (before + point.strip.P[0][0]) * 1e-4;
        before = point.strip.P[0][0];
    }
    assert_relative(point.strip.stored[0] + point.strip.dissipated[0], work, 1e-5);
    assert_true(point.strip.dissipated[0] > 0.01 * point.strip.stored[0]);
    point_free(&point);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_turns_with_the_frame),
        cmocka_unit_test(test_flow_keeps_the_volume),
        cmocka_unit_test(test_stress_is_the_gradient_of_the_energy),
        cmocka_unit_test(test_state_is_kept),
        cmocka_unit_test(test_work_is_stored_or_plastic),
    };
    return cmocka_run_group_tests_name("j2, mechanics", tests, NULL, NULL);
}
