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

/* Reads all rows that are left, and of each the column that the source asks for, without a wish the
 * one called "phase". */
void ebsd_read(struct image_text *text, const struct ebsd_columns *columns, struct image *image);

#endif
