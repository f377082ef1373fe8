/* Values of the deck: numbers, expressions, ramps and stepped loads. */
#include "dies.h"

#include "memory.h"
#include "value.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

enum { ANY = VALUE_IN_SPACE | VALUE_IN_TIME | VALUE_STEPPED };

struct wanted {
    const char *text, *unit;
    int allowed;
};

/* The value of a deck's only key. */
static struct value given(struct wanted wanted)
{
    char *line = memory_print("v: %s\n", wanted.text);
    struct deck *deck = deck_parse(line, strlen(line), "study.yaml");
    free(line);
    return value_read(deck_get(deck_root(deck), "v"), wanted.unit, -1000, 1000, wanted.allowed);
}

/* Frees a value and the deck made for it. */
static void let_go(struct value *value)
{
    struct deck *deck = (struct deck *)value->where.deck;
    value_free(value);
    deck_free(deck);
}

static const double place[3] = {2, 3, 5};

static void test_numbers(void **state)
{
    static const struct {
        struct wanted wanted;
        double value;
    } cases[] = {
        {{"10 m/s", "m/s", ANY}, 10}, {{"-3", "m/s", 0}, -3},     {{"5 mm", "m", 0}, 5e-3},
        {{"1 kN", "N", ANY}, 1000},   {{"2 N/m3", "N/m3", 0}, 2}, {{"10/s*m", "m/s", ANY}, 10},
        {{".5", "1", 0}, 0.5},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct value value = given(cases[i].wanted);
        assert_int_equal(value.kind, VALUE_CONSTANT);
        assert_true(value_at(&value, place, 7) == cases[i].value);
        assert_false(value_depends_on_place(&value) || value_depends_on_time(&value));
        let_go(&value);
    }
}

static void test_expressions(void **state)
{
    static const struct {
        const char *text;
        double value;
        bool place, time;
    } cases[] = {
        {"1e-6*t", 7e-6, false, true}, {"10*t", 70, false, true},
        {"10/x", 5, true, false},      {"x", 2, true, false},
        {"-t", -7, false, true},       {"2*3", 6, false, false},
        {"y*z - t", 8, true, true},    {"\"(x)\"", 2, true, false},
        {"1 - x", -1, true, false},    {"\"t > 6 ? x : 0\"", 2, true, true},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct value value = given((struct wanted){cases[i].text, "m/s", ANY});
        assert_int_equal(value.kind, VALUE_EXPRESSION);
        /* One product of a decimal number: its rounding. */
        assert_relative(value_at(&value, place, 7), cases[i].value, 2.3e-16);
        assert_int_equal(value_depends_on_place(&value), cases[i].place);
        assert_int_equal(value_depends_on_time(&value), cases[i].time);
        let_go(&value);
    }
}

static void test_ramp(void **state)
{
    (void)state;
    struct value value = given((struct wanted){"{ramp: 2 s, to: 10 m/s}", "m/s", VALUE_IN_TIME});
    assert_int_equal(value.kind, VALUE_RAMP);
    assert_true(value_at(&value, place, 0) == 0 && value_at(&value, place, -1) == 0);
    assert_true(value_at(&value, place, 1) ==
                5); /* antisymmetric about its middle; exact numbers */
    assert_true(value_at(&value, place, 2) == 10 && value_at(&value, place, 9) == 10);
    assert_true(value_depends_on_time(&value) && !value_depends_on_place(&value));
    let_go(&value);
    /* s^3 (10 - 15 s + 6 s^2) at 1/4: (10 - 15/4 + 6/16)/64 = 53/512 */
    assert_true(value_rise(0.25) == 53.0 / 512);
}

