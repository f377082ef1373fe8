#include "expression.h"

#include "die.h"
#include "memory.h"
#include "nearest.h"

#include <ctype.h>
#include <math.h>
#include <muParserDLL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 1000, DEEPEST = 50, LONGEST_NAME = 31 };

struct expression {
    struct deck_node where;
    muParserHandle_t parser;
    int count;
    char *names[EXPRESSION_VARIABLES];
    bool used[EXPRESSION_VARIABLES];
    double values[EXPRESSION_VARIABLES]; /* muParser reads the variables here */
};

/* --- functions -------------------------------------------------------------------------------- */

/* What is not a number stays so, to be found by expression_try. */
static double sign(double x)
{
    return isnan(x) ? x : (x > 0) - (x < 0);
}

static double step(double x)
{
    return isnan(x) ? x : x >= 0;
}

static double not(double x)
{
    return isnan(x) ? x : x == 0;
}

static double smallest(const double *values, int count)
{
    double least = values[0];
    for (int i = 1; i < count; i++)
        if (isnan(values[i]) || values[i] < least) least = values[i];
    return least;
}

static double largest(const double *values, int count)
{
    double most = values[0];
    for (int i = 1; i < count; i++)
        if (isnan(values[i]) || values[i] > most) most = values[i];
    return most;
}

