/* record.h - one record of a history, column by column.
 *
 * A column of every history is one row of the table in record.c, which says what it is called and
 * what its value is.  Those of phases are rows of gauge.c, those that a deck asks for are of
 * node_values.c. */
#ifndef HS_RECORD_H
#define HS_RECORD_H

#include "boundary.h"
#include "gauge.h"
#include "integration.h"
#include "keys.h"

/* Columns of a tension test are there where the scene has what they measure. */
enum { NEEDS_GRIPS = 1, NEEDS_GAUGE = 2, NEEDS_PERIODS = 4, NEEDS_LOAD = 8 };

struct record_column {
    const char *name;
    const char *unit; /* SI, "1": a pure number */
    unsigned needs;
    double value;
    const char *help; /* one line for the manual */
};

/* Where a record comes from. */
struct record {
    const struct integration *integration;
    const struct body *body;
    const struct boundary_set *left, *right; /* the grips */
    double force_left, force_right;          /* N */
    struct gauge_planes planes;
    struct gauge_section section;
    double unsteady; /* kinetic energy beyond the uniform stretching, J */
};

/* A record of nothing: for the columns' names alone. */
struct record record_empty(void);

/* The columns that need no more than there is, to be freed. */
struct record_column *record_columns(const struct record *record, unsigned has, int *count);

/* All columns that a run may write, for the manual: one row each, with its unit.  Lives as long as
 * the program. */
const struct section *record_section(void);

/* Title of a column in the file, a new text: force_left_N; of a pure number the name alone. */
char *column_title(const char *name, const char *unit);

#endif
