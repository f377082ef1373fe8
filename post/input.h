/* input.h - what hspost is given: a history of hssolve, or a table of numbers (CSV). */
#ifndef HS_INPUT_H
#define HS_INPUT_H

#include "exodus.h"
#include "table.h"

#include <stdbool.h>
#include <stdint.h>

struct input {
    char *name;                   /* "standard input", or the file's */
    bool standard;                /* came through the pipe */
    bool is_history;              /* recognised by the file's first bytes */
    struct table table;           /* columns in SI units, time_s among them for a history */
    struct attributes attributes; /* of the history, or the "# key: value" lines */
    uint32_t checksum;            /* as POSIX cksum prints it */
    long bytes;
    char *content; /* [bytes] */
};

/* name = NULL or "-": standard input; columns_of: which column of a table is what
 * (text_table.h), or NULL.  Dies (exit 2) at what is neither. */
struct input input_read(const char *name, const char *columns_of);
void input_free(struct input *input);

/* CRC of bytes and length, as of POSIX cksum. */
uint32_t input_checksum(const unsigned char *bytes, long length);

#endif
