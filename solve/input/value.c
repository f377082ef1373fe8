#include "value.h"

#include "memory.h"
#include "units.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const variables[] = {"x", "y", "z", "t"};
enum { VARIABLES = 4, TIME = 3 };

/* Whether a text means to be a number with a unit: "10 m/s" and "10 mm" do, "10*t", "x" and "10/x"
 * do not.  What does must not be taken for an expression, whose faults would mislead. */
static bool looks_like_number(const char *text)
{
    char *end;
    strtod(text, &end);
    if (end == text) return false;
    while (isspace((unsigned char)*end)) end++;
    const unsigned char first = (unsigned char)*end;
    return first == '\0' || isalpha(first) || first == '%' || first > 127;
}

/* Of an expression: the kinds that its variables ask for. */
static int needs(const struct expression *expression)
{
    int needed = expression_uses(expression, TIME) ? VALUE_IN_TIME : 0;
    for (int i = 0; i < TIME; i++)
        if (expression_uses(expression, i)) needed |= VALUE_IN_SPACE;
    return needed;
}

static double read_number(const struct value *value, struct deck_node node)
{
    return deck_number(node, value->unit, value->low, value->high);
}

static void read_scalar(struct value *value, int allowed)
{
    const char *text = deck_string(value->where);
    double number;
    if (!units_read(text, value->unit, &number) || looks_like_number(text)) {
        value->number = read_number(value, value->where);
        return;
    }
    value->kind = VALUE_EXPRESSION;
    value->expression = expression_new(value->where, variables, VARIABLES);
    const int missing = needs(value->expression) & ~allowed;
    if (missing)
        deck_error(value->where, "expression '%.200s': this value cannot depend on %s", text,
                   missing & VALUE_IN_TIME ? "t" : "x, y, z");
}

/* --- {ramp: ..., to: ...} and {initial: ..., increment: ..., every: ...} ---------------------- */

struct given {
    double ramp;
    struct deck_node to, initial, increment, every;
};
#define AT(member) offsetof(struct given, member)

static const struct key ramp_keys[] = {
    {"ramp", KEY_NUMBER, AT(ramp), "s", 1e-15, 1e6, .required = true, .help = "how long it rises"},
    {"to", KEY_NODE, AT(to), .form = "NUMBER", .required = true, .help = "what it comes to"},
};
const struct section section_ramp = {
    .path = "boundary.VALUE (ramp)",
    .help = "From 0 to a number, smoothly: 10 s^3 - 15 s^4 + 6 s^5, s = t/ramp.",
    .keys = KEYS(ramp_keys)};

static const struct key steps_keys[] = {
    {"initial", KEY_NODE, AT(initial), .form = "NUMBER", .required = true, .help = "at the start"},
    {"increment", KEY_NODE, AT(increment), .form = "NUMBER", .required = true,
     .help = "by which it is raised"},
    {"every", KEY_NODE, AT(every), .form = "N steps, or equilibrium", .required = true,
     .help =
         "when; equilibrium: the kinetic energy has been below a thousandth of the internal one "
         "while a wave crosses the body twice; of load steps, after each"},
};
const struct section section_steps = {.path = "boundary.VALUE (steps)",
                                      .help = "A force or body_force that grows in steps.",
                                      .keys = KEYS(steps_keys)};

static void read_ramp(struct value *value)
{
    struct given given;
    keys_read(value->where, &section_ramp, 0, 0, &given, NULL);
    value->kind = VALUE_RAMP;
    value->ramp = given.ramp;
    value->number = read_number(value, given.to);
}

int64_t value_every(struct deck_node where, bool equilibrium)
{
    const char *text = deck_string(where);
    if (equilibrium && strcmp(text, "equilibrium") == 0) return 0;
    char *end;
    const long steps = strtol(text, &end, 10);
    if (!isdigit((unsigned char)*text) || strcmp(end + strspn(end, " "), "steps") != 0)
        deck_error(where, "'%.40s' is not known here, expected such as '250 steps'%s", text,
                   equilibrium ? ", or equilibrium" : "");
    if (steps < 1 || steps > 1000000000)
        deck_error(where, "'%.40s' is out of range, expected 1 to 1000000000 steps", text);
    return steps;
}

