/* output.h - text files beside the domain, under their final name only when they are whole. */
#ifndef HS_OUTPUT_H
#define HS_OUTPUT_H

#include "spool.h"

#include <stdio.h>

struct output {
    struct spool spool;
    FILE *stream;
};

struct output output_open(const char *path);

/* Checks that every byte was written (else exit 1) and gives the file its name. */
void output_close(struct output *output);

#endif
