/* rows.h - lines of text as rows of fields: which delimiter, which decimal mark, and what stands
 * in each row. */
#ifndef HS_ROWS_H
#define HS_ROWS_H

#include <stdbool.h>

enum row_kind {
    ROW_BLANK,
    ROW_NOTE,    /* begins with # */
    ROW_WORDS,   /* no field, or not the first one, is a number */
    ROW_MIXED,   /* begins with a number, but not all fields are numbers */
    ROW_NUMBERS, /* all fields that are not empty are numbers, and there is one */
};

struct row {
    enum row_kind kind;
    long line;          /* from 1 */
    int count, numbers; /* fields, and how many of them are numbers */
    char **fields; /* [count] without quotes and blanks around them; of a note the whole line */
    int *places;   /* [count] column of the text where the field begins, from 1 */
    char *own;     /* what the fields of a note taken as a row point into; else NULL */
};

struct rows {
    char delimiter, decimal; /* ' ': blanks */
    long count;
    struct row *items; /* [count] one a line */
    char *text;        /* what the fields point into */
};

/* Delimiter (tab, semicolon, comma, blanks) and decimal mark are those by which most lines are
 * numbers. */
struct rows rows_read(const char *text);
void rows_free(struct rows *rows);

/* Makes a row of words of note i; returns its number of fields. */
int rows_of_note(struct rows *rows, long i);

/* A finite number with this decimal mark, and nothing else; groups of three digits may have the
 * other mark between them where a decimal mark follows. */
bool rows_number(const char *text, char decimal, double *value);

/* A whole number in groups of three digits, "1.004": which it is with this mark, or one with
 * decimals, a field alone does not say.  rows_read takes the marks out where the column says. */
bool rows_is_grouped(const char *text, char mark);

#endif
