/* varied_columns.h - what varied in a study, as columns of its tables. */
#ifndef HS_VARIED_COLUMNS_H
#define HS_VARIED_COLUMNS_H

#include "labels.h"

#include <stdio.h>

struct varied_column {
    const char *name;
    const char
        *unit; /* of all values, which then are numbers alone; "": of none, or they are texts */
    enum varied_role role;
};

struct varied_columns {
    int count;
    struct varied_column *items;
};

/* Those of all curves, in the order of the first that has them; none where nothing varied. */
struct varied_columns varied_columns_of(const struct label labels[], int count);
/* Those of what the question is about alone. */
struct varied_columns varied_columns_questions(const struct label labels[], int count);
void varied_columns_free(struct varied_columns *columns);

/* Headings (spacing_um) and values, a comma before each; without: of this role none,
 * VARIED_QUESTION: all. */
void varied_columns_heading(FILE *file, const struct varied_columns *columns,
                            enum varied_role without);
void varied_columns_values(FILE *file, const struct varied_columns *columns,
                           const struct label *label, enum varied_role without);

#endif
