#include "check.h"

#include "random.h"

/* Studies are named by their seeds: these numbers must never change. */
static void test_known_numbers(void **state)
{
    (void)state;
    struct random_stream *stream = random_new(1, "positions");
    assert_true(random_uniform(stream) == 0.24678411660715938);
    assert_true(random_uniform(stream) == 0.16017764434218407);
    assert_true(random_uniform(stream) == 0.98869710508733988);
    /* log and sqrt of the machine's library: a few units in the last place. */
    assert_relative(random_gaussian(stream), 0.42730685740474333, 1e-14);
    random_free(stream);
    stream = random_new(1, "labels");
    assert_int_equal(random_integer(stream, 1000), 749);
    assert_int_equal(random_integer(stream, UINT64_MAX), 4355549194483446723);
    random_free(stream);
    assert_true(random_hash(1, "labels", 7) == 0x4f6489acd702d773u);
}

static void test_seeds_and_purposes_give_different_streams(void **state)
{
    (void)state;
    double first[4];
    const long seeds[] = {1, 2, 1, -1};
    const char *purposes[] = {"positions", "positions", "labels", "positions"};
    for (int i = 0; i < 4; i++) {
        struct random_stream *stream = random_new(seeds[i], purposes[i]);
        first[i] = random_uniform(stream);
        random_free(stream);
        for (int j = 0; j < i; j++) assert_true(first[i] != first[j]);
    }
}

/* n = 1e5 draws; the bounds are five standard errors, and the seed is fixed: no chance involved. */
static void test_moments(void **state)
{
    enum { N = 100000 };
    (void)state;
    double uniform = 0, gaussian = 0, square = 0, lowest = 1, highest = 0;
    struct random_stream *stream = random_new(42, "moments");
    for (int i = 0; i < N; i++) {
        double u = random_uniform(stream), g = random_gaussian(stream);
        uniform += u / N;
        gaussian += g / N;
        square += g * g / N;
        lowest = fmin(lowest, u);
        highest = fmax(highest, u);
    }
    random_free(stream);
    assert_near(uniform, 0.5, 5 * sqrt(1.0 / 12 / N));
    assert_near(gaussian, 0, 5 * sqrt(1.0 / N));
    assert_near(square, 1, 5 * sqrt(2.0 / N));
    assert_true(lowest >= 0 && highest < 1);
}

static void test_integers_are_uniform(void **state)
{
    enum { N = 70000, BELOW = 7 };
    (void)state;
    int counts[BELOW] = {0};
    struct random_stream *stream = random_new(3, "integers");
    for (int i = 0; i < N; i++) {
        uint64_t number = random_integer(stream, BELOW);
        assert_true(number < BELOW);
        counts[number]++;
    }
    double chi_square = 0, expected = (double)N / BELOW;
    for (int i = 0; i < BELOW; i++) chi_square += pow(counts[i] - expected, 2) / expected;
    /* Six degrees of freedom: 22.5 is passed once in a thousand. */
    assert_true(chi_square < 22.5);
    uint64_t large = (uint64_t)1 << 63, above = 0;
    for (int i = 0; i < 1000; i++) above += random_integer(stream, large + 1) > large / 2;
    random_free(stream);
    /* Half of them, within five standard errors of 16. */
    assert_near((double)above, 500, 80);
}

/* Neighbouring numbers must not give neighbouring hashes: each bit is set in half of them. */
static void test_hash_bits(void **state)
{
    enum { N = 4096 };
    (void)state;
    for (int bit = 0; bit < 64; bit++) {
        int set = 0;
        for (uint64_t i = 0; i < N; i++) set += (int)(random_hash(1, "ties", i) >> bit & 1);
        /* Five standard errors of 32. */
        assert_near(set, N / 2, 160);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_numbers),
        cmocka_unit_test(test_seeds_and_purposes_give_different_streams),
        cmocka_unit_test(test_moments),
        cmocka_unit_test(test_integers_are_uniform),
        cmocka_unit_test(test_hash_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
