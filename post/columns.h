/* columns.h - a history as it is: every column that hssolve has recorded, of whatever test. */
#ifndef HS_COLUMNS_H
#define HS_COLUMNS_H

/* CSV in SI units to output (NULL or "-": standard output): "# key: value" lines of provenance,
 * which maker begins, a header, one row a record; blank for what has no value. */
void columns_write(const char *file, const char *output, const char *maker);

#endif
