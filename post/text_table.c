#include "text_table.h"

#include "die.h"
#include "headings.h"
#include "layout.h"
#include "memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LONGEST_KEY = 40 };

static const double mega = 1e6;

/* --- above the table
 * --------------------------------------------------------------------------- */

/* "# key: value" as hspost writes it. */
static void read_note(const char *line, struct attributes *facts)
{
    char *note = memory_text(line), *key = note + strspn(note, "# "), *colon = strstr(key, ": ");
    if (colon && colon != key && colon - key <= LONGEST_KEY) {
        *colon = '\0';
        double number;
        const bool text = strcmp(key, "title") == 0 || strcmp(key, "input") == 0;
        if (!text && rows_number(colon + 2, '.', &number))
            attributes_set_number(facts, key, number);
        else
            attributes_set_text(facts, key, colon + 2);
    }
    free(note);
}

static void read_size(const char *words, char decimal, struct attributes *facts)
{
    double value;
    const char *fact = heading_size(words, decimal, &value);
    if (fact) attributes_set_number(facts, fact, value);
}

/* Of thickness and width, or of a diameter; where both are there they do not say. */
static void derive_section(struct attributes *facts)
{
    const double pi = 3.14159265358979323846;
    const double flat = attributes_number(facts, "thickness_m", NAN) *
                        attributes_number(facts, "width_m", NAN),
                 round = pi / 4 * pow(attributes_number(facts, "diameter_m", NAN), 2);
    if (!isnan(attributes_number(facts, "section_m2", NAN)) || isnan(flat) == isnan(round)) return;
    attributes_set_number(facts, "section_m2", isnan(flat) ? round : flat);
}

static void read_above(const struct layout *layout, struct attributes *facts)
{
    for (long i = 0; i < layout->rows.count; i++) {
        const struct row *row = &layout->rows.items[i];
        if (row->kind == ROW_BLANK || (i >= layout->first && row->kind != ROW_NOTE)) continue;
        if (i == layout->names || i == layout->units) continue;
        if (row->kind == ROW_NOTE) read_note(row->fields[0], facts);
        char *words = memory_text("");
        for (int k = 0; k < row->count; k++) words = memory_append(words, " %s", row->fields[k]);
        read_size(words + strspn(words, "# "), layout->rows.decimal, facts);
        free(words);
        if (row->count > 1 && heading_is_specimen(row->fields[0]) && row->fields[1][0])
            attributes_set_text(facts, "title", row->fields[1]);
    }
}

/* --- columns
 * ----------------------------------------------------------------------------------- */

static void fill(double *values, const struct layout *layout, int column, double factor)
{
    long n = 0;
    for (long i = layout->first; i <= layout->last; i++) {
        const struct row *row = &layout->rows.items[i];
        double number;
        if (layout_skips(row)) continue;
        const bool there =
            column < row->count && rows_number(row->fields[column], layout->rows.decimal, &number);
        values[n++] = there ? number * factor : NAN;
    }
}

static long count_rows(const struct layout *layout)
{
    long n = 0;
    for (long i = layout->first; i <= layout->last; i++) n += !layout_skips(&layout->rows.items[i]);
    return n;
}

static const char *name_of(const struct layout *layout, int column)
{
    return layout->names < 0 ? "" : layout->rows.items[layout->names].fields[column];
}

/* Both columns that hspost itself writes. */
static bool is_own(const struct layout *layout)
{
    int found = 0;
    for (int i = 0; layout->names >= 0 && i < layout->columns; i++)
        found += strcmp(name_of(layout, i), "engineering_strain") == 0 ||
                 strcmp(name_of(layout, i), "engineering_stress_MPa") == 0;
    return found >= 2;
}

static void take_all(const struct layout *layout, struct table *table)
{
    static const char megapascal[] = "_MPa";
    const struct row *names = &layout->rows.items[layout->names];
    for (int i = 0; i < layout->columns; i++) {
        const size_t n = strlen(name_of(layout, i)), m = strlen(megapascal);
        if (n == 0) continue;
        const bool scaled = n > m && strcmp(name_of(layout, i) + n - m, megapascal) == 0;
        char *column = memory_print("%.*s%s", (int)(scaled ? n - m : n), name_of(layout, i),
                                    scaled ? "_Pa" : "");
        if (table_find(table, column))
            die_user("%s:%ld:%d: the column '%s' is there twice", layout->name, names->line,
                     names->places[i], name_of(layout, i));
        fill(table_add(table, column), layout, i, scaled ? mega : 1);
        free(column);
    }
}

/* What was found for each quantity: the column, -1 for none. */
struct found {
    int column;
    struct heading heading;
};

