/* value_table.h - values of several keys from a CSV file: a row of headings, then a row a
 * variation. */
#ifndef HS_VALUE_TABLE_H
#define HS_VALUE_TABLE_H

struct value_table {
    int n_columns, n_rows;
    char **headings; /* [n_columns] */
    char **values;   /* [n_rows * n_columns] */
};

/* Commas between fields, double quotes around those that have one, # before notes; dies (exit 2)
 * with file:line at a row that has not as many fields as there are headings, and at an empty field.
 */
struct value_table value_table_read(const char *path);
void value_table_free(struct value_table *table);

#endif
