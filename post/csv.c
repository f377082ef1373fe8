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

enum { FEW_DIGITS = 15, MOST_DIGITS = 17 };

/* FEW_DIGITS, or one more where so few cannot read back the same, found without printing and
 * reading them, which takes longer than all else of a long record: a whole number of so many
 * digits over a power of ten, both exact, is rounded once. */
static int fewest_digits(double value)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const double least = 1e14, most = 1e15; /* numbers of so many digits */
    double places = FEW_DIGITS - 1 - floor(log10(fabs(value)));
    if (!(places > 0 && places < 22)) return FEW_DIGITS;
    const double scaled = fabs(value) * powers[(int)places];
    if (scaled < least) places++;
    if (scaled >= most) places--;
    const double power = powers[(int)places];
    return FEW_DIGITS + (round(fabs(value) * power) / power != fabs(value));
}

void csv_number(FILE *file, double value)
{
    if (!isfinite(value)) return;
    char text[32];
    for (int digits = fewest_digits(value);; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (digits == MOST_DIGITS || strtod(text, NULL) == value) break;
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
