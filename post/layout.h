/* layout.h - where the table stands in a text: names, units, numbers. */
#ifndef HS_LAYOUT_H
#define HS_LAYOUT_H

#include "rows.h"

/* Where the parts of the text are: rows from 0, -1 where there is none. */
struct layout {
    const char *name; /* of the file */
    struct rows rows;
    long first, last; /* of the numbers */
    long names, units;
    int columns;
};

/* The longest run of rows of numbers, the row of names above it and perhaps one of units.  Dies
 * (exit 2, name:line:column) at what else is no line of words above or below.  chosen: the
 * columns are known by their numbers, so that the names need not be those of the columns. */
struct layout layout_find(const char *text, const char *name, bool chosen);

/* Whether a row within the numbers holds none: blank, or a note. */
bool layout_skips(const struct row *row);

#endif
