/* image_ebsd.h - what EBSD maps as text have in common: points in rows, a column of which is taken.
 */
#ifndef HS_IMAGE_EBSD_H
#define HS_IMAGE_EBSD_H

#include "image_text.h"

/* Columns by their names, in order; x and y: which ones are the places. */
struct ebsd_columns {
    int count;
    char *const *names;
    int x, y;
};

/* What the head says of the grid; 0: nothing. */
struct ebsd_head {
    double count[2], step[2];
};

/* Reads all rows that are left, and of each the column that the source asks for, without a wish the
 * one called "phase".  The grid follows from the rows.  A head with other counts at the same steps
 * says that the file is cut off, which is refused; one with other steps is not of these rows, and a
 * warning. */
void ebsd_read(struct image_text *text, const struct ebsd_columns *columns,
               const struct ebsd_head *head, struct image *image);

#endif
