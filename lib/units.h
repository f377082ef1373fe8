/* units.h - "185 MPa" to 1.85e8 (UDUNITS-2). */
#ifndef HS_UNITS_H
#define HS_UNITS_H

/* Reads "number [unit]" into *value, in the SI unit expected.  Returns NULL, or a message that
 * says what is wrong (static storage, valid until the next call). */
const char *units_read(const char *text, const char *expected, double *value);

#endif
