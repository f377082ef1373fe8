/* box_fields.h - fields over the grid's box that are read and written together. */
#ifndef HS_BOX_FIELDS_H
#define HS_BOX_FIELDS_H

#include <stdint.h>

/* fields[0..count - 1], of n_sites numbers each, 0.  They lie in one block so that the same site of
 * different fields is kept by different lines of the cache: at equal places in their pages the
 * fields of a line of nodes and of its neighbours would push each other out. */
void box_fields_new(double *fields[], int count, int64_t n_sites);

/* Of what box_fields_new has made, the first field; NULL is nothing. */
void box_fields_free(double *first);

#endif
