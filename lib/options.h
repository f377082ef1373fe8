/* options.h - the command line, from one table that also prints --help. */
#ifndef HS_OPTIONS_H
#define HS_OPTIONS_H

#include "option_row.h"

struct section;

struct option_table {
    const char *program;  /* "hsgen" */
    const char *synopsis; /* "[deck] [-o FILE]" */
    const char *purpose;  /* one sentence */
    const struct option_row *rows;
    int count;
    const struct section *const *sections; /* of the deck, for --keys; ended by NULL */
};

/* Reads argv by the table (getopt_long).  -h/--help, -V/--version, --completion SHELL and, where
 * there are sections,
 * --keys[=text|mdoc|markdown] (the manual of their keys) are built in, print to stdout and exit 0.
 * A wrong option ends with exit 2 and a hint at --help. Returns the index of the first operand in
 * argv. */
int options_read(const struct option_table *table, int argc, char **argv);

/* Program name, version, compiler and libraries on one line each, as --version prints them. */
const char *options_version(void);

/* The command line as one string, for provenance; quoted where it needs to be.
 * The caller frees it. */
char *options_command(int argc, char **argv);

#endif
