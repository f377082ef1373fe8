/* The waves of an axis against the chain of springs that they diagonalise, by matrix and by FFTW. */
#include "check.h"
#include "memory.h"
#include "waves.h"

#include <math.h>
#include <stdlib.h>

/* Force of a chain of springs on node j: walls half a spacing beyond the ends of particles (of opposite motion, or of
 * the same where they are free), a whole one beyond held corners; free corners have one spring. */
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

/* C^T K C = diag(2 - 2 cos k) for inner numbers a node, one wave after the other: rounding of single precision, 1e-7, in sums
 * of n terms that grow as sqrt(n): 3e-6 from n = 600 down. */
static void check_axis(int n, int inner, bool corners, bool low, bool high)
{
    struct waves *waves = waves_new(n, inner, corners, low, high);
    const size_t count = (size_t)(n * inner);
    float *values = memory_new(count, sizeof *values), *room = memory_new(count, sizeof *room);
    double *u = memory_new((size_t)n, sizeof *u);
    for (int k = 0; k<n; k += n> 20 ? 29 : 1) {
        for (size_t i = 0; i < count; i++) values[i] = 0;
        for (int i = 0; i < inner; i++) values[k * inner + i] = (float)(1 + i);
        float *out = waves_transform(waves, true, 1, values, room);
        float *other = out == values ? room : values;
        for (int i = 0; i < inner; i++) {
            for (int j = 0; j < n; j++) u[j] = out[j * inner + i];
            for (int j = 0; j < n; j++)
                out[j * inner + i] = (float)chain(u, n, j, corners, low, high);
        }
        float *back = waves_transform(waves, false, 1, out, other);
        const double stiffness = 2 - 2 * cos(waves_number(waves, k));
        for (int m = 0; m < n; m++)
            for (int i = 0; i < inner; i++)
                assert_near(back[m * inner + i], m == k ? stiffness * (1 + i) : 0, 3e-6 * (1 + i));
    }
    free(u);
    free(values);
    free(room);
    waves_free(waves);
}

static void test_waves_diagonalise_a_chain(void **state)
{
    static const int sizes[] = {2, 3, 17, 64, 600};
    (void)state;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (int ends = 0; ends < 8; ends++)
            for (int inner = 1; inner <= 3; inner += 2)
                check_axis(sizes[s], inner, ends & 1, ends & 2, ends & 4);
}

/* Across the one layer of a plane. */
static void test_one_node(void **state)
{
    (void)state;
    check_axis(1, 2, false, false, false);
    check_axis(1, 1, true, true, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_waves_diagonalise_a_chain),
                                       cmocka_unit_test(test_one_node)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
