/* Sums that do not depend on the order or grouping of their terms, to the last bit. */
#include "check.h"
#include "small_ranks.h"

#include "exact_sum.h"
#include "memory.h"
#include "random.h"

#include <stdlib.h>

enum { N = 1 << 20 };

static void shuffle(double *terms, long seed)
{
    struct random_stream *stream = random_new(seed, "shuffle");
    for (uint64_t i = N - 1; i > 0; i--) {
        uint64_t j = random_integer(stream, i + 1);
        double spare = terms[i];
        terms[i] = terms[j];
        terms[j] = spare;
    }
    random_free(stream);
}

/* From [0, 1), with all 53 bits in use. */
static double random_full(struct random_stream *stream)
{
    return random_uniform(stream) + 0x1p-31 * random_uniform(stream);
}

/* The terms in two parts, as two ranks would hold them. */
static double sum_in_parts(const double *terms, double bound, int first)
{
    struct exact_sum parts[2] = {exact_sum_new(bound), exact_sum_new(bound)};
    exact_sum_add_strip(&parts[0], first, terms, 1);
    for (int i = first; i < N; i++) exact_sum_add(&parts[1], terms[i]);
    parts[0].top += parts[1].top;
    parts[0].bottom += parts[1].bottom;
    double value;
    exact_sum_finish(parts, 1, &value);
    return value;
}

/* Neumaier's compensated sum (1974) in long double: an error below 1e-30 of the bound. */
static double reference(const double *terms)
{
    long double sum = 0, lost = 0;
    for (int i = 0; i < N; i++) {
        long double term = (long double)terms[i], next = sum + term;
        lost += fabsl(sum) >= fabsl(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    return (double)(sum + lost);
}

static void check_orders(double *terms)
{
    double bound = 0;
    for (int i = 0; i < N; i++) bound += fabs(terms[i]);
    bound *= 1 + 1e-9; /* its own rounding */
    const double value = sum_in_parts(terms, bound, N / 2);
    /* the last addition's rounding, and 2^-75 of the bound from each term, half the second grid */
    assert_near(value, reference(terms), 3e-16 * fabs(value) + N * 0x1p-75 * bound);
    static const int cuts[] = {0, 1, 777, N / 3, N - 64, N};
    for (int k = 0; k < 6; k++) {
        shuffle(terms, k);
        assert_true(sum_in_parts(terms, bound, cuts[k]) == value);
    }
}

static void test_random_terms_of_many_sizes(void **state)
{
    (void)state;
    double *terms = memory_new(N, sizeof *terms);
    struct random_stream *stream = random_new(1, "terms");
    for (int i = 0; i < N; i++)
        terms[i] = random_gaussian(stream) * exp(20 * random_uniform(stream) - 10);
    random_free(stream);
    check_orders(terms);
    free(terms);
}

/* A uniform body: millions of nearly equal terms, whose cut-off parts all have one sign. */
static void test_equal_terms(void **state)
{
    (void)state;
    double *terms = memory_new(N, sizeof *terms);
    const double ulp = ldexp(1, -52);
    for (int i = 0; i < N; i++) terms[i] = 1.0 / 3 + (i % 7) * ulp;
    check_orders(terms);
    free(terms);
}

/* What a body of 2^26 equal nodes would do at worst: of each term the first grid, 2^-51 for a bound
 * in [1/2, 1), passes on just under half of its width, always of one sign, with bits to far below
 * the second grid, 2^-75.  A second grid that is finer by 2^-6 would hold no more than 2^24 of
 * them. */
static void test_many_terms_with_the_worst_remainder(void **state)
{
    (void)state;
    enum { MANY = 1 << 26, CHUNK = 1 << 12 };
    static const double bound = 0.75, terms[2] = {0x1p-30 + 0x1p-52 - 3 * 0x1p-75 - 5 * 0x1p-81,
                                                  0x1p-30 + 0x1p-52 - 8 * 0x1p-75 + 7 * 0x1p-81};
    double chunks[2][CHUNK], by_kind, in_turn;
    for (int i = 0; i < CHUNK; i++)
        for (int k = 0; k < 2; k++) chunks[k][i] = terms[k];
    struct exact_sum sums[2] = {exact_sum_new(bound), exact_sum_new(bound)};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < MANY / 2; i += CHUNK)
            exact_sum_add_strip(&sums[0], CHUNK, chunks[k], 1);
    for (int i = 0; i < MANY; i++) exact_sum_add(&sums[1], terms[i % 2]);
    exact_sum_finish(&sums[0], 1, &by_kind);
    exact_sum_finish(&sums[1], 1, &in_turn);
    assert_true(by_kind == in_turn);
    /* as above */
    const double exact = (double)(MANY / 2 * ((long double)terms[0] + (long double)terms[1]));
    assert_near(by_kind, exact, 3e-16 * exact + MANY * 0x1p-75 * bound);
}

/* Terms far below the bound, down to where the first grid passes all of each on to the second: the
 * energies of a large body at the start of a test. */
static void test_small_terms(void **state)
{
    (void)state;
    double *terms = memory_new(N, sizeof *terms);
    static const int sizes[] = {30, 40, 50, 53, 60};
    for (int k = 0; k < 5; k++) {
        const int bits = sizes[k];
        struct random_stream *stream = random_new(bits, "terms");
        for (int i = 0; i < N; i++) terms[i] = ldexp(random_full(stream), -bits);
        random_free(stream);
        const double value = sum_in_parts(terms, 1, 100);
        assert_near(value, reference(terms), N * 0x1p-75 + 3e-16 * value);
        shuffle(terms, bits);
        assert_true(sum_in_parts(terms, 1, N / 3) == value);
    }
    free(terms);
}

static void test_scaled_strips_and_integers(void **state)
{
    (void)state;
    double terms[100], value;
    for (int i = 0; i < 100; i++) terms[i] = i;
    struct exact_sum sum = exact_sum_new(1e6), empty = exact_sum_new(0);
    exact_sum_add_strip(&sum, 100, terms, 2.5);
    exact_sum_finish(&sum, 1, &value);
    assert_true(value == 2.5 * 4950);
    exact_sum_finish(&empty, 1, &value);
    assert_true(value == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_terms_of_many_sizes),
        cmocka_unit_test(test_equal_terms),
        cmocka_unit_test(test_many_terms_with_the_worst_remainder),
        cmocka_unit_test(test_small_terms),
        cmocka_unit_test(test_scaled_strips_and_integers),
    };
    return cmocka_run_group_tests_name("exact sums", tests, small_ranks_start, small_ranks_stop);
}
