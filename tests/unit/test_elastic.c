/* Hencky's law against its closed form in principal axes, far beyond metals' strains. */
#include "check.h"
#include "laws.h"

#include <math.h>

static const double mu = 80e9, bulk = 170e9;

static void rotation(double angle, int axis, double R[3][3])
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) R[i][j] = i == j;
    R[a][a] = R[b][b] = cos(angle);
    R[a][b] = -sin(angle);
    R[b][a] = sin(angle);
}

static void multiply(double A[3][3], double B[3][3], double AB[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            AB[i][j] = 0;
            for (int k = 0; k < 3; k++) AB[i][j] += A[i][k] * B[k][j];
        }
}

/* F = Q diag(l) R, P = Q diag(t/l) R with t = 2 mu (ln l - mean) + K sum ln l.  The series promises
 * 1e-10 of the strain; P of one axis is divided by its stretch, five times as large at a fifth. */
static void check_stretches(const double stretch[3])
{
    double turn[3][3], tilt[3][3], Q[3][3], R[3][3], sum = 0, energy;
    struct points points = {.count = 1, .mu = {mu}, .bulk = {bulk}};
    rotation(0.7, 0, turn);
    rotation(-1.1, 2, tilt);
    multiply(turn, tilt, Q);
    rotation(0.4, 1, turn);
    multiply(tilt, turn, R);
    for (int k = 0; k < 3; k++) sum += log(stretch[k]);
    energy = 0.5 * bulk * sum * sum;
    for (int k = 0; k < 3; k++) energy += mu * pow(log(stretch[k]) - sum / 3, 2);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points.H[3 * i + j][0] = i == j ? -1 : 0;
            for (int k = 0; k < 3; k++) points.H[3 * i + j][0] += Q[i][k] * stretch[k] * R[k][j];
        }
    law_elastic.update(NULL, &points, NULL, 1, (struct step){.energy = true});
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double P = 0;
            for (int k = 0; k < 3; k++)
                P += Q[i][k] * R[k][j] * (2 * mu * (log(stretch[k]) - sum / 3) + bulk * sum) /
                     stretch[k];
            assert_near(points.P[3 * i + j][0], P, 1e-9 * bulk);
        }
    assert_near(points.stored[0], energy, 1e-9 * energy);
}

static void test_closed_form(void **state)
{
    (void)state;
    check_stretches((const double[]){1.05, 0.99, 0.97});
    check_stretches((const double[]){1.12, 0.99, 0.97});
    check_stretches((const double[]){1.5, 0.8, 0.9});
    check_stretches((const double[]){3, 0.6, 0.6});
    check_stretches((const double[]){5, 0.5, 0.2});
    check_stretches((const double[]){2, 2, 2});
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_closed_form)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
