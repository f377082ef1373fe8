#include "layout.h"

#include "die.h"
#include "headings.h"

#include <stddef.h>
#include <string.h>

enum { FEWEST_OF_A_TABLE = 3 };

/* Empty fields at the end, as a delimiter behind the last number makes them, do not count. */
static int filled(const struct row *row)
{
    int n = row->count;
    while (n > 0 && row->fields[n - 1][0] == '\0') n--;
    return n;
}

bool layout_skips(const struct row *row)
{
    return row->kind == ROW_BLANK || row->kind == ROW_NOTE;
}

_Noreturn static void refuse_field(const struct layout *layout, const struct row *row)
{
    double unused;
    int i = 0;
    while (row->fields[i][0] == '\0' || rows_number(row->fields[i], layout->rows.decimal, &unused))
        i++;
    const char mark = layout->rows.decimal == '.' ? ',' : '.';
    die_user("%s:%ld:%d: '%s' is not a finite number%s", layout->name, row->line, row->places[i],
             row->fields[i],
             rows_is_grouped(row->fields[i], mark)
                 ? ": thousands or decimals? the other numbers of its column do not say"
                 : "");
}

/* Whether a row was meant to be one of the table: all its fields begin as numbers do. */
static bool is_data(const struct row *row)
{
    int count = 0;
    for (int i = 0; i < row->count; i++) {
        const char *field = row->fields[i];
        if (!*field) continue;
        if (!strchr("0123456789", field[strspn(field, "+-.,")]) || !field[strspn(field, "+-.,")])
            return false;
        count++;
    }
    return count > 1;
}

/* The longest run of rows of numbers that follow each other. */
static void find_numbers(struct layout *layout)
{
    const struct row *rows = layout->rows.items, *mixed = NULL;
    long run = 0, most = 0, first = -1, begin = -1;
    for (long i = 0; i < layout->rows.count; i++) {
        if (layout_skips(&rows[i])) continue;
        if (rows[i].kind == ROW_MIXED && !mixed) mixed = &rows[i];
        const bool goes_on = rows[i].kind == ROW_NUMBERS;
        if (goes_on && run == 0) begin = i;
        run = goes_on ? run + 1 : 0;
        if (run <= most) continue;
        most = run;
        first = begin;
        layout->last = i;
    }
    if (most == 0 && mixed) refuse_field(layout, mixed);
    if (most == 0) die_user("%s: no row of numbers below the header", layout->name);
    layout->first = first;
}

/* Row above one that holds something; -1. */
static long row_above(const struct layout *layout, long row)
{
    while (--row >= 0 && layout_skips(&layout->rows.items[row])) continue;
    return row;
}

static bool is_units(const struct row *row)
{
    for (int i = 0; i < row->count; i++)
        if (row->fields[i][0] && !heading_is_unit(row->fields[i])) return false;
    return true;
}

/* The note right above the numbers, where it holds as many fields as they do: "# strain,stress
 * (MPa)". */
static long find_note(struct layout *layout)
{
    struct rows *rows = &layout->rows;
    for (long i = layout->first - 1; i >= 0; i--) {
        if (rows->items[i].kind == ROW_BLANK) continue;
        if (rows_of_note(rows, i) == filled(&rows->items[layout->first])) return i;
        break;
    }
    return -1;
}

static void find_header(struct layout *layout)
{
    const struct row *rows = layout->rows.items;
    long above = row_above(layout, layout->first);
    layout->names = layout->units = -1;
    if (above < 0) above = find_note(layout);
    if (above < 0) return;
    if (rows[above].kind == ROW_MIXED || is_data(&rows[above])) refuse_field(layout, &rows[above]);
    const long before = row_above(layout, above);
    const bool has_units = before >= 0 && is_units(&rows[above]) && filled(&rows[before]) > 1;
    layout->units = has_units ? above : -1;
    layout->names = has_units ? before : above;
}

/* The row that parts the numbers from row i on from more of them, where it is no row of names. */
static void refuse_gap(const struct layout *layout, long i)
{
    const struct row *rows = layout->rows.items;
    while (i < layout->rows.count && (rows[i].kind == ROW_NUMBERS || layout_skips(&rows[i]))) i++;
    const bool within = i + 1 < layout->rows.count && rows[i + 1].kind == ROW_NUMBERS;
    if (!within || filled(&rows[i]) != filled(&rows[i + 1])) return;
    for (int k = 0; k < rows[i].count; k++)
        if (heading_read(rows[i].fields[k], NULL).quantity != QUANTITIES) return;
    refuse_field(layout, &rows[i]);
}

/* Numbers between two rows outside the table are no second table. */
static void check_outside(const struct layout *layout, long from, long to)
{
    const struct row *rows = layout->rows.items;
    long count = 0, line = 0;
    for (long i = from; i < to; i++) {
        if (rows[i].kind != ROW_NUMBERS || rows[i].count < 2) continue;
        if (count == 0) line = rows[i].line;
        if (++count == FEWEST_OF_A_TABLE) {
            refuse_gap(layout, i);
            die_user(
                "%s:%ld: a second table of numbers beside that of lines %ld to %ld: one table a "
                "file",
                layout->name, line, rows[layout->first].line, rows[layout->last].line);
        }
    }
}

/* What is no footer of words is an error. */
static void check_footer(const struct layout *layout)
{
    const struct row *rows = layout->rows.items;
    bool words = false;
    for (long i = layout->last + 1; i < layout->rows.count; i++) {
        const bool data =
            rows[i].kind != ROW_NUMBERS && !layout_skips(&rows[i]) && is_data(&rows[i]);
        if (data || (rows[i].kind == ROW_MIXED && !words)) refuse_field(layout, &rows[i]);
        words = words || rows[i].kind == ROW_WORDS;
    }
}

/* All rows as long as the names, or as the first one. */
static void check_lengths(struct layout *layout, bool chosen)
{
    const struct row *rows = layout->rows.items;
    const int names = layout->names < 0 ? 0 : filled(&rows[layout->names]);
    if (names > 0 && layout->rows.delimiter == ' ' && names != filled(&rows[layout->first])) {
        if (!chosen)
            die_user(
                "%s:%ld: %d words above %d columns of numbers; quote names that hold blanks, or "
                "say which column is what, as in --columns-of strain=1,stress=2:MPa",
                layout->name, rows[layout->names].line, names, filled(&rows[layout->first]));
        layout->names = layout->units = -1;
    }
    const struct row *model = &rows[layout->names >= 0 ? layout->names : layout->first];
    layout->columns = model->count;
    for (long i = layout->first; i <= layout->last; i++) {
        if (layout_skips(&rows[i])) continue;
        if (filled(&rows[i]) > layout->columns)
            die_user("%s:%ld:%d: more fields than the %d columns of the header", layout->name,
                     rows[i].line, rows[i].places[layout->columns], layout->columns);
        if (rows[i].count < filled(model))
            die_user("%s:%ld: %d fields, expected %d", layout->name, rows[i].line, rows[i].count,
                     filled(model));
    }
}

struct layout layout_find(const char *text, const char *name, bool chosen)
{
    struct layout layout = {.name = name, .rows = rows_read(text)};
    find_numbers(&layout);
    find_header(&layout);
    check_outside(&layout, 0, layout.names);
    check_footer(&layout);
    check_outside(&layout, layout.last + 1, layout.rows.count);
    check_lengths(&layout, chosen);
    return layout;
}
