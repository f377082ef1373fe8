#include "tidy.h"

#include "csv.h"
#include "memory.h"
#include "varied_columns.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Columns in which a curve has a value, by their names in the order of the first curve that has
 * them. */
struct names {
    int count;
    const char **items;
};

static bool has_value(const struct column *column, long n)
{
    for (long i = 0; i < n; i++)
        if (!isnan(column->values[i])) return true;
    return false;
}

static struct names names_of(const struct curve curves[], int count)
{
    struct names names = {0};
    for (int k = 0; k < count; k++)
        for (int j = 0; j < curves[k].table.n_columns; j++) {
            const struct column *column = &curves[k].table.columns[j];
            bool known = !has_value(column, curves[k].n);
            for (int i = 0; i < names.count; i++)
                known = known || strcmp(names.items[i], column->name) == 0;
            if (known) continue;
            names.items = memory_grow(names.items, names.count, sizeof *names.items);
            names.items[names.count++] = column->name;
        }
    return names;
}

void tidy_write(FILE *file, const struct curve curves[], const struct label labels[], int count)
{
    const struct names names = names_of(curves, count);
    struct varied_columns columns = varied_columns_of(labels, count);
    fputs("curve,group,file,varied", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    for (int j = 0; j < names.count; j++) {
        fputc(',', file);
        csv_heading(file, names.items[j]);
    }
    fputc('\n', file);
    for (int k = 0; k < count; k++) {
        const char *const texts[] = {labels[k].curve, labels[k].title, labels[k].file,
                                     labels[k].varied};
        for (long i = 0; i < curves[k].n; i++) {
            for (int j = 0; j < 4; j++) {
                if (j) fputc(',', file);
                csv_text(file, texts[j]);
            }
            varied_columns_values(file, &columns, &labels[k], VARIED_QUESTION);
            for (int j = 0; j < names.count; j++) {
                const double *values = table_find(&curves[k].table, names.items[j]);
                fputc(',', file);
                csv_value(file, names.items[j], values ? values[i] : NAN);
            }
            fputc('\n', file);
        }
    }
    varied_columns_free(&columns);
    free(names.items);
}
