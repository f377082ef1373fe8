#include "rows.h"

#include "memory.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_NUMBER = 64, SAMPLE = 2000, MOST_COLUMNS = 100 };

static char nothing[1] = "";

/* Whether marks part groups of three digits, and a decimal mark follows: "1,234.5", which can
 * mean nothing else. */
static bool is_grouped(const char *text, char mark, char decimal)
{
    const char *from = text + strspn(text, "+-"), *end = strchr(from, decimal);
    const char *group = strchr(from, mark);
    if (!end || !group || group == from || group - from > 3) return false;
    for (; group < end; group += 4)
        if (*group != mark || end - group < 4 || strspn(group + 1, "0123456789") < 3) return false;
    return group == end && !strchr(end, mark);
}

bool rows_is_grouped(const char *text, char mark)
{
    const char *from = text + strspn(text, "+-"), *group = strchr(from, mark);
    if (!group || *from == '0' || group - from < 1 || group - from > 3) return false;
    if (strspn(from, "0123456789") != (size_t)(group - from)) return false;
    for (; *group; group += 4)
        if (*group != mark || strspn(group + 1, "0123456789") < 3) return false;
    return true;
}

bool rows_number(const char *text, char decimal, double *value)
{
    char copy[LONGEST_NUMBER], *to = copy, *end;
    const char mark = decimal == '.' ? ',' : '.';
    const size_t length = strlen(text);
    if (length == 0 || length >= sizeof copy) return false;
    const bool grouped = is_grouped(text, mark, decimal);
    if (!grouped && strchr(text, mark)) return false;
    for (; *text; text++)
        if (*text != mark) *to++ = *text == decimal ? '.' : *text;
    *to = '\0';
    if (strspn(copy, "+-.0123456789eE") != (size_t)(to - copy)) return false;
    *value = strtod(copy, &end);
    return *end == '\0' && isfinite(*value);
}

/* The text from a quote on without its quotes; returns what follows the closing one. */
static char *unquote(char *field)
{
    char *to = field, *from = field + 1;
    for (; *from; from++) {
        if (*from == '"' && from[1] != '"') break;
        if (*from == '"') from++;
        *to++ = *from;
    }
    char *rest = *from ? from + 1 : from;
    *to = '\0';
    return rest;
}

/* Cuts the field that begins at *line, behind blanks; *line becomes NULL at the last one. */
static char *next_field(char **line, char delimiter)
{
    const char ends[] = {delimiter, delimiter == ' ' ? '\t' : '\0', '\0'};
    char *field = *line;
    while (isspace((unsigned char)*field) && *field != delimiter) field++;
    char *rest = *field == '"' ? unquote(field) : field;
    char *end = rest + strcspn(rest, ends);
    *line = *end ? end + 1 : NULL;
    if (*line && delimiter == ' ') {
        *line += strspn(*line, " \t");
        if (**line == '\0') *line = NULL;
    }
    *end = '\0';
    for (size_t n = strlen(field); n > 0 && isspace((unsigned char)field[n - 1]);)
        field[--n] = '\0';
    return field;
}

/* By its fields; counts the numbers. */
static enum row_kind judge(struct row *row, char decimal)
{
    bool first = false;
    int numbers = 0, words = 0;
    for (int k = 0; k < row->count; k++) {
        const char *field = row->fields[k];
        double unused;
        const bool number = rows_number(field, decimal, &unused);
        first = first || (number && words == 0);
        numbers += number;
        words += !number && *field;
    }
    row->numbers = numbers;
    if (numbers == 0 && words == 0) return ROW_BLANK;
    return words == 0 ? ROW_NUMBERS : first ? ROW_MIXED : ROW_WORDS;
}

/* Cuts a line in place; fields and places have room for it. */
static enum row_kind cut(struct row *row, char *line, char delimiter, char decimal)
{
    const char *begin = line;
    row->count = 0;
    if (delimiter == ' ') line += strspn(line, " \t");
    for (char *rest = line; rest; row->count++) {
        char *field = next_field(&rest, delimiter);
        row->fields[row->count] = field;
        row->places[row->count] = (int)(field - begin) + 1;
    }
    return judge(row, decimal);
}

/* How many fields a line may have at most. */
static size_t most_fields(const char *line)
{
    size_t n = 2;
    for (; *line; line++) n += *line == '\t' || *line == ';' || *line == ',' || *line == ' ';
    return n;
}

static void make_row(struct row *row, char *line, const struct rows *format)
{
    const bool note = line[strspn(line, " \t\"")] == '#';
    const size_t most = note ? 1 : most_fields(line);
    row->fields = memory_new(most, sizeof *row->fields);
    row->places = memory_new(most, sizeof *row->places);
    if (note)
        *row = (struct row){ROW_NOTE, row->line, 1, 0, row->fields, row->places, NULL};
    else
        row->kind = cut(row, line, format->delimiter, format->decimal);
    if (note) row->fields[0] = line;
}

/* Cuts the text at the next line end, of whatever system; NULL at the end. */
static char *next_line(char **text)
{
    char *line = *text;
    if (!*line) return NULL;
    char *end = line + strcspn(line, "\r\n");
    const size_t width = *end == '\0' ? 0 : end[0] == '\r' && end[1] == '\n' ? 2 : 1;
    *text = end + width;
    *end = '\0';
    return line;
}

static void row_free(struct row *row)
{
    free(row->fields);
    free(row->places);
    free(row->own);
}

