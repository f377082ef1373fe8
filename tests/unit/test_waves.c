/* The waves of an axis against the chain of springs that they diagonalise, by folded matrices and
 * by FFTW. */
#include "check.h"
#include "memory.h"
#include "waves.h"

#include <math.h>
#include <stdlib.h>

/* Force of a chain of springs on node j: walls half a spacing beyond the ends of particles (of
 * opposite motion, or of the same where they are free), a whole one beyond held corners; free
 * corners have one spring. */
static double chain(const double *u, int n, int j, bool corners, bool low, bool high)
{
    const double below = j > 0 ? u[j - 1]
                         : low ? (corners ? 0 : -u[j])
                               : u[j],
                 above = j < n - 1 ? u[j + 1]
                         : high    ? (corners ? 0 : -u[j])
                                   : u[j];
    return 2 * u[j] - below - above;
}

/* C^T K C = diag(2 - 2 cos k) for all lines at once, one wave after the other: rounding of single
 * precision, 6e-8 there and back, of a stiffness of up to 4, in sums of n terms, that grows as
 * their root. */
static void check_axis(int n, bool corners, bool low, bool high)
{
    struct waves *waves = waves_new(n, corners, low, high);
    float(*values)[WAVES_WIDTH] = memory_new((size_t)n, sizeof *values),
    (*other)[WAVES_WIDTH] = memory_new((size_t)n, sizeof *other);
    double *u = memory_new((size_t)n, sizeof *u);
    for (int k = 0; k<n; k += n> 20 ? 29 : 1) {
        for (int j = 0; j < n; j++)
            for (int i = 0; i < WAVES_WIDTH; i++) values[j][i] = j == k ? (float)(1 + i) : 0;
        waves_transform(waves, true, values, other);
        for (int i = 0; i < WAVES_WIDTH; i++) {
            for (int j = 0; j < n; j++) u[j] = other[j][i];
            for (int j = 0; j < n; j++) values[j][i] = (float)chain(u, n, j, corners, low, high);
        }
        waves_transform(waves, false, values, other);
        const double stiffness = 2 - 2 * cos(waves_number(waves, k));
        for (int m = 0; m < n; m++)
            for (int i = 0; i < WAVES_WIDTH; i++)
                assert_near(other[m][i], m == k ? stiffness * (1 + i) : 0,
                            4 * 1.2e-7 * (3 + sqrt(n)) * (1 + i));
    }
    free(u);
    free(values);
    free(other);
    waves_free(waves);
}

static void test_waves_diagonalise_a_chain(void **state)
{
    /* Axes of which the halves of the matrix have symmetries of their own, or none; long ones are
     * FFTW's. */
    static const int sizes[] = {2, 3, 17, 64, 65, 97, 2100};
    (void)state;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (int ends = 0; ends < 8; ends++) check_axis(sizes[s], ends & 1, ends & 2, ends & 4);
}

/* Across the one layer of a plane. */
static void test_one_node(void **state)
{
    (void)state;
    check_axis(1, false, false, false);
    check_axis(1, true, true, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_waves_diagonalise_a_chain),
                                       cmocka_unit_test(test_one_node)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
