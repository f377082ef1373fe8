/* html.h - pieces of a page that is well-formed as HTML and as XML. */
#ifndef HS_HTML_H
#define HS_HTML_H

#include <stddef.h>
#include <stdio.h>

/* Text between tags or in a quoted attribute, whatever is in it. */
void html_text(FILE *page, const char *text);

/* A name as words: blanks for its underscores. */
void html_words(FILE *page, const char *name);

/* <data value="...">: the number in full, as in CSV, and for the eye rounded to two digits of its
 * error, at most six of its own, without one to four.  Nothing for NAN. */
void html_number(FILE *page, double value, double error);

/* The number, its error and its unit ("1": none). */
void html_quantity(FILE *page, double value, double error, const char *unit);

/* A src="data:..." of a picture. */
void html_picture(FILE *page, const char *type, const void *bytes, size_t length);

/* The beginning of a table of names and values. */
void html_table(FILE *page);

/* The beginning of a section of the page, of which each has an id; html_end ends it. */
void html_section(FILE *page, const char *id, const char *heading);
void html_end(FILE *page);

#endif
