#include "csv.h"

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

void csv_heading(FILE *file, const char *name)
{
    const int stem = (int)strlen(name) - (ends_in(name, pascal) ? (int)strlen(pascal) : 0);
    fprintf(file, "%.*s%s", stem, name, name[stem] ? megapascal : "");
}

void csv_value(FILE *file, const char *name, double value)
{
    csv_number(file, ends_in(name, pascal) ? value / mega : value);
}

void csv_write(FILE *file, const struct table *table)
{
    for (int i = 0; i < table->n_columns; i++) {
        if (i) fputc(',', file);
        csv_heading(file, table->columns[i].name);
    }
    fputc('\n', file);
    for (long row = 0; row < table->n_rows; row++) {
        for (int i = 0; i < table->n_columns; i++) {
            if (i) fputc(',', file);
            csv_value(file, table->columns[i].name, table->columns[i].values[row]);
        }
        fputc('\n', file);
    }
}
