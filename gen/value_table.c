#include "value_table.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <stdlib.h>
#include <string.h>

enum { LARGEST = 100000000 };

/* A place in the file. */
struct reader {
    const char *path;
    char *rest; /* NULL: the end */
    int line;
};

/* The next line that says something; NULL at the end. */
static char *next_line(struct reader *reader)
{
    while (reader->rest) {
        char *line = reader->rest, *end = line + strcspn(line, "\n");
        reader->rest = *end ? end + 1 : NULL;
        reader->line++;
        if (end > line && end[-1] == '\r') end--;
        *end = '\0';
        line += strspn(line, " \t");
        if (*line && *line != '#') return line;
    }
    return NULL;
}

/* Without blanks around it. */
static char *trimmed(char *field)
{
    field += strspn(field, " \t");
    for (char *end = field + strlen(field); end > field && strchr(" \t", end[-1]);) *--end = '\0';
    return field;
}

/* Takes one field off the line, which goes on behind its comma, or is NULL. */
static char *take_field(const struct reader *reader, char **line)
{
    char *from = *line + strspn(*line, " \t"), *to, *write;
    if (*from != '"') {
        *line = strchr(from, ',');
        if (*line) *(*line)++ = '\0';
        return memory_text(trimmed(from));
    }
    for (to = write = ++from; *to && (*to != '"' || to[1] == '"'); to++) {
        if (*to == '"') to++;
        *write++ = *to;
    }
    if (!*to) die_user("%s:%d: a quote that does not end", reader->path, reader->line);
    to += 1 + strspn(to + 1, " \t");
    if (*to && *to != ',')
        die_user("%s:%d: '%.20s' behind a quoted field, expected a comma", reader->path,
                 reader->line, to);
    *write = '\0';
    *line = *to ? to + 1 : NULL;
    return memory_text(from);
}

static char **take_fields(const struct reader *reader, char *line, int *count)
{
    char **fields = NULL;
    for (*count = 0; line; (*count)++) {
        fields = memory_grow(fields, *count, sizeof *fields);
        fields[*count] = take_field(reader, &line);
        if (!*fields[*count])
            die_user("%s:%d: field %d is empty", reader->path, reader->line, *count + 1);
    }
    return fields;
}

struct value_table value_table_read(const char *path)
{
    long length;
    char *text = spool_text(path, LARGEST, &length);
    struct reader reader = {path, text, 0};
    struct value_table table = {0};
    char *line = next_line(&reader);
    if (!line) die_user("%s: empty, expected a row of headings and rows of values", path);
    table.headings = take_fields(&reader, line, &table.n_columns);
    int values = 0;
    while ((line = next_line(&reader))) {
        int count;
        char **fields = take_fields(&reader, line, &count);
        if (count != table.n_columns)
            die_user("%s:%d: %d fields, expected %d, one a heading", path, reader.line, count,
                     table.n_columns);
        for (int i = 0; i < count; i++) {
            table.values = memory_grow(table.values, values, sizeof *table.values);
            table.values[values++] = fields[i];
        }
        free(fields);
        table.n_rows++;
    }
    free(text);
    return table;
}

void value_table_free(struct value_table *table)
{
    for (int i = 0; i < table->n_columns; i++) free(table->headings[i]);
    for (int i = 0; i < table->n_rows * table->n_columns; i++) free(table->values[i]);
    free(table->headings);
    free(table->values);
    *table = (struct value_table){0};
}