static void test_steps(void **state)
{
    static const struct {
        const char *text;
        int64_t every;
    } cases[] = {{"{initial: 150 N, increment: 150 N, every: 250 steps}", 250},
                 {"{initial: 150 N, increment: 150 N, every: equilibrium}", 0}};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct value value = given((struct wanted){cases[i].text, "N", VALUE_STEPPED});
        assert_int_equal(value.kind, VALUE_STEPS);
        assert_int_equal(value.every, cases[i].every);
        assert_true(value_at(&value, place, 1) == 150 && value_depends_on_time(&value));
        assert_false(value_raise(&value, 0, false));
        assert_false(value_raise(&value, 249, false));
        assert_int_equal(value_raise(&value, 250, false), i == 0);
        assert_int_equal(value_raise(&value, 251, true), i == 1);
        assert_true(value_at(&value, place, 1) == 300);
        let_go(&value);
    }
}

static void read_only(const void *argument);

/* Linear between its rows, standing before and behind them. */
static void expect_table(const struct value *value)
{
    static const struct {
        double time, value;
    } cases[] = {{-1, 2}, {0, 2}, {0.25, 3}, {0.5, 4}, {1, 2}, {1.5, 0}, {7, 0}};
    assert_int_equal(value->kind, VALUE_TABLE);
    assert_true(value_depends_on_time(value));
    assert_false(value_depends_on_place(value));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_true(value_at(value, place, cases[i].time) == cases[i].value);
    assert_true(value_next_row(value, 0) == 0.5);
    assert_true(value_next_row(value, 0.5) == 1.5);
    assert_true(value_next_row(value, 1.5) == INFINITY);
}

static void test_tables(void **state)
{
    (void)state;
    struct value value = given((struct wanted){"[[0 s, 2], [500 ms, 4], [1.5, 0]]", "N", ANY});
    expect_table(&value);
    let_go(&value);
    char name[] = "/tmp/test_value-XXXXXX";
    FILE *file = fdopen(mkstemp(name), "w");
    fputs("# made by hand\ntime,force\n0,2\n0.5; 4 # the top\r\n\n 1.5\t0\n", file);
    fclose(file);
    char *text = memory_print("{table: %s}", name);
    value = given((struct wanted){text, "N", ANY});
    expect_table(&value);
    let_go(&value);
    file = fopen(name, "a");
    fputs("1.5 3\n", file);
    fclose(file);
    const struct wanted wanted = {text, "N", ANY};
    assert_dies(EXIT_USER, ":7: its time, 1.5 s, is not after that of the row before", read_only,
                &wanted);
    file = fopen(name, "w");
    fputs("0 1\n1 2 3\n", file);
    fclose(file);
    assert_dies(EXIT_USER, ":2: 3 numbers, expected time and value", read_only, &wanted);
    file = fopen(name, "w");
    fputs("0 1\n1 2000\n", file);
    fclose(file);
    assert_dies(EXIT_USER, ":2: 2000 N is out of range", read_only, &wanted);
    unlink(name);
    free(text);
}

static void grow(const void *argument)
{
    struct value value = given(*(const struct wanted *)argument);
    for (int64_t step = 1; step < 100; step++) value_raise(&value, step, false);
}

static void read_only(const void *argument)
{
    struct value value = given(*(const struct wanted *)argument);
    let_go(&value);
}

