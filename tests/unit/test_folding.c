/* Products with folded matrices against those with the matrices themselves. */
#include "check.h"
#include "folding.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

/* Single precision, 6e-8, of sums of n terms of up to 1, whose rounding grows as their root. */
static void check_product(int rows, int columns, const double *matrix, int64_t most)
{
    struct folding *folding = folding_new(rows, columns, matrix);
    float(*in)[FOLDING_WIDTH] = memory_new((size_t)columns, sizeof *in),
    (*copy)[FOLDING_WIDTH] = memory_new((size_t)columns, sizeof *copy),
    (*out)[FOLDING_WIDTH] = memory_new((size_t)rows, sizeof *out);
    for (int j = 0; j < columns; j++)
        for (int l = 0; l < FOLDING_WIDTH; l++)
            in[j][l] = copy[j][l] = (float)sin(FOLDING_WIDTH * j + l);
    folding_multiply(folding, in, out);
    for (int k = 0; k < rows; k++)
        for (int l = 0; l < FOLDING_WIDTH; l++) {
            double sum = 0;
            for (int j = 0; j < columns; j++) sum += matrix[k * columns + j] * copy[j][l];
            assert_near(out[k][l], sum, 5e-7 * columns);
        }
    assert_true(folding_cost(folding) <= most);
    free(in);
    free(copy);
    free(out);
    folding_free(folding);
}

static void fill(int rows, int columns, double (*number)(int, int, int), double *matrix)
{
    for (int k = 0; k < rows; k++)
        for (int j = 0; j < columns; j++) matrix[k * columns + j] = number(k, j, columns);
}

static double none(int k, int j, int n)
{
    return sin(1 + 3 * k + 7 * n * j);
}
static double cosine(int k, int j, int n)
{
    return cos(M_PI * k * j / (n - 1));
}
static double half_sine(int k, int j, int n)
{
    return sin(M_PI * (k + 0.5) * (j + 1) / n);
}
/* The whole spectrum of a ring: cosines, then sines. */
static double ring(int k, int j, int n)
{
    const double phase = 2 * M_PI * (k <= n / 2 ? k : k - n / 2) * j / n;
    return k <= n / 2 ? cos(phase) : sin(phase);
}

static void test_products(void **state)
{
    (void)state;
    double *matrix = memory_new(130 * 130, sizeof *matrix);
    fill(3, 5, none, matrix);
    check_product(3, 5, matrix, 15);
    fill(31, 29, none, matrix);
    check_product(31, 29, matrix, 31 * 29);
    /* Halves of halves: n^2/9, and what is too short to be folded on. */
    fill(129, 129, cosine, matrix);
    check_product(129, 129, matrix, 129 * 129 / 7);
    fill(96, 96, half_sine, matrix);
    check_product(96, 96, matrix, 96 * 96 * 2 / 5);
    for (int n = 1; n <= 64; n++) {
        fill(n, n, ring, matrix);
        check_product(n, n, matrix, n < 24 ? (int64_t)n * n : (int64_t)n * n * 3 / 4);
        fill(n, n, half_sine, matrix);
        check_product(n, n, matrix, (int64_t)n * n);
    }
    free(matrix);
}

/* Whatever stands beside a vector, and is no number. */
static void test_lanes_do_not_meet(void **state)
{
    (void)state;
    enum { N = 33 };
    double matrix[N * N];
    float values[2][N][FOLDING_WIDTH] __attribute__((aligned(64))),
        out[2][N][FOLDING_WIDTH] __attribute__((aligned(64)));
    fill(N, N, cosine, matrix);
    struct folding *folding = folding_new(N, N, matrix);
    for (int j = 0; j < N; j++)
        for (int l = 0; l < FOLDING_WIDTH; l++)
            for (int with = 0; with < 2; with++)
                values[with][j][l] = l == 5 ? (float)cos(j) : with ? NAN : 0;
    for (int with = 0; with < 2; with++) folding_multiply(folding, values[with], out[with]);
    for (int k = 0; k < N; k++) assert_true(out[0][k][5] == out[1][k][5]);
    folding_free(folding);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_products),
                                       cmocka_unit_test(test_lanes_do_not_meet)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