/* Lines of two or more numbers; without any, those that begin so; else those that have so many. */
static double score(const char *text, const struct rows *format)
{
    char *copy = memory_text(text), *rest = copy;
    double whole = 0, begun = 0, some = 0;
    int i = 0;
    for (char *line; i < SAMPLE && (line = next_line(&rest)); i++) {
        struct row row = {0};
        make_row(&row, line, format);
        whole += row.kind == ROW_NUMBERS && row.count > 1;
        begun += row.kind == ROW_MIXED && row.count > 1;
        some += row.numbers > 1;
        row_free(&row);
    }
    free(copy);
    return (whole * SAMPLE + begun) * SAMPLE + some;
}

/* Fields of the rows with two or more numbers, as most of them have. */
static int usual_count(const struct rows *rows)
{
    int usual = 0;
    long most = 0;
    for (int n = 2; n <= MOST_COLUMNS; n++) {
        long count = 0;
        for (long i = 0; i < rows->count; i++)
            count += rows->items[i].numbers > 1 && rows->items[i].count == n;
        if (count <= most) continue;
        most = count;
        usual = n;
    }
    return usual;
}

/* Blanks a column in the rows of the table where more of them hold words than numbers: remarks,
 * times of the day. */
static void blank_column(struct rows *rows, int usual, int column)
{
    long words = 0, numbers = 0;
    double unused;
    for (int pass = 0; pass < 2; pass++)
        for (long i = 0; i < rows->count; i++) {
            struct row *row = &rows->items[i];
            if (row->numbers < 2 || row->count != usual || !row->fields[column][0]) continue;
            const bool number = rows_number(row->fields[column], rows->decimal, &unused);
            if (pass == 0) {
                numbers += number;
                words += !number;
            } else if (words > numbers) {
                row->numbers -= number;
                row->fields[column] = nothing;
            }
        }
}

/* How the numbers of a column are written. */
struct writing {
    long grouped;      /* whole, in groups of three digits */
    long small, large; /* whole, without marks, to 999 and above */
    long decimal;
    long other; /* "1.04" */
};

static void count_writing(const char *field, char decimal, struct writing *writing)
{
    const char mark = decimal == '.' ? ',' : '.';
    const char *digits = field + strspn(field, "+-");
    double unused;
    if (!strchr("0123456789", *digits) || !*digits) return;
    const bool number = rows_number(field, decimal, &unused), whole = !strchr(field, decimal);
    writing->grouped += whole && rows_is_grouped(field, mark);
    writing->small += number && whole && strlen(digits) <= 3;
    writing->large += number && whole && strlen(digits) > 3;
    writing->decimal += number && !whole;
    writing->other += !number && !(whole && rows_is_grouped(field, mark));
}

static void take_marks_out(char *field, char mark)
{
    char *to = field;
    for (; *field; field++)
        if (*field != mark) *to++ = *field;
    *to = '\0';
}

/* "1.004" of a table with decimal commas is one thousand and four where its column says so: by
 * decimal commas of its own, or by whole numbers below a thousand without a mark, and none above.
 */
static void ungroup(struct rows *rows)
{
    const char mark = rows->decimal == '.' ? ',' : '.';
    const int usual = usual_count(rows);
    struct writing writings[MOST_COLUMNS] = {0};
    long decimals = 0;
    for (long i = 0; i < rows->count; i++)
        for (int k = 0; rows->items[i].count == usual && k < usual; k++)
            count_writing(rows->items[i].fields[k], rows->decimal, &writings[k]);
    for (int k = 0; k < usual; k++) decimals += writings[k].decimal;
    for (int k = 0; decimals > 0 && k < usual; k++) {
        const struct writing *w = &writings[k];
        if (w->grouped == 0 || w->other + w->large > 0 || w->decimal + w->small == 0) continue;
        for (long i = 0; i < rows->count; i++) {
            struct row *row = &rows->items[i];
            if (row->count != usual || !rows_is_grouped(row->fields[k], mark)) continue;
            take_marks_out(row->fields[k], mark);
            row->kind = judge(row, rows->decimal);
        }
    }
}

static void blank_words(struct rows *rows)
{
    const int usual = usual_count(rows);
    for (int k = 0; k < usual; k++) blank_column(rows, usual, k);
    for (long i = 0; i < rows->count; i++) {
        struct row *row = &rows->items[i];
        int filled = 0;
        for (int k = 0; k < row->count; k++) filled += row->fields[k][0] != '\0';
        if (row->numbers > 1 && row->numbers == filled) row->kind = ROW_NUMBERS;
    }
}

struct rows rows_read(const char *text)
{
    static const char formats[][2] = {{',', '.'}, {'\t', '.'}, {'\t', ','}, {';', '.'},
                                      {';', ','}, {' ', '.'},  {' ', ','},  {',', ','}};
    struct rows rows = {',', '.', 0, NULL, memory_text(text)};
    double best = 0;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const struct rows format = {.delimiter = formats[i][0], .decimal = formats[i][1]};
        const double found = score(text, &format);
        if (found <= best) continue;
        best = found;
        rows.delimiter = format.delimiter;
        rows.decimal = format.decimal;
    }
    char *rest = rows.text;
    for (char *line; (line = next_line(&rest)); rows.count++) {
        rows.items = memory_grow(rows.items, rows.count, sizeof *rows.items);
        rows.items[rows.count] = (struct row){.line = rows.count + 1};
        make_row(&rows.items[rows.count], line, &rows);
    }
    ungroup(&rows);
    blank_words(&rows);
    return rows;
}

int rows_of_note(struct rows *rows, long i)
{
    struct row *row = &rows->items[i], made = {.line = row->line};
    char *copy = memory_text(row->fields[0]), *text = copy + strspn(copy, "# \t");
    make_row(&made, text, rows);
    row_free(row);
    *row = made;
    row->own = copy;
    return row->count;
}

void rows_free(struct rows *rows)
{
    for (long i = 0; i < rows->count; i++) row_free(&rows->items[i]);
    free(rows->items);
    free(rows->text);
    *rows = (struct rows){0};
}
