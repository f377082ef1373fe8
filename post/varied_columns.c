#include "varied_columns.h"

#include "csv.h"
#include "memory.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* What stands behind the number a text begins with; NULL where it does not, or more follows than
 * a unit. */
static const char *unit_of(const char *text)
{
    char *end;
    if (!isdigit((unsigned char)*text) && !strchr("+-.", *text)) return NULL;
    (void)strtod(text, &end);
    if (end == text) return NULL;
    end += strspn(end, " \t");
    return end[strcspn(end, ", \t[]{}\"'")] ? NULL : end;
}

static struct varied_column *find(struct varied_columns *columns, const char *name)
{
    for (int i = 0; i < columns->count; i++)
        if (strcmp(columns->items[i].name, name) == 0) return &columns->items[i];
    return NULL;
}

/* A unit that not all values have is none. */
static void take(struct varied_columns *columns, const struct varied_item *item)
{
    struct varied_column *column = find(columns, item->name);
    const char *unit = unit_of(item->value);
    if (!column) {
        columns->items = memory_grow(columns->items, columns->count, sizeof *columns->items);
        columns->items[columns->count++] =
            (struct varied_column){item->name, unit ? unit : "", item->role};
    } else if (!unit || strcmp(column->unit, unit) != 0) {
        column->unit = "";
    }
}

struct varied_columns varied_columns_of(const struct label labels[], int count)
{
    struct varied_columns columns = {0};
    for (int k = 0; k < count; k++)
        for (int i = 0; i < labels[k].values.count; i++) take(&columns, &labels[k].values.items[i]);
    return columns;
}

struct varied_columns varied_columns_questions(const struct label labels[], int count)
{
    struct varied_columns columns = varied_columns_of(labels, count);
    int kept = 0;
    for (int i = 0; i < columns.count; i++)
        if (columns.items[i].role == VARIED_QUESTION) columns.items[kept++] = columns.items[i];
    columns.count = kept;
    return columns;
}

void varied_columns_free(struct varied_columns *columns)
{
    free(columns->items);
    *columns = (struct varied_columns){0};
}

static bool left_out(const struct varied_column *column, enum varied_role without)
{
    return without != VARIED_QUESTION && column->role == without;
}

void varied_columns_heading(FILE *file, const struct varied_columns *columns,
                            enum varied_role without)
{
    for (int i = 0; i < columns->count; i++) {
        const struct varied_column *column = &columns->items[i];
        if (left_out(column, without)) continue;
        char *heading =
            memory_print("%s%s%s", column->name, *column->unit ? "_" : "", column->unit);
        fputc(',', file);
        csv_text(file, heading);
        free(heading);
    }
}

void varied_columns_values(FILE *file, const struct varied_columns *columns,
                           const struct label *label, enum varied_role without)
{
    for (int i = 0; i < columns->count; i++) {
        const struct varied_column *column = &columns->items[i];
        if (left_out(column, without)) continue;
        fputc(',', file);
        for (int k = 0; k < label->values.count; k++) {
            const char *value = label->values.items[k].value;
            if (strcmp(label->values.items[k].name, column->name) != 0) continue;
            char *number = memory_print("%.*s", (int)strcspn(value, " \t"), value);
            /* "25um" keeps no unit, either. */
            if (*column->unit)
                number[strlen(number) - (strchr(value, ' ') ? 0 : strlen(column->unit))] = '\0';
            csv_text(file, *column->unit ? number : value);
            free(number);
        }
    }
}
