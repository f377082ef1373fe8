/* text_output.h - a text file that appears when it is whole, or standard output. */
#ifndef HS_TEXT_OUTPUT_H
#define HS_TEXT_OUTPUT_H

#include "spool.h"

#include <stdio.h>

struct text_output {
    FILE *file;
    const char *name; /* NULL for standard output */
    struct spool spool;
};

/* name = NULL or "-": standard output.  Dies (exit 1) where the file cannot be made. */
struct text_output text_output_open(const char *name);
/* Dies (exit 1) where something was not written. */
void text_output_close(struct text_output *output);

#endif