static void read_steps(struct value *value)
{
    struct given given;
    keys_read(value->where, &section_steps, 0, 0, &given, NULL);
    const double most = value->high - value->low;
    value->kind = VALUE_STEPS;
    value->number = read_number(value, given.initial);
    value->increment = deck_number(given.increment, value->unit, -most, most);
    value->every = value_every(given.every, true);
}

/* --- tables ----------------------------------------------------------------------------------- */

struct table_given {
    const char *file;
};

static const struct key table_keys[] = {
    {"table", KEY_TEXT, offsetof(struct table_given, file), .form = "FILE", .required = true,
     .help = "two numbers a line, time and value in SI, between them a comma, semicolon, tab or "
             "blanks; lines of words and those with # are left out"},
};
const struct section section_table = {
    .path = "boundary.VALUE (table)",
    .help = "A value over time from a file, linear between its rows, standing beyond them; load "
            "steps end at each.",
    .keys = KEYS(table_keys)};

static void add_row(struct value *value, double time, double number)
{
    const int n = value->n_rows;
    value->times = memory_grow(value->times, n, sizeof *value->times);
    value->values = memory_grow(value->values, n, sizeof *value->values);
    value->times[n] = time;
    value->values[n] = number;
    value->n_rows++;
}

static void read_rows(struct value *value)
{
    value->kind = VALUE_TABLE;
    for (int i = 0; i < deck_count(value->where); i++) {
        const struct deck_node row = deck_item(value->where, i);
        if (!deck_is_list(row) || deck_count(row) != 2)
            deck_error(row, "expected a row of a table: [time, value]");
        const double time = deck_number(deck_item(row, 0), "s", 0, 1e12);
        if (i > 0 && !(time > value->times[i - 1]))
            deck_error(row, "its time, %g s, is not after that of the row before", time);
        add_row(value, time, read_number(value, deck_item(row, 1)));
    }
}

/* The numbers of a line: 2, else 0 of one that holds words, or nothing. */
static int read_line(char *line, double numbers[2])
{
    int count = 0;
    line[strcspn(line, "#\r\n")] = '\0';
    for (char *at = line, *end; *(at += strspn(at, " \t,;")); at = end, count++) {
        const double number = strtod(at, &end);
        if (end == at || (*end && !strchr(" \t,;", *end))) return 0;
        if (count < 2) numbers[count] = number;
    }
    return count;
}

static void read_file(struct value *value)
{
    struct table_given given;
    keys_read(value->where, &section_table, 0, 0, &given, NULL);
    const struct deck_node where = deck_get(value->where, "table");
    char line[4096];
    double numbers[2];
    FILE *file = fopen(given.file, "r");
    if (!file) deck_error(where, "cannot open %s: %s", given.file, strerror(errno));
    value->kind = VALUE_TABLE;
    for (int k = 1; fgets(line, sizeof line, file); k++) {
        const int count = read_line(line, numbers);
        if (count == 0) continue;
        if (count != 2)
            deck_error(where, "%s:%d: %d numbers, expected time and value", given.file, k, count);
        if (value->n_rows > 0 && !(numbers[0] > value->times[value->n_rows - 1]))
            deck_error(where, "%s:%d: its time, %g s, is not after that of the row before",
                       given.file, k, numbers[0]);
        if (!(numbers[1] >= value->low && numbers[1] <= value->high))
            deck_error(where, "%s:%d: %g %s is out of range, expected %g to %g", given.file, k,
                       numbers[1], value->unit, value->low, value->high);
        add_row(value, numbers[0], numbers[1]);
    }
    fclose(file);
    if (value->n_rows < 2)
        deck_error(where, "%s: %d rows of two numbers, expected two or more", given.file,
                   value->n_rows);
}

