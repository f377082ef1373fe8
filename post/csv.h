/* csv.h - strict comma-separated tables with a block of "#" lines above.
 *
 * Comma between fields, point in numbers, one header row, every row as long as the header, an empty
 * field for what is not valid.  Stresses are MPa in files and Pa in memory: a column stress_MPa of
 * the file is stress_Pa of the table. */
#ifndef HS_CSV_H
#define HS_CSV_H

#include "domain.h"
#include "table.h"

#include <stdio.h>

/* Reads the text of the file called name in messages; dies (exit 2, name:line:column) at what is not
 * a table of numbers.  Lines "# key: value" are added to the attributes, as numbers where they are. */
struct table csv_parse(char *text, const char *name, struct attributes *attributes);

/* The header row and the rows, with as many digits as bring the same doubles back. */
void csv_write(FILE *file, const struct table *table);

/* One number in the fewest of 15 to 17 digits that read back the same; nothing for NAN. */
void csv_number(FILE *file, double value);

/* One text field, quoted where it has to be. */
void csv_text(FILE *file, const char *text);

#endif
