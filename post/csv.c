#include "csv.h"

#include "die.h"
#include "memory.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const double mega = 1e6;
static const char pascal[] = "_Pa", megapascal[] = "_MPa";

static bool ends_in(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n > m && strcmp(text + n - m, ending) == 0;
}

/* Cuts the text at the next newline; NULL at the end. */
static char *next_line(char **text)
{
    char *line = *text;
    if (!*line) return NULL;
    char *end = line + strcspn(line, "\n");
    *text = *end ? end + 1 : end;
    *end = '\0';
    if (end > line && end[-1] == '\r') end[-1] = '\0';
    return line;
}

/* Cuts the line at the next comma and strips blanks; NULL behind the last field. */
static char *next_field(char **line)
{
    char *field = *line;
    if (!field) return NULL;
    char *end = field + strcspn(field, ",");
    *line = *end ? end + 1 : NULL;
    *end = '\0';
    while (isspace((unsigned char)*field)) field++;
    while (end > field && isspace((unsigned char)end[-1])) *--end = '\0';
    return field;
}

static bool read_number(const char *text, double *value)
{
    char *end;
    if (strspn(text, "+-.0123456789eE") != strlen(text)) return false;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

enum { LONGEST_KEY = 40 };

static void read_note(char *line, struct attributes *attributes)
{
    char *key = line + strspn(line, "# "), *colon = strstr(key, ": ");
    if (!colon || colon == key || colon - key > LONGEST_KEY) return;
    *colon = '\0';
    double number;
    if (read_number(colon + 2, &number))
        attributes_set_number(attributes, key, number);
    else
        attributes_set_text(attributes, key, colon + 2);
}

static void read_header(char *line, const char *name, long number, struct table *table)
{
    for (char *start = line, *field; (field = next_field(&line)); start = line) {
        int place = (int)(field - start) + 1;
        if (*field == '\0') die_user("%s:%ld:%d: a column without a name", name, number, place);
        double unused;
        if (read_number(field, &unused))
            die_user("%s:%ld:%d: '%s' is a number; expected a row of column names "
                     "(engineering_strain,engineering_stress_MPa)",
                     name, number, place, field);
        char *column = memory_text(field);
        if (ends_in(column, megapascal)) strcpy(column + strlen(column) - strlen("_MPa"), pascal);
        if (table_find(table, column))
            die_user("%s:%ld:%d: the column '%s' is there twice", name, number, place, field);
        table_add(table, column);
        free(column);
    }
}

static void read_row(char *line, const char *name, long number, const struct table *table, long row,
                     const bool scaled[])
{
    const char *begin = line;
    int i = 0;
    for (char *field; (field = next_field(&line)); i++) {
        int place = (int)(field - begin) + 1;
        if (i == table->n_columns)
            die_user("%s:%ld:%d: more fields than the %d columns of the header", name, number,
                     place, table->n_columns);
        double *value = &table->columns[i].values[row];
        if (*field == '\0') continue;
        if (!read_number(field, value))
            die_user("%s:%ld:%d: '%s' is not a finite number (column %s)", name, number, place,
                     field, table->columns[i].name);
        if (scaled[i]) *value *= mega;
    }
    if (i < table->n_columns)
        die_user("%s:%ld: %d fields, expected %d", name, number, i, table->n_columns);
}

static long count_lines(const char *text)
{
    long lines = 1;
    for (; *text; text++) lines += *text == '\n';
    return lines;
}

struct table csv_parse(char *text, const char *name, struct attributes *attributes)
{
    struct table table = {.n_rows = count_lines(text)};
    bool *scaled = NULL;
    long row = 0, number = 0;
    for (char *line; (line = next_line(&text));) {
        number++;
        if (line[strspn(line, " \t")] == '\0') continue;
        if (line[0] == '#') {
            read_note(line, attributes);
        } else if (!scaled) {
            scaled = memory_new(strlen(line) + 1, sizeof *scaled);
            char *header = memory_text(line), *rest = header;
            for (int i = 0; rest; i++) scaled[i] = ends_in(next_field(&rest), megapascal);
            free(header);
            read_header(line, name, number, &table);
        } else {
            read_row(line, name, number, &table, row++, scaled);
        }
    }
    if (!scaled) die_user("%s: no header row; expected comma-separated columns", name);
    if (row == 0) die_user("%s: no row of numbers below the header", name);
    free(scaled);
    table.n_rows = row;
    return table;
}

void csv_number(FILE *file, double value)
{
    if (!isfinite(value)) return;
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value) break;
    }
    fputs(text, file);
}

void csv_text(FILE *file, const char *text)
{
    if (!text[strcspn(text, ",\"\r\n")]) {
        fputs(text, file);
        return;
    }
    fputc('"', file);
    for (; *text; text++) {
        if (*text == '"') fputc('"', file);
        fputc(*text, file);
    }
    fputc('"', file);
}

void csv_write(FILE *file, const struct table *table)
{
    for (int i = 0; i < table->n_columns; i++) {
        const char *name = table->columns[i].name;
        int stem = (int)strlen(name) - (ends_in(name, pascal) ? (int)strlen(pascal) : 0);
        fprintf(file, "%s%.*s%s", i ? "," : "", stem, name, name[stem] ? megapascal : "");
    }
    fputc('\n', file);
    for (long row = 0; row < table->n_rows; row++) {
        for (int i = 0; i < table->n_columns; i++) {
            double value = table->columns[i].values[row];
            if (i) fputc(',', file);
            csv_number(file, ends_in(table->columns[i].name, pascal) ? value / mega : value);
        }
        fputc('\n', file);
    }
}