static double table_at(const struct value *value, double time)
{
    const double *t = value->times, *v = value->values;
    int low = 0, high = value->n_rows - 1;
    if (time <= t[low]) return v[low];
    if (time >= t[high]) return v[high];
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(t[middle] <= time ? &low : &high) = middle;
    }
    return v[low] + (time - t[low]) / (t[high] - t[low]) * (v[high] - v[low]);
}

double value_next_row(const struct value *value, double time)
{
    for (int i = 0; i < value->n_rows; i++)
        if (value->times[i] > time) return value->times[i];
    return INFINITY;
}

static _Noreturn void wrong_kind(const struct value *value, int allowed)
{
    deck_error(value->where, "expected a number in %s%s%s%s", value->unit,
               allowed & (VALUE_IN_SPACE | VALUE_IN_TIME) ? ", an expression" : "",
               allowed & VALUE_IN_TIME
                   ? ", {ramp: ..., to: ...}, a table [[time, value], ...] or {table: FILE}"
                   : "",
               allowed & VALUE_STEPPED ? ", {initial: ..., increment: ..., every: ...}" : "");
}

struct value value_read(struct deck_node where, const char *unit, double low, double high,
                        int allowed)
{
    struct value value = {.where = where, .unit = unit, .low = low, .high = high};
    if (deck_is_scalar(where))
        read_scalar(&value, allowed);
    else if (deck_is_list(where) && (allowed & VALUE_IN_TIME) && deck_count(where) > 1)
        read_rows(&value);
    else if (!deck_is_map(where))
        wrong_kind(&value, allowed);
    else if (deck_has(where, "table") && (allowed & VALUE_IN_TIME))
        read_file(&value);
    else if (deck_has(where, "ramp") && (allowed & VALUE_IN_TIME))
        read_ramp(&value);
    else if (deck_has(where, "increment") && (allowed & VALUE_STEPPED))
        read_steps(&value);
    else
        wrong_kind(&value, allowed);
    return value;
}

void value_free(struct value *value)
{
    expression_free(value->expression);
    free(value->times);
    free(value->values);
    *value = (struct value){0};
}

bool value_depends_on_place(const struct value *value)
{
    return value->expression && (needs(value->expression) & VALUE_IN_SPACE);
}

bool value_depends_on_time(const struct value *value)
{
    if (value->kind == VALUE_EXPRESSION) return needs(value->expression) & VALUE_IN_TIME;
    return value->kind != VALUE_CONSTANT;
}

double value_rise(double s)
{
    if (s <= 0) return 0;
    return s >= 1 ? 1 : s * s * s * (10 + s * (6 * s - 15));
}

double value_at(const struct value *value, const double x[3], double time)
{
    switch (value->kind) {
    case VALUE_EXPRESSION:
        return expression_value(value->expression, (const double[]){x[0], x[1], x[2], time});
    case VALUE_RAMP:
        return value_rise(time / value->ramp) * value->number;
    case VALUE_STEPS:
        return value->number + (double)value->raised * value->increment;
    case VALUE_TABLE:
        return table_at(value, time);
    case VALUE_CONSTANT:
        break;
    }
    return value->number;
}

void value_try(const struct value *value, const double x[3], double end_time)
{
    enum { TIMES = 3 };
    for (int k = 0; value->expression && k < TIMES; k++) {
        const double at[] = {x[0], x[1], x[2], 0.5 * k * end_time};
        expression_try(value->expression, at, value->unit, value->low, value->high);
    }
}

bool value_raise(struct value *value, int64_t steps, bool equilibrium)
{
    if (value->kind != VALUE_STEPS) return false;
    const bool due = value->every ? steps > 0 && steps % value->every == 0 : equilibrium;
    if (!due) return false;
    value->raised++;
    const double now = value_at(value, (const double[]){0, 0, 0}, 0);
    if (!(now >= value->low && now <= value->high))
        deck_error(value->where, "has grown to %g %s after %lld increments, expected %g to %g", now,
                   value->unit, (long long)value->raised, value->low, value->high);
    return true;
}
