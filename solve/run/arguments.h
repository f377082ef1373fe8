/* arguments.h - hssolve's command line. */
#ifndef HS_ARGUMENTS_H
#define HS_ARGUMENTS_H

#include <stdbool.h>

struct section;

struct arguments {
    const char *input;   /* domain; NULL: standard input */
    const char *deck;    /* NULL: the one inside the domain */
    const char *fields;  /* NULL: none */
    const char *history; /* NULL: standard output */
    const char *spooled; /* the history goes to this open file of the parent, whatever its name */
    const char *checkpoint; /* NULL: beside the history */
    const char *restart;    /* the checkpoint to go on from; NULL: none */
    const char *repair;     /* a file left behind unfinished, to be made whole; NULL: none */
    double time_limit;      /* s; 0: none */
    int ranks;              /* of -j */
    bool oversubscribe;     /* more ranks than cores */
    bool quiet, profile;
    bool check;    /* everything but the run */
    char *command; /* the whole line, for provenance */
};

struct arguments arguments_read(int argc, char **argv, const struct section *const sections[]);

#endif