static const char *unit_below(const struct layout *layout, int column)
{
    const struct row *units = layout->units < 0 ? NULL : &layout->rows.items[layout->units];
    return units && column < units->count ? units->fields[column] : NULL;
}

static bool is_empty(const struct layout *layout, int column)
{
    for (long i = layout->first; i <= layout->last; i++) {
        const struct row *row = &layout->rows.items[i];
        if (!layout_skips(row) && column < row->count && row->fields[column][0]) return false;
    }
    return true;
}

static void find_by_headings(const struct layout *layout, struct found found[QUANTITIES])
{
    for (int i = 0; layout->names >= 0 && i < layout->columns; i++) {
        const struct heading heading = heading_read(name_of(layout, i), unit_below(layout, i));
        if (heading.quantity == QUANTITIES || is_empty(layout, i)) continue;
        struct found *place = &found[heading.quantity];
        if (place->column >= 0 && place->heading.rank == heading.rank)
            die_user("%s:%ld: two columns of %s, %d '%s' and %d '%s'; say which by --columns-of "
                     "%s=%d",
                     layout->name, layout->rows.items[layout->names].line,
                     quantity_name(heading.quantity), place->column + 1,
                     name_of(layout, place->column), i + 1, name_of(layout, i),
                     quantity_name(heading.quantity), place->column + 1);
        if (place->column >= 0 && place->heading.rank < heading.rank) continue;
        *place = (struct found){i, heading};
    }
}

/* By its number, its heading, or what stands in it before the unit. */
static int column_called(const struct layout *layout, const char *called)
{
    char *end;
    const size_t n = strlen(called);
    const long number = strtol(called, &end, 10);
    if (*end == '\0' && number >= 1 && number <= layout->columns) return (int)number - 1;
    for (int i = 0; i < layout->columns; i++) {
        const char *name = name_of(layout, i);
        if (strncasecmp(name, called, n) == 0 && (!name[n] || strchr(" ([_/,", name[n]))) return i;
    }
    die_user("--columns-of: %s has no column '%s', expected a name or a number from 1 to %d",
             layout->name, called, layout->columns);
}

/* One "stress=NAME:MPa"; cuts it up. */
static void find_by_item(const struct layout *layout, char *item, struct found found[QUANTITIES])
{
    char *name = strchr(item, '=');
    int q = 0;
    if (name) *name++ = '\0';
    while (q < QUANTITIES && strcmp(quantity_name((enum quantity)q), item) != 0) q++;
    if (!name || q == QUANTITIES)
        die_user("--columns-of: '%s', expected strain=NAME,stress=NAME, or force=, extension=, "
                 "time=, transverse=, true_strain=, true_stress=; NAME is a heading or a number",
                 item);
    const char *si = quantity_unit((enum quantity)q);
    char *unit = strrchr(name, ':');
    struct heading heading = {(enum quantity)q, 0, NAN, ""};
    if (unit && !isnan(heading_factor(unit + 1, si))) {
        *unit = '\0';
        heading.factor = heading_factor(unit + 1, si);
        snprintf(heading.unit, sizeof heading.unit, "%.31s", unit + 1);
    }
    const int column = column_called(layout, name);
    if (isnan(heading.factor))
        heading = heading_as((enum quantity)q, name_of(layout, column), unit_below(layout, column));
    found[q] = (struct found){column, heading};
}

static void find_by_choice(const struct layout *layout, const char *columns_of,
                           struct found found[QUANTITIES])
{
    char *text = memory_text(columns_of), *rest = NULL;
    for (char *item = strtok_r(text, ",", &rest); item; item = strtok_r(NULL, ",", &rest))
        find_by_item(layout, item, found);
    free(text);
}

_Noreturn static void refuse_names(const struct layout *layout)
{
    if (layout->names < 0)
        die_user("%s:%ld:1: numbers without a row of column names above them; say which column is "
                 "what, as in --columns-of strain=1,stress=2:MPa",
                 layout->name, layout->rows.items[layout->first].line);
    char *names = memory_text("");
    for (int i = 0; i < layout->columns; i++)
        names = memory_append(names, "%s'%s'", i ? ", " : "", name_of(layout, i));
    die_user(
        "%s:%ld: no columns of strain and stress, or of force and extension, among %s; say which "
        "they are by --columns-of strain=NAME,stress=NAME:MPa",
        layout->name, layout->rows.items[layout->names].line, names);
}

