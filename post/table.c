#include "table.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double *table_add(struct table *table, const char *name)
{
    table->columns = memory_grow(table->columns, table->n_columns, sizeof *table->columns);
    struct column *column = &table->columns[table->n_columns++];
    column->name = memory_text(name);
    column->values = memory_new((size_t)table->n_rows, sizeof *column->values);
    for (long i = 0; i < table->n_rows; i++) column->values[i] = NAN;
    return column->values;
}

double *table_find(const struct table *table, const char *name)
{
    for (int i = 0; i < table->n_columns; i++)
        if (strcmp(table->columns[i].name, name) == 0) return table->columns[i].values;
    return NULL;
}

void table_free(struct table *table)
{
    for (int i = 0; i < table->n_columns; i++) {
        free(table->columns[i].name);
        free(table->columns[i].values);
    }
    free(table->columns);
    *table = (struct table){0};
}
