#include "memory.h"
#include "peridigm_deck.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Kinds of conditions, in any writing of blanks and underlines. */
struct kind {
    const char *name, *ours;
    bool initial;
};
static const struct kind kinds[] = {
    {"Prescribed Displacement", "displacement", false},
    {"Prescribed Velocity", "velocity", false},
    {"Body Force", "body_force", false},
    {"Initial Displacement", "displacement", true},
    {"Initial Velocity", "velocity", true},
};

static bool same_words(const char *a, const char *b)
{
    while (*a && *b && tolower((unsigned char)(*a == '_' ? ' ' : *a)) == tolower((unsigned char)*b))
        a++, b++;
    return !*a && !*b;
}

static double factor_of(const struct translation *t, const struct kind *kind)
{
    if (strcmp(kind->ours, "displacement") == 0) return t->length;
    if (strcmp(kind->ours, "velocity") == 0) return t->length / t->time;
    return t->mass / (t->length * t->length * t->time * t->time);
}

/* A value may say what it assigns to: "value = 10*t". */
static const char *assigned(const char *text)
{
    static const char name[] = "value";
    const char *rest = text + strspn(text, " \t");
    if (strncmp(rest, name, strlen(name)) != 0) return text;
    rest += strlen(name);
    rest += strspn(rest, " \t");
    if (rest[0] != '=' || rest[1] == '=') return text;
    return rest + 1 + strspn(rest + 1, " \t");
}

static void write_condition(struct translation *t, struct deck_node entry, const char *name,
                            const struct kind *kind)
{
    const char *set = take_text(t, entry, "Node Set"), *axis = take_text(t, entry, "Coordinate"),
               *value = take_text(t, entry, "Value");
    char *text = value ? translate_expression(t, assigned(value), factor_of(t, kind)) : NULL;
    if (!set || !axis || !text || strlen(axis) != 1 || !strchr("xyzXYZ", *axis)) {
        cannot_take(t, entry, name,
                    "expected 'Node Set', 'Coordinate' of x, y or z, and 'Value', one expression");
        return;
    }
    char *own = quoted(set);
    const bool all = same_words(set, "Full Domain");
    fprintf(t->out, "  - {%s: %s, direction: %c, %s: %s}\n", all ? "where" : "set",
            all ? "\"1\"" : own, tolower((unsigned char)*axis), kind->ours, text);
    free(own);
    free(text);
}

static void write_conditions(struct translation *t, bool initial)
{
    const struct deck_node all = take(t, t->root, "Boundary Conditions");
    bool begun = false;
    for (int i = 0; all.index && i < deck_count(all); i++) {
        const struct deck_node entry = deck_value(all, i);
        if (!deck_is_map(entry)) continue;
        t->taken[entry.index] = true;
        const char *type = take_text(t, entry, "Type");
        const struct kind *kind = NULL;
        for (size_t k = 0; type && k < sizeof kinds / sizeof *kinds; k++)
            if (same_words(type, kinds[k].name)) kind = &kinds[k];
        if (!kind && initial)
            cannot_take(t, entry, deck_key(all, i), "conditions of this type have no counterpart");
        if (!kind || kind->initial != initial) continue;
        if (!begun) fprintf(t->out, "%s:\n", initial ? "initial" : "boundary");
        begun = true;
        write_condition(t, entry, deck_key(all, i), kind);
    }
}

void peridigm_boundary(struct translation *t)
{
    write_conditions(t, false);
    write_conditions(t, true);
}

int peridigm_axis(struct translation *t)
{
    const struct deck_node all = take(t, t->root, "Boundary Conditions");
    int axis = -1;
    for (int i = 0; all.index && i < deck_count(all); i++) {
        const struct deck_node entry = deck_value(all, i);
        if (!deck_is_map(entry)) continue;
        const char *coordinate = take_text(t, entry, "Coordinate"),
                   *value = take_text(t, entry, "Value"), *type = take_text(t, entry, "Type");
        const bool holds =
            type && (same_words(type, kinds[0].name) || same_words(type, kinds[1].name));
        char *end = NULL;
        if (!holds || !coordinate || !value) continue;
        const bool still = strtod(value, &end) == 0 && end != value && *end == '\0';
        const int own = tolower((unsigned char)*coordinate) - 'x';
        if (still || own < 0 || own > 2) continue;
        if (axis >= 0 && axis != own) return 0;
        axis = own;
    }
    return axis > 0 ? axis : 0;
}

void peridigm_node_sets(struct translation *t)
{
    const struct deck_node all = take(t, t->root, "Boundary Conditions");
    bool begun = false;
    for (int i = 0; all.index && i < deck_count(all); i++) {
        const struct deck_node value = deck_value(all, i);
        if (!deck_is_scalar(value)) continue;
        t->taken[value.index] = true;
        const char *text = deck_string(value);
        const bool numbers = text[strspn(text, "0123456789 ,\t\n")] == '\0';
        char *name = quoted(deck_key(all, i)), *file = quoted(text);
        fprintf(t->out, "%s    %s: ", begun ? "" : "  node_sets:\n", name);
        begun = true;
        if (!numbers) fprintf(t->out, "%s\n", file);
        if (numbers) fprintf(t->out, "[");
        for (const char *c = text; numbers && *c;) {
            c += strspn(c, " ,\t\n");
            const int digits = (int)strspn(c, "0123456789");
            const char *next = c + digits;
            next += strspn(next, " ,\t\n");
            if (digits > 0) fprintf(t->out, "%.*s%s", digits, c, *next ? ", " : "");
            c = next;
        }
        if (numbers) fprintf(t->out, "]\n");
        free(name);
        free(file);
    }
}
