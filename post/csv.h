/* csv.h - comma-separated tables as hspost writes them.
 *
 * Comma between fields, point in numbers, one header row, an empty field for what is not valid.
 * Stresses are MPa in files and Pa in memory: a column stress_Pa of the table is stress_MPa of
 * the file. */
#ifndef HS_CSV_H
#define HS_CSV_H

#include "table.h"

#include <stdio.h>

/* The header row and the rows, with as many digits as bring the same doubles back. */
void csv_write(FILE *file, const struct table *table);

/* Name and value of a column: _Pa of the table is _MPa of the file. */
void csv_heading(FILE *file, const char *name);
void csv_value(FILE *file, const char *name, double value);

/* One number in the fewest of 15 to 17 digits that read back the same; nothing for NAN. */
void csv_number(FILE *file, double value);

/* One text field, quoted where it has to be. */
void csv_text(FILE *file, const char *text);

#endif
