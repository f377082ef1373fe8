/* study.h - the curves that hspost was given, with all that is known of them. */
#ifndef HS_STUDY_H
#define HS_STUDY_H

#include "analysis.h"
#include "figure.h"
#include "labels.h"
#include "request.h"

/* A file as it was read. */
struct kept {
    char *bytes;
    long length;
    bool is_history;
};

struct study {
    int count;
    struct curve *curves; /* [count], as the following */
    struct choices *choices;
    struct analysis *analyses;
    struct properties *properties;
    struct figure_loops *loops;
    struct label *labels;
    char **decks, **builds; /* texts; NULL: none.  builds: versions of the solver and of what it is
                               linked to, a line each */
    struct kept *kept;      /* [count] for a crate, else without bytes */
    char *question;         /* what the first deck that says it wants to know; NULL */
    char *license;          /* of the data, which the first deck says that does; NULL */
    const char *maker;      /* "# program: ..." and "# command: ..." lines */
};

/* The choices of a deck (NULL: none) and of the command line, which wins. */
struct choices study_choose(const struct request *request, const struct deck *deck);

/* Reads and analyses all files of the request. */
struct study study_read(const struct request *request, const char *maker);
void study_free(struct study *study);

#endif
