#include "translation.h"

#include "die.h"
#include "memory.h"
#include "units.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static double factor_of(const char *unit, const char *si)
{
    double factor;
    char *text = memory_print("1 %s", unit);
    const char *fault = units_read(text, si, &factor);
    free(text);
    if (fault || !(factor > 0))
        die_user("--units: '%s' is no unit of %s; expected such as cm,g,s (length, mass, time)",
                 unit,
                 *si == 'm'   ? "length"
                 : *si == 'k' ? "mass"
                              : "time");
    return factor;
}

struct translation translation_new(struct deck *deck, struct deck_node root, const char *units,
                                   FILE *out)
{
    static const char *const si[3] = {"m", "kg", "s"};
    struct translation t = {.deck = deck, .root = root, .out = out};
    double *factors[3] = {&t.length, &t.mass, &t.time};
    char *text = memory_text(units ? units : "m,kg,s"), *rest = text;
    for (int i = 0; i < 3; i++) {
        const char *unit = strsep(&rest, ",");
        if (!unit || !*unit || (i == 2 && rest))
            die_user("--units '%s': expected three, of length, mass and time, such as cm,g,s",
                     units);
        t.unit[i] = memory_text(unit);
        *factors[i] = factor_of(unit, si[i]);
    }
    free(text);
    /* A document has no more nodes than its text characters. */
    t.taken = memory_new(strlen(deck_text(deck)) + 2, sizeof *t.taken);
    return t;
}

void translation_free(struct translation *t)
{
    for (int i = 0; i < 3; i++) free((char *)(uintptr_t)t->unit[i]);
    free(t->taken);
}

struct deck_node take(struct translation *t, struct deck_node map, const char *key)
{
    const struct deck_node none = {0};
    if (map.index == 0 || !deck_is_map(map)) return none;
    const struct deck_node value = deck_find(map, key);
    if (value.index) t->taken[value.index] = true;
    return value;
}

const char *take_text(struct translation *t, struct deck_node map, const char *key)
{
    const struct deck_node value = take(t, map, key);
    return value.index ? deck_string(value) : NULL;
}

bool take_number(struct translation *t, struct deck_node map, const char *key, double factor,
                 double *number)
{
    const struct deck_node value = take(t, map, key);
    if (value.index == 0) return false;
    char *end;
    const char *text = deck_string(value);
    const double read = strtod(text, &end);
    if (end == text || *end) {
        t->taken[value.index] = false;
        return false;
    }
    *number = read * factor;
    return true;
}

/* All within it is told with it. */
static void take_all(struct translation *t, struct deck_node value)
{
    t->taken[value.index] = true;
    for (int i = 0; deck_is_map(value) && i < deck_count(value); i++)
        take_all(t, deck_value(value, i));
}

void cannot_take(struct translation *t, struct deck_node value, const char *key, const char *why)
{
    take_all(t, value);
    if (deck_is_scalar(value))
        warn("%s:%d: '%s: %.60s' is not taken: %s", deck_name(t->deck), deck_line(value), key,
             deck_string(value), why);
    else
        warn("%s:%d: '%s' is not taken: %s", deck_name(t->deck), deck_line(value), key, why);
}

static void say_left_of(struct translation *t, struct deck_node map, const char *const why[])
{
    for (int i = 0; i < deck_count(map); i++) {
        const struct deck_node value = deck_value(map, i);
        const char *key = deck_key(map, i), *reason = "it has no counterpart";
        for (int k = 0; why[k]; k += 2)
            if (strcmp(why[k], key) == 0) reason = why[k + 1];
        if (!t->taken[value.index])
            cannot_take(t, value, key, reason);
        else if (deck_is_map(value))
            say_left_of(t, value, why);
    }
}

void say_what_is_left(struct translation *t, const char *const why[])
{
    say_left_of(t, t->root, why);
}

char *quoted(const char *name)
{
    char *text = memory_new(2 * strlen(name) + 3, 1), *to = text;
    *to++ = '"';
    for (const char *c = name; *c; c++) {
        if (*c == '"' || *c == '\\') *to++ = '\\';
        *to++ = *c;
    }
    *to = '"';
    return text;
}

/* Assignments and ends of statements; comparisons are none. */
static bool is_programme(const char *text)
{
    for (const char *c = text; *c; c++) {
        if (*c == ';' || *c == '{') return true;
        if (*c == '=' && c[1] != '=' && (c == text || !strchr("=<>!", c[-1]))) return true;
    }
    return false;
}

char *translate_expression(const struct translation *t, const char *text, double factor)
{
    char *end, *body = NULL, *done;
    size_t length = 0;
    const double number = strtod(text, &end);
    if (end != text && end[strspn(end, " ")] == '\0') return memory_print("%.15g", number * factor);
    if (is_programme(text)) return NULL;
    FILE *stream = open_memstream(&body, &length);
    for (const char *c = text; *c;) {
        size_t word = 0;
        while (isalnum((unsigned char)c[word]) || c[word] == '_' || c[word] == '.') word++;
        const bool place = word == 1 && strchr("xyz", *c), time = word == 1 && *c == 't';
        const double unit = place ? t->length : time ? t->time : 1;
        if (unit != 1)
            fprintf(stream, "(%c/%.15g)", *c, unit);
        else
            fwrite(c, 1, word ? word : 1, stream);
        c += word ? word : 1;
    }
    fclose(stream);
    done =
        factor == 1 ? memory_print("\"%s\"", body) : memory_print("\"%.15g*(%s)\"", factor, body);
    free(body);
    return done;
}
