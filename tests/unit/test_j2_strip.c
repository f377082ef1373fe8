/* A point's answer depends on its own data alone, not on the strip it is in or its place there:
 * else the bits would change with the number of ranks, which cut the lattice into strips.  So all
 * comparisons are of bits. */
#include "one_point.h"

#include "memory.h"
#include "random.h"

#include <stdlib.h>

static const char *const laws[] = {
    "{law: linear, yield: 182.1 MPa, modulus: 850 MPa}",
    "{law: linear, yield: 150 MPa, modulus: 0}",
    "{law: swift, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.4}",
    "{law: ludwik, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.4}",
    "{law: hollomon, yield: 182.1 MPa, strength: 900 MPa, exponent: 0.4}",
    "{law: voce, yield: 182.1 MPa, saturation: 513 MPa, rate: 5.32}",
    "{law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}",
    "{law: two_voce, yield: 182.1 MPa, saturation: 300 MPa, rate: 5, saturation_2: 100 MPa, "
    "rate_2: 80}",
    "{law: tabulated, points: [[0, 180 MPa], [0.05, 300 MPa], [0.2, 500 MPa], [1, 800 MPa]]}",
    /* Kinks upwards and downwards, between which Newton's method can go to and fro. */
    "{law: tabulated, points: [[0, 100 MPa], [1e-4, 900 MPa], [2e-4, 901 MPa], [1e-3, 902 MPa], "
    "[1.1e-3, 4 GPa], [0.01, 4.001 GPa], [0.0101, 9 GPa], [0.05, 9.1 GPa], [1, 10 GPa]]}",
};
enum { LAWS = sizeof laws / sizeof *laws, STEPS = 40 };

/* The law's curve, with points of this law or, for law = LAWS, of all of them in turn. */
struct strip {
    struct hardening law[LAWS];
    double *curves;
    struct points j2;
    double state[J2_STATE * LANES];
};

static void strip_new(struct strip *strip, int law)
{
    const struct hardening *pointers[LAWS];
    *strip = (struct strip){.j2.count = LANES};
    for (int k = 0; k < LAWS; k++) {
        strip->law[k] = read_law(laws[k]);
        pointers[k] = &strip->law[k];
    }
    strip->curves = flow_curves_new(LAWS, pointers, pointers);
    for (int i = 0; i < LANES; i++) {
        strip->j2.mu[i] = 80e9 + 1e9 * (i % 5);
        strip->j2.bulk[i] = 180e9;
        strip->j2.pair[i] = law < LAWS ? law : i % LAWS;
    }
    law_start(&law_j2, strip->curves, &strip->j2, strip->state, LANES);
}

static void strip_free(struct strip *strip)
{
    for (int k = 0; k < LAWS; k++) hardening_free(&strip->law[k]);
    free(strip->curves);
}

/* Of any size from a tenth of the strain at yield, 1e-4, to a thousand times that. */
static void random_strains(struct points *j2, struct random_stream *stream)
{
    for (int i = 0; i < LANES; i++) {
        const double size = 1e-4 * pow(1000, random_uniform(stream));
        for (int k = 0; k < TENSOR; k++) j2->H[k][i] = size * (2 * random_uniform(stream) - 1);
    }
}

/* Point i of the strip on its own, as the only one of another strip. */
static void check_point(const struct strip *before, const struct strip *after, int i)
{
    const struct step mode = {.commit = true, .energy = true};
    struct points alone = {.count = 1};
    double state[J2_STATE];
    alone.mu[0] = before->j2.mu[i];
    alone.bulk[0] = before->j2.bulk[i];
    alone.pair[0] = before->j2.pair[i];
    for (int k = 0; k < TENSOR; k++) alone.H[k][0] = before->j2.H[k][i];
    for (int k = 0; k < J2_STATE; k++) state[k] = before->state[k * LANES + i];
    law_j2.update(before->curves, &alone, state, 1, mode);
    for (int k = 0; k < TENSOR; k++) assert_true(alone.P[k][0] == after->j2.P[k][i]);
    for (int k = 0; k < J2_STATE; k++) assert_true(state[k] == after->state[k * LANES + i]);
    assert_true(alone.stored[0] == after->j2.stored[i]);
    assert_true(alone.dissipated[0] == after->j2.dissipated[i]);
}

static void check_law(int law)
{
    struct strip *before = memory_new(1, sizeof *before), *after = memory_new(1, sizeof *after);
    struct random_stream *stream = random_new(law, "strains");
    int still = 0, flowed = 0;
    strip_new(after, law);
    for (int n = 0; n < STEPS; n++) {
        random_strains(&after->j2, stream);
        *before = *after;
        law_j2.update(after->curves, &after->j2, after->state, LANES,
                      (struct step){.commit = true, .energy = true});
        for (int i = 0; i < LANES; i++) {
            const int p = J2_PLASTIC * LANES + i;
            after->state[p] > before->state[p] ? flowed++ : still++;
            check_point(before, after, i);
        }
    }
    assert_true(flowed > STEPS * LANES / 4);
    assert_true(still > STEPS * LANES / 100);
    random_free(stream);
    strip_free(after);
    free(before);
    free(after);
}

static void test_points_of_one_law(void **state)
{
    (void)state;
    for (int law = 0; law < LAWS; law++) check_law(law);
}

static void test_points_of_all_laws_in_one_strip(void **state)
{
    (void)state;
    check_law(LAWS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points_of_one_law),
        cmocka_unit_test(test_points_of_all_laws_in_one_strip),
    };
    return cmocka_run_group_tests_name("j2, strips", tests, NULL, NULL);
}