/* One of the three is set. */
static const struct function {
    const char *name;
    double (*of_one)(double);
    double (*of_two)(double, double);
    double (*of_any)(const double *, int);
} functions[] = {
    {"sin", sin, NULL, NULL},      {"cos", cos, NULL, NULL},     {"tan", tan, NULL, NULL},
    {"asin", asin, NULL, NULL},    {"acos", acos, NULL, NULL},   {"atan", atan, NULL, NULL},
    {"sinh", sinh, NULL, NULL},    {"cosh", cosh, NULL, NULL},   {"tanh", tanh, NULL, NULL},
    {"exp", exp, NULL, NULL},      {"ln", log, NULL, NULL},      {"log", log, NULL, NULL},
    {"log10", log10, NULL, NULL},  {"sqrt", sqrt, NULL, NULL},   {"cbrt", cbrt, NULL, NULL},
    {"abs", fabs, NULL, NULL},     {"sign", sign, NULL, NULL},   {"step", step, NULL, NULL},
    {"floor", floor, NULL, NULL},  {"ceil", ceil, NULL, NULL},   {"erf", erf, NULL, NULL},
    {"atan2", NULL, atan2, NULL},  {"pow", NULL, pow, NULL},     {"hypot", NULL, hypot, NULL},
    {"min", NULL, NULL, smallest}, {"max", NULL, NULL, largest},
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* --- looking over the text before muParser does ----------------------------------------------- */

static const char *text_of(const struct expression *e)
{
    return deck_string(e->where);
}

static _Noreturn void refuse(const struct expression *e, const char *what)
{
    deck_error(e->where, "expression '%.200s': %s", text_of(e), what);
}

static _Noreturn void unknown_name(const struct expression *e, const char *name)
{
    const char *known[EXPRESSION_VARIABLES + FUNCTIONS + 1];
    int count = 0;
    for (int i = 0; i < e->count; i++) known[count++] = e->names[i];
    known[count++] = "pi";
    for (int i = 0; i < FUNCTIONS; i++) known[count++] = functions[i].name;
    const char *nearest = nearest_name(name, known, count);
    refuse(e, memory_print("unknown name '%.40s' (%s%s%sknown: %s)", name,
                           nearest ? "did you mean " : "", nearest ? nearest : "",
                           nearest ? "? " : "", nearest_list(known, count)));
}

static void check_name(struct expression *e, const char *start, size_t length)
{
    char name[LONGEST_NAME + 1] = {0};
    memcpy(name, start, length < LONGEST_NAME ? length : LONGEST_NAME);
    for (int i = 0; i < e->count; i++)
        if (strcmp(name, e->names[i]) == 0) {
            e->used[i] = true;
            return;
        }
    if (strcmp(name, "pi") == 0) return;
    for (int i = 0; i < FUNCTIONS; i++)
        if (strcmp(name, functions[i].name) == 0) return;
    unknown_name(e, name);
}

/* Length of the operator at a place, which is one of muParser's; dies where there is none. */
static size_t operator_length(const struct expression *e, const char *at)
{
    static const char *const pairs[] = {"==", "!=", "<=", ">=", "&&", "||"};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (strncmp(at, pairs[i], 2) == 0) return 2;
    if (*at == '=') refuse(e, "'=' assigns; a comparison is '=='");
    if (*at == '&' || *at == '|') refuse(e, "'and' and 'or' are '&&' and '||'");
    if (strchr("+-*/^(),<>!?:", *at) != NULL) return 1;
    refuse(e, isgraph((unsigned char)*at)
                  ? memory_print("'%c' has no meaning in an expression", *at)
                  : "has a character that means nothing in an expression");
}

/* Notes brackets and comparisons: compared[depth] says that one has been made at this depth
 * already. */
static void follow(const struct expression *e, const char *at, size_t length, int *depth,
                   bool compared[DEEPEST + 1])
{
    if (*at == '(' && ++*depth > DEEPEST)
        refuse(e, "nested too deep, expected at most 50 brackets");
    if (*at == ')' && --*depth < 0) refuse(e, "a ')' has no '('");
    if (*at == '<' || *at == '>') {
        if (compared[*depth])
            refuse(e, "'a < b < c' compares the outcome of 'a < b'; write 'a < b && b < c'");
        compared[*depth] = true;
    } else if (strchr("(,?:", *at) != NULL || (length == 2 && strchr("&|", *at) != NULL)) {
        compared[*depth] = false;
    }
}

static void look_over(struct expression *e)
{
    const char *at = text_of(e);
    bool compared[DEEPEST + 1] = {false};
    int depth = 0, choices = 0;
    if (strlen(at) > LONGEST) refuse(e, "too long, expected at most 1000 bytes");
    while (*at != '\0') {
        const unsigned char first = (unsigned char)*at;
        size_t length = 1;
        if (isalpha(first) || first == '_') {
            while (isalnum((unsigned char)at[length]) || at[length] == '_') length++;
            check_name(e, at, length);
        } else if (isdigit(first) || first == '.') {
            length = strspn(at, "0123456789.");
            if (at[length] == 'e' || at[length] == 'E') {
                size_t sign_length = at[length + 1] == '+' || at[length + 1] == '-';
                length += 1 + sign_length + strspn(at + length + 1 + sign_length, "0123456789");
            }
        } else if (!isspace(first)) {
            length = operator_length(e, at);
            follow(e, at, length, &depth, compared);
            if (first == '?' && ++choices > DEEPEST) refuse(e, "more than 50 choices 'c ? a : b'");
        }
        at += length;
    }
    if (depth > 0) refuse(e, "a ')' is missing");
}

/* --- muParser --------------------------------------------------------------------------------- */

/* Without a handler muParser's errors pass unseen; they are asked for after each call. */
static void on_error(muParserHandle_t parser)
{
    (void)parser;
}

static void check_parser(const struct expression *e)
{
    if (!mupError(e->parser)) return;
    refuse(e, mupGetErrorMsg(e->parser));
}

/* muParser's own set has another pi, and functions whose meaning changed between its versions. */
static void define(struct expression *e)
{
    mupClearFun(e->parser);
    mupClearConst(e->parser);
    for (int i = 0; i < FUNCTIONS; i++) {
        const struct function *f = &functions[i];
        if (f->of_one) mupDefineFun1(e->parser, f->name, f->of_one, 1);
        if (f->of_two) mupDefineFun2(e->parser, f->name, f->of_two, 1);
        if (f->of_any) mupDefineMultFun(e->parser, f->name, f->of_any, 1);
    }
    mupDefineConst(e->parser, "pi", M_PI);
    mupDefineInfixOprt(e->parser, "!", not, 1);
    for (int i = 0; i < e->count; i++) mupDefineVar(e->parser, e->names[i], &e->values[i]);
}

struct expression *expression_new(struct deck_node where, const char *const variables[], int count)
{
    struct expression *e = memory_new(1, sizeof *e);
    e->where = where;
    if (count > EXPRESSION_VARIABLES) die_run("expression_new: %d variables", count);
    for (e->count = 0; e->count < count; e->count++)
        e->names[e->count] = memory_text(variables[e->count]);
    look_over(e);
    e->parser = mupCreate(muBASETYPE_FLOAT);
    mupSetErrorHandler(e->parser, on_error);
    define(e);
    mupSetExpr(e->parser, text_of(e));
    check_parser(e);
    /* Mistakes show only when it is evaluated; a comma gives two values, of which the last would
     * count. */
    int results = 0;
    mupEvalMulti(e->parser, &results);
    check_parser(e);
    if (results != 1) refuse(e, "gives more than one value; the decimal sign is a point");
    return e;
}

void expression_free(struct expression *e)
{
    if (e == NULL) return;
    mupRelease(e->parser);
    for (int i = 0; i < e->count; i++) free(e->names[i]);
    free(e);
}

bool expression_uses(const struct expression *e, int i)
{
    return e->used[i];
}

double expression_value(struct expression *e, const double *variables)
{
    for (int i = 0; i < e->count; i++) e->values[i] = variables[i];
    return mupEval(e->parser);
}

/* "at x = 0.1, t = 0", of the variables that stand in the expression. */
static char *place(const struct expression *e)
{
    char *text = memory_text("");
    for (int i = 0; i < e->count; i++) {
        if (!e->used[i]) continue;
        text = memory_append(text, "%s%s = %g", *text ? ", " : " at ", e->names[i], e->values[i]);
    }
    return text;
}

double expression_try(struct expression *e, const double *variables, const char *unit, double low,
                      double high)
{
    const double value = expression_value(e, variables);
    check_parser(e);
    if (value >= low && value <= high && isfinite(value)) return value;
    const char *shown = strcmp(unit, "1") == 0 ? "" : unit;
    char *where = place(e), *fault = NULL;
    if (isfinite(value))
        fault = memory_print("is %g%s%s%s, expected %g to %g%s%s", value, *shown ? " " : "", shown,
                             where, low, high, *shown ? " " : "", shown);
    else
        fault = memory_print("is %s%s, expected a finite number",
                             isnan(value) ? "not a number" : "infinite", where);
    free(where);
    refuse(e, fault);
}
