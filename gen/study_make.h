/* study_make.h - the Makefile of a study. */
#ifndef HS_STUDY_MAKE_H
#define HS_STUDY_MAKE_H

#include <stdbool.h>
#include <stdio.h>

struct study_make {
    int count;
    long *numbers;      /* [count] of the runs */
    char *const *cores; /* [count] file of the cores that the run takes; NULL: its own */
    long *makers;       /* [count] number of the run that makes them */
    bool resolution;    /* there is something to extrapolate */
    bool sensitivity;   /* there are changes of one key at a time */
};

/* Whether a file begins as what study_make_write writes. */
bool study_make_wrote(const char *path);

void study_make_write(FILE *file, const struct study_make *study);

#endif