static void test_mistakes(void **state)
{
    static const struct {
        struct wanted wanted;
        const char *message;
    } cases[] = {
        {{"5 mm", "m/s", ANY}, "study.yaml:1:4: 'mm' is a length, expected a velocity in m/s"},
        {{"5 foos", "m/s", ANY}, "unknown unit 'foos', expected a velocity in m/s"},
        {{"1 Pa", "N/m3", ANY}, "expected a force density in N/m3"},
        {{"2 x", "m/s", ANY}, "unknown unit 'x'"},
        {{"1001 m/s", "m/s", ANY}, "1001 m/s is out of range"},
        {{"nan", "m/s", ANY}, "'nan' is not a number"},
        {{"0x14", "m/s", ANY}, "'0x14' is not a number"},
        {{"1e999", "m/s", ANY}, "too large"},
        {{"fast", "m/s", ANY}, "study.yaml:1:4: expression 'fast': unknown name 'fast'"},
        {{"10*s", "m/s", ANY}, "unknown name 's'"},
        {{"\"\"", "m/s", ANY}, "a value is missing"},
        {{"2*t", "m/s", VALUE_IN_SPACE}, "cannot depend on t"},
        {{"2*y", "m/s", VALUE_IN_TIME}, "cannot depend on x, y, z"},
        {{"[1, 2]", "m/s", ANY}, "study.yaml:1:5: expected a row of a table: [time, value]"},
        {{"[[0, 1]]", "m/s", ANY},
         "expected a number in m/s, an expression, {ramp: ..., to: ...}, a table [[time, value], "
         "...] or {table: FILE}, {init"},
        {{"[[0, 1], [1, 2]]", "N", VALUE_IN_SPACE}, "expected a number in N, an expression"},
        {{"[[0, 1], [0, 2]]", "N", ANY},
         "study.yaml:1:13: its time, 0 s, is not after that of the row before"},
        {{"[[0, 1], [1, 2, 3]]", "N", ANY}, "expected a row of a table: [time, value]"},
        {{"[[0, 1], [1 m, 2]]", "N", ANY}, "'m' is a length, expected a time in s"},
        {{"[[0, 1], [1, 1001]]", "N", ANY}, "study.yaml:1:17: "},
        {{"{table: nowhere.txt}", "N", ANY}, "study.yaml:1:12: cannot open nowhere.txt: "},
        {{"{ramp: 1 s, to: 2}", "m/s", VALUE_IN_SPACE}, "expected a number in m/s, an expression"},
        {{"{ramp: 1 s}", "m/s", ANY}, "key 'to' is missing"},
        {{"{ramp: 1 m, to: 2}", "m/s", ANY}, "study.yaml:1:11: 'm' is a length, expected a time"},
        {{"{ramp: 1 s, to: 2, at: 3}", "m/s", ANY}, "unknown key 'at'"},
        {{"{initial: 1, increment: 1, every: 1 steps}", "N", VALUE_IN_TIME},
         "expected a number in N"},
        {{"{initial: 1, increment: 1}", "N", ANY}, "key 'every' is missing"},
        {{"{initial: 1, increment: 1, every: 250}", "N", ANY},
         "'250' is not known here, expected such"},
        {{"{initial: 1, increment: 1, every: 2.5 steps}", "N", ANY},
         "'2.5 steps' is not known here"},
        {{"{initial: 1, increment: 1, every: 0 steps}", "N", ANY}, "out of range"},
        {{"{initial: 1, increment: 1, every: balance}", "N", ANY}, "'balance' is not known here"},
    };
    static const struct wanted growing = {"{initial: 0, increment: 300, every: 10 steps}", "N",
                                          ANY};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_dies(EXIT_USER, cases[i].message, read_only, &cases[i].wanted);
    assert_dies(EXIT_USER, "has grown to 1200 N after 4 increments", grow, &growing);
}

/* A node at x = 2, and a run of 8 s. */
static void try_it(const void *text)
{
    struct value value = given((struct wanted){text, "m/s", ANY});
    value_try(&value, (const double[]){2, 0, 0}, 8);
    let_go(&value);
}

static void test_trials(void **state)
{
    (void)state;
    try_it("1/(x - 1)"); /* infinite elsewhere only */
    try_it("10 m/s");
    assert_dies(EXIT_USER, "is infinite at x = 2", try_it, "1/(x - 2)");
    assert_dies(EXIT_USER, "is infinite at t = 0", try_it, "1/t");
    assert_dies(EXIT_USER, "is infinite at t = 4", try_it, "1/(t - 4)");
    assert_dies(EXIT_USER, "is not a number at t = 8", try_it, "sqrt(7 - t)");
    assert_dies(EXIT_USER, "is 1600 m/s at x = 2, t = 8, expected -1000 to 1000 m/s", try_it,
                "100*x*t");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers), cmocka_unit_test(test_expressions),
        cmocka_unit_test(test_ramp),    cmocka_unit_test(test_steps),
        cmocka_unit_test(test_tables),  cmocka_unit_test(test_mistakes),
        cmocka_unit_test(test_trials),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
