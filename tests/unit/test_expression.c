#include "dies.h"

#include "expression.h"
#include "memory.h"
#include "random.h"

#include <locale.h>
#include <stdlib.h>

static const char *const names[] = {"x", "y", "z", "t"};
enum { NAMES = 4 };

/* An expression in x, y, z, t as the value of a deck's only key. */
struct formula {
    struct deck *deck;
    struct expression *e;
};

static struct formula parse(const char *text)
{
    char *line = memory_print("a: \"%s\"\n", text);
    struct deck *deck = deck_parse(line, strlen(line), "study.yaml");
    free(line);
    return (struct formula){deck, expression_new(deck_get(deck_root(deck), "a"), names, NAMES)};
}

static void let_go(struct formula *formula)
{
    expression_free(formula->e);
    deck_free(formula->deck);
}

/* x = 2, y = 3, z = -0.5, t = 0.25 */
static const double at[NAMES] = {2, 3, -0.5, 0.25};

static void test_values(void **state)
{
    static const struct {
        const char *text;
        double value;
    } cases[] = {
        {"1e-6*t", 1e-6 * 0.25},
        {" .5 ", 0.5},
        {"5.E+1", 50},
        {"-x^2", -4},
        {"2^y^x", 512},
        {"x - y - z", -0.5},
        {"x/y/z", 2.0 / 3 / -0.5},
        {"x*-y", -6},
        {"x^-1", 0.5},
        {"t < 0.5 ? 1 : 2", 1},
        {"t < 0.1 ? 1 : t < 0.2 ? 2 : 3", 3},
        {"x > 1 && y < 0", 0},
        {"1 || 0 && 0", 1},
        {"!(x > 1) || y == 3", 1},
        {"x >= 2 && x <= 2 && x != 3", 1},
        {"(x < 3) == (y < 4)", 1},
        {"min(x, y, z)", -0.5},
        {"max(x, y, z)", 3},
        {"max(x)", 2},
        {"abs(z) + sign(z) + step(z) + step(0)", 0.5},
        {"floor(t) + ceil(t)", 1},
        {"pow(x, y) - hypot(3, 4)", 3},
        {"step(t - 0.2)*(t < 0.3)", 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct formula formula = parse(cases[i].text);
        /* A few operations on numbers that are nearly all exact: two roundings at most. */
        assert_relative(expression_value(formula.e, at), cases[i].value, 4e-16);
        let_go(&formula);
    }
}

/* Against the same formula compiled here; muParser may write x*x as a power, so some roundings. */
static void test_against_the_compiler(void **state)
{
    (void)state;
    struct formula formula =
        parse("10*sin(2*pi*t)*exp(-(x^2 + y*y)/2) + sqrt(x*x + z^2)/(1 + ln(1 + y)) - atan2(z, x) "
              "+ log10(x)*log(y) + cbrt(y)*tanh(t) + erf(z)");
    for (int i = 0; i < 1000; i++) {
        double x = 0.1 + 1e-3 * i, y = 2 - 1e-3 * i, z = sin(i), t = 1e-3 * i;
        double expected = 10 * sin(2 * M_PI * t) * exp(-(x * x + y * y) / 2) +
                          sqrt(x * x + z * z) / (1 + log(1 + y)) - atan2(z, x) + log10(x) * log(y) +
                          cbrt(y) * tanh(t) + erf(z);
        /* Each term is below 10: an ulp of 10, a few times. */
        assert_near(expression_value(formula.e, (const double[]){x, y, z, t}), expected, 1e-14);
    }
    let_go(&formula);
}

static void test_pi_is_pi(void **state)
{
    (void)state;
    struct formula formula = parse("pi");
    assert_true(expression_value(formula.e, at) == M_PI);
    let_go(&formula);
}

static void test_what_it_depends_on(void **state)
{
    (void)state;
    struct formula formula = parse("2*t + max(1, y)");
    assert_false(expression_uses(formula.e, 0));
    assert_true(expression_uses(formula.e, 1));
    assert_false(expression_uses(formula.e, 2));
    assert_true(expression_uses(formula.e, 3));
    let_go(&formula);
}

/* Two expressions are alive at once; evaluating one leaves the other alone. */
static void test_two_at_once(void **state)
{
    (void)state;
    struct formula a = parse("x + t"), b = parse("x - t");
    assert_true(expression_value(a.e, at) == 2.25);
    assert_true(expression_value(b.e, (const double[]){1, 0, 0, 1}) == 0);
    assert_true(expression_value(a.e, at) == 2.25);
    let_go(&a);
    let_go(&b);
}

/* A locale with a decimal comma changes neither numbers nor the meaning of the comma. */
static void test_locale(void **state)
{
    static const char *const commas[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"};
    (void)state;
    const char *found = NULL;
    for (size_t i = 0; !found && i < sizeof commas / sizeof *commas; i++)
        found = setlocale(LC_ALL, commas[i]);
    struct formula formula = parse("1.5*x + max(0.25, 0.5)");
    assert_true(expression_value(formula.e, at) == 3.5);
    let_go(&formula);
    setlocale(LC_ALL, "C");
    if (!found) print_message("# no locale with a decimal comma here: only the C locale tried\n");
}

static void parse_only(const void *text)
{
    struct formula formula = parse(text);
    let_go(&formula);
}

static void test_mistakes(void **state)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"x + u",
         "study.yaml:1:4: expression 'x + u': unknown name 'u' (known: x, y, z, t, pi, sin"},
        {"sine(t)", "unknown name 'sine' (did you mean sin? known"},
        {"_pi", "unknown name '_pi' (did you mean pi?"},
        {"X", "unknown name 'X' (did you mean x?"},
        {"t t", "Unexpected"},
        {"2 x", "Unexpected"},
        {"2x", "Unexpected"},
        {"x +", "Unexpected end"},
        {"sin x", "Unexpected token"},
        {"sin(x, y)", "Too many parameters"},
        {"atan2(x)", "Too few parameters"},
        {"sin()", "Too few parameters"},
        {"min()", "Too few parameters"},
        {"(x", "a ')' is missing"},
        {"x)", "a ')' has no '('"},
        {"x ? 1", "missing an else"},
        {"1 : 2", "Misplaced colon"},
        {"x = 3", "'=' assigns"},
        {"x == 3 = 3", "'=' assigns"},
        {"3,6*x", "more than one value"},
        {"0 < x < 1", "write 'a < b && b < c'"},
        {"x > 0 & y > 0", "'&&' and '||'"},
        {"x % 2", "'%' has no meaning"},
        {"x; y", "';' has no meaning"},
        {"x * 'a'", "''' has no meaning"},
        {"x * \\\"a\\\"", "'\"' has no meaning"},
        {"\\u00b5*x", "a character that means nothing"},
        {"1.2.3", "Unexpected"},
        {"0x10", "unknown name"},
        {"1e", "Unexpected"},
        {"   ", "empty"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_dies(EXIT_USER, cases[i].message, parse_only, cases[i].text);
}

static char *repeat(const char *piece, int count, const char *middle, const char *end)
{
    char *text = memory_new(
        strlen(piece) * (size_t)count + strlen(middle) + strlen(end) * (size_t)count + 1, 1);
    for (int i = 0; i < count; i++) strcat(text, piece);
    strcat(text, middle);
    for (int i = 0; i < count; i++) strcat(text, end);
    return text;
}

static void test_limits(void **state)
{
    (void)state;
    char *deep = repeat("(", 51, "x", ")"), *good = repeat("(", 50, "x", ")"),
         *length = repeat("x+", 500, "x", ""), *choices = repeat("x?y:", 51, "x", "");
    assert_dies(EXIT_USER, "nested too deep", parse_only, deep);
    assert_dies(EXIT_USER, "too long", parse_only, length);
    assert_dies(EXIT_USER, "50 choices", parse_only, choices);
    struct formula formula = parse(good);
    assert_true(expression_value(formula.e, at) == 2);
    let_go(&formula);
    free(deep);
    free(good);
    free(length);
    free(choices);
}

struct trial {
    const char *text;
    double low, high;
};

static void try_it(const void *argument)
{
    const struct trial *trial = argument;
    struct formula formula = parse(trial->text);
    expression_try(formula.e, at, "m/s", trial->low, trial->high);
    let_go(&formula);
}

static void test_trials(void **state)
{
    static const struct {
        struct trial trial;
        const char *message;
    } cases[] = {
        {{"1/(x - 2)", -1, 1},
         "study.yaml:1:4: expression '1/(x - 2)': is infinite at x = 2, expected"},
        {{"sqrt(z)", -1, 1}, "is not a number at z = -0.5"},
        {{"sign(sqrt(z))", -1, 1}, "is not a number"},
        {{"min(sqrt(z), 1)", -1, 1}, "is not a number"},
        {{"min(1, sqrt(z))", -1, 1}, "is not a number"},
        {{"max(1, ln(z), 3)", -1, 1}, "is not a number"},
        {{"1e300*1e300", -1, 1}, "is infinite, expected"},
        {{"x*t", -0.1, 0.1}, "is 0.5 m/s at x = 2, t = 0.25, expected -0.1 to 0.1 m/s"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_dies(EXIT_USER, cases[i].message, try_it, &cases[i].trial);
    struct formula formula = parse("x*t");
    assert_true(expression_try(formula.e, at, "m/s", 0, 1) == 0.5);
    let_go(&formula);
}

static void try_value(const void *text)
{
    struct formula formula = parse(text);
    expression_value(formula.e, at);
    let_go(&formula);
}

/* Random text from the pieces of expressions: parsed and evaluated, or refused as a user's mistake,
 * never a crash.  In one process each, since a refusal ends it. */
static void test_hostile_text(void **state)
{
    static const char *const pieces[] = {
        "x",    "t",   "(",  ")",  ",",    "+",   "-",   "*",    "/", "^",  "?",
        ":",    "<",   ">=", "==", "!=",   "&&",  "||",  "!",    "1", ".5", "1e9",
        "sin(", "min", "pi", " ",  "max(", "x^2", "2*x", "pow(", "0"};
    enum { PIECES = sizeof pieces / sizeof *pieces, TRIES = 1500 };
    (void)state;
    int parsed = 0;
    for (uint64_t k = 0; k < TRIES; k++) {
        char text[256] = "";
        const int length = 1 + (int)(random_hash(1, "length", k) % 14);
        for (int i = 0; i < length; i++)
            strcat(text, pieces[random_hash(2, "piece", k * 100 + (uint64_t)i) % PIECES]);
        const int code = code_of(try_value, text);
        if (code != 0 && code != EXIT_USER) fail_msg("'%s' ends with %d", text, code);
        parsed += code == 0;
    }
    assert_true(parsed > TRIES / 100); /* some are sound, or the test tests nothing */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),      cmocka_unit_test(test_against_the_compiler),
        cmocka_unit_test(test_pi_is_pi),    cmocka_unit_test(test_what_it_depends_on),
        cmocka_unit_test(test_two_at_once), cmocka_unit_test(test_locale),
        cmocka_unit_test(test_mistakes),    cmocka_unit_test(test_limits),
        cmocka_unit_test(test_trials),      cmocka_unit_test(test_hostile_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
