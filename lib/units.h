/* units.h - "185 MPa" to 1.85e8 (UDUNITS-2). */
#ifndef HS_UNITS_H
#define HS_UNITS_H

#include <stdbool.h>

/* Reads "number [unit]" into *value, in the SI unit expected.  Returns NULL, or a message that
 * says what is wrong (static storage, valid until the next call). */
const char *units_read(const char *text, const char *expected, double *value);

/* The same, whatever the unit measures; false where the text is no number with a unit that decks
 * have. */
bool units_read_any(const char *text, double *value);

#endif
