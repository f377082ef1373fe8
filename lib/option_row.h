/* option_row.h - one option of a command line. */
#ifndef HS_OPTION_ROW_H
#define HS_OPTION_ROW_H

#include <stdbool.h>

/* One option.  argument = NULL: a flag, *flag becomes true.  Otherwise *value points at the
 * text given (the last one wins). */
struct option_row {
    char letter;          /* 'o' for -o, or 0 */
    const char *name;     /* "output" for --output */
    const char *argument; /* "FILE", the words that it may be, "iso|astm", or NULL for a flag */
    const char *help;
    bool *flag;
    const char **value;
};

#endif