/* engineering strain or extension, and engineering stress or force; else the true ones. */
static void check_found(const struct layout *layout, const struct found found[QUANTITIES])
{
    const bool along = found[QUANTITY_STRAIN].column >= 0 || found[QUANTITY_EXTENSION].column >= 0;
    const bool across = found[QUANTITY_STRESS].column >= 0 || found[QUANTITY_FORCE].column >= 0;
    const bool both =
        found[QUANTITY_TRUE_STRAIN].column >= 0 && found[QUANTITY_TRUE_STRESS].column >= 0;
    if (!(along && across) && !both) refuse_names(layout);
    for (int q = 0; q < QUANTITIES; q++)
        if (found[q].column >= 0 && isnan(found[q].heading.factor))
            die_user(
                "%s:%ld: the column '%s' (%s) has no unit; write it in brackets behind the name, "
                "or --columns-of %s=%d:UNIT",
                layout->name,
                layout->rows.items[layout->names < 0 ? layout->first : layout->names].line,
                name_of(layout, found[q].column), quantity_name((enum quantity)q),
                quantity_name((enum quantity)q), found[q].column + 1);
}

/* Rows without what the curve is made of. */
static void check_blank(const struct layout *layout, const struct found *needed)
{
    for (long i = layout->first; i <= layout->last; i++) {
        const struct row *row = &layout->rows.items[i];
        if (layout_skips(row)) continue;
        if (needed->column < row->count && row->fields[needed->column][0]) continue;
        die_user("%s:%ld: the %s (column %d '%s') is blank in this row, expected a number",
                 layout->name, row->line, quantity_name(needed->heading.quantity),
                 needed->column + 1, name_of(layout, needed->column));
    }
}

static void check_blanks(const struct layout *layout, const struct found found[QUANTITIES])
{
    static const enum quantity choices[][2] = {{QUANTITY_STRAIN, QUANTITY_EXTENSION},
                                               {QUANTITY_STRESS, QUANTITY_FORCE}};
    for (int k = 0; k < 2; k++) {
        const struct found *first = &found[choices[k][0]], *second = &found[choices[k][1]];
        if (first->column >= 0 || second->column >= 0)
            check_blank(layout, first->column >= 0 ? first : second);
    }
}

static void take_found(const struct layout *layout, const struct found found[QUANTITIES],
                       struct table *table)
{
    for (int q = 0; q < QUANTITIES; q++)
        if (found[q].column >= 0)
            fill(table_add(table, quantity_column((enum quantity)q)), layout, found[q].column,
                 found[q].heading.factor);
}

static char *describe(const struct layout *layout, const struct found found[QUANTITIES],
                      const struct attributes *facts)
{
    char *text;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    for (int q = 0; q < QUANTITIES; q++)
        if (found[q].column >= 0)
            fprintf(file, "%s = column %d '%s'%s%s%s, ", quantity_name((enum quantity)q),
                    found[q].column + 1, name_of(layout, found[q].column),
                    found[q].heading.unit[0] ? " in " : "", found[q].heading.unit,
                    found[q].heading.unit[0] ? "" : " as it is");
    const double section = attributes_number(facts, "section_m2", NAN);
    const double length = attributes_number(facts, "gauge_length_m", NAN);
    if (!isnan(section)) fprintf(file, "S0 = %g mm2, ", section * mega);
    if (!isnan(length)) fprintf(file, "L0 = %g mm, ", length * 1e3);
    const struct row *rows = layout->rows.items;
    fprintf(file, "rows from line %ld to %ld (%s, decimal %s)", rows[layout->first].line,
            rows[layout->last].line,
            layout->rows.delimiter == '\t'  ? "tabs"
            : layout->rows.delimiter == ' ' ? "blanks"
            : layout->rows.delimiter == ';' ? "semicolons"
                                            : "commas",
            layout->rows.decimal == '.' ? "points" : "commas");
    fclose(file);
    return text;
}

struct table text_table_read(const char *text, const char *name, const char *columns_of,
                             struct attributes *facts)
{
    struct layout layout = layout_find(text, name, columns_of != NULL);
    read_above(&layout, facts);
    derive_section(facts);
    struct table table = {.n_rows = count_rows(&layout)};
    struct found found[QUANTITIES];
    for (int q = 0; q < QUANTITIES; q++) found[q].column = -1;
    if (!columns_of && is_own(&layout)) {
        take_all(&layout, &table);
    } else {
        if (columns_of)
            find_by_choice(&layout, columns_of, found);
        else
            find_by_headings(&layout, found);
        check_found(&layout, found);
        check_blanks(&layout, found);
        take_found(&layout, found, &table);
        char *words = describe(&layout, found, facts);
        note("%s: %s", name, words);
        attributes_set_text(facts, "table", words);
        free(words);
    }
    rows_free(&layout.rows);
    return table;
}
