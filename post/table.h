/* table.h - named columns of equal length, in SI units; a value that is not there is NAN. */
#ifndef HS_TABLE_H
#define HS_TABLE_H

struct column {
    char *name; /* ends in its unit: true_stress_Pa */
    double *values;
};

struct table {
    long n_rows;
    int n_columns;
    struct column *columns;
};

/* Appends a column of NAN and returns its values [n_rows], which stay where they are. */
double *table_add(struct table *table, const char *name);

/* NULL where there is no column of that name. */
double *table_find(const struct table *table, const char *name);

void table_free(struct table *table);

#endif
