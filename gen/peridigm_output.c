#include "memory.h"
#include "peridigm_deck.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

struct variable {
    const char *name, *quantity, *field; /* NULL: not one of these */
    int components;
};
static const struct variable variables[] = {
    {"Displacement", "displacement", "displacement", 3},
    {"Velocity", "velocity", "velocity", 3},
    {"Force", "force", NULL, 3},
    {"Force_Density", NULL, "force", 3},
    {"Damage", "damage", "damage", 1},
    {"Cauchy_Stress", "stress", "stress", 6},
    {"Unrotated_Cauchy_Stress", NULL, "stress", 6},
    {"Von_Mises_Stress", "von_mises", "von_mises", 1},
    {"Block_Id", NULL, "phase", 1},
};

static const struct variable *find_variable(const char *name)
{
    for (size_t i = 0; i < sizeof variables / sizeof *variables; i++)
        if (strcmp(variables[i].name, name) == 0) return &variables[i];
    return NULL;
}

static const char *const suffixes[2][6] = {{"_x", "_y", "_z"},
                                           {"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"}};

/* Columns are named by up to 32 letters, digits and _. */
static void write_column(struct translation *t, const char *label, const struct variable *variable,
                         int component, const char *rest)
{
    const char *suffix =
        variable->components == 1 ? "" : suffixes[variable->components == 6][component];
    const int room = 32 - (int)strlen(suffix);
    fprintf(t->out, "    - {name: ");
    for (int i = 0; label[i] && i < room; i++)
        fputc(isalnum((unsigned char)label[i]) ? label[i] : '_', t->out);
    fprintf(t->out, "%s, quantity: %s%s, %s}\n", suffix, variable->quantity, suffix, rest);
}

/* What stands behind name and quantity, NULL where the class is none of ours. */
static char *place_of(struct translation *t, struct deck_node entry)
{
    static const char *const reductions[4][2] = {
        {"Sum", "sum"}, {"Minimum", "min"}, {"Maximum", "max"}, {"Average", "mean"}};
    const char *kind = take_text(t, entry, "Compute Class");
    double x[3];
    if (kind && strcmp(kind, "Nearest_Point_Data") == 0 &&
        take_number(t, entry, "X", t->length, &x[0]) &&
        take_number(t, entry, "Y", t->length, &x[1]) &&
        take_number(t, entry, "Z", t->length, &x[2]))
        return memory_print("nearest: [%.15g, %.15g, %.15g]", x[0], x[1], x[2]);
    const bool block = kind && strcmp(kind, "Block_Data") == 0,
               set = kind && strcmp(kind, "Node_Set_Data") == 0;
    const char *selected = block ? take_text(t, entry, "Block")
                           : set ? take_text(t, entry, "Node Set")
                                 : NULL,
               *reduction = take_text(t, entry, "Calculation Type");
    for (int i = 0; selected && reduction && i < 4; i++) {
        if (strcmp(reductions[i][0], reduction) != 0) continue;
        char *name = quoted(selected);
        char *text =
            memory_print("reduce: %s, %s: %s", reductions[i][1], block ? "block" : "set", name);
        free(name);
        return text;
    }
    return NULL;
}

static void write_quantities(struct translation *t)
{
    const struct deck_node all = take(t, t->root, "Compute Class Parameters");
    bool begun = false;
    for (int i = 0; all.index && i < deck_count(all); i++) {
        const struct deck_node entry = deck_value(all, i);
        if (!deck_is_map(entry)) continue;
        t->taken[entry.index] = true;
        const char *name = take_text(t, entry, "Variable"),
                   *label = take_text(t, entry, "Output Label");
        const struct variable *variable = name ? find_variable(name) : NULL;
        char *rest = variable && variable->quantity && label ? place_of(t, entry) : NULL;
        if (!rest) {
            cannot_take(t, entry, deck_key(all, i),
                        name && strcmp(name, "Model_Coordinates") == 0
                            ? "places of nodes do not change, and are in the file of fields"
                            : "no column of the history is like it");
            continue;
        }
        if (!begun) fprintf(t->out, "  quantities:\n");
        begun = true;
        for (int c = 0; c < variable->components; c++) write_column(t, label, variable, c, rest);
        free(rest);
    }
}

/* Labels of compute classes are columns of the history, not fields. */
static bool is_label(struct translation *t, const char *key)
{
    const struct deck_node all = take(t, t->root, "Compute Class Parameters");
    for (int i = 0; all.index && i < deck_count(all); i++) {
        const struct deck_node entry = deck_value(all, i);
        const struct deck_node label =
            deck_is_map(entry) ? deck_find(entry, "Output Label") : (struct deck_node){0};
        if (label.index && strcmp(deck_string(label), key) == 0) return true;
    }
    return false;
}

static void write_fields(struct translation *t)
{
    const struct deck_node output = take(t, t->root, "Output"),
                           wanted = take(t, output, "Output Variables");
    const struct variable *last = NULL;
    double every = 1;
    take(t, output, "Output Filename");
    take(t, output, "Output File Type");
    if (wanted.index == 0 || !deck_is_map(wanted)) return;
    take_number(t, output, "Output Frequency", 1, &every);
    for (int i = 0; i < deck_count(wanted); i++) {
        const char *key = deck_key(wanted, i);
        const struct variable *variable = find_variable(key);
        const bool on = strcasecmp(deck_string(deck_value(wanted, i)), "true") == 0;
        if (!on || is_label(t, key)) take(t, wanted, key);
        if (!on || !variable || !variable->field || (last && last->field == variable->field))
            continue;
        take(t, wanted, key);
        if (last)
            fprintf(t->out, ", %s", variable->field);
        else
            fprintf(t->out, "  fields: {every: %.0f steps, variables: [%s", every, variable->field);
        last = variable;
    }
    if (last) fprintf(t->out, "]}\n");
}

void peridigm_output(struct translation *t)
{
    fprintf(t->out, "output:\n  history: 500\n");
    write_quantities(t);
    write_fields(t);
}
