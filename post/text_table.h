/* text_table.h - a table of numbers as laboratories and spreadsheets write it.
 *
 * Any of the delimiters and decimal marks of rows.h; lines above, a row of names, perhaps one of
 * units; lines of words below.  A table that hspost has written, with engineering_strain and
 * engineering_stress_MPa, keeps all its columns under their names, stresses in Pa; of any other
 * one those come out that headings.h knows, in SI units. */
#ifndef HS_TEXT_TABLE_H
#define HS_TEXT_TABLE_H

#include "domain.h"
#include "table.h"

/* columns_of: "strain=NAME,stress=3:MPa", which column is what, by name or number, and its unit;
 * NULL: by the headings. Lines "# key: value" and sizes above the table go to the facts
 * (section_m2, gauge_length_m, title), and in words what was taken for what ("table").  Dies
 * (exit 2, name:line:column) at what is not a table of numbers. */
struct table text_table_read(const char *text, const char *name, const char *columns_of,
                             struct attributes *facts);

#endif
