/* expansion.h - one deck of a study: its text with the values of one run. */
#ifndef HS_EXPANSION_H
#define HS_EXPANSION_H

#include "variation.h"

struct expansion {
    const struct deck *deck;
    struct variations variations;
    int resolution;  /* index of the variation that is one of domain.spacing; -1 */
    int spacing_key; /* of its keys */
    int coarsest;    /* of its values */
    bool has_cores;  /* which the coarsest spacing makes for the others */
};

/* Dies (exit 2) at whatever is wrong in vary or refine. */
struct expansion expansion_of(const struct deck *deck);
void expansion_free(struct expansion *expansion);

/* The run at the coarsest spacing whose cores this run takes; itself where it makes its own. */
int64_t expansion_maker(const struct expansion *expansion, int64_t run);

/* What varied in a run; the caller frees it. */
struct varied expansion_varied(const struct expansion *expansion, int64_t run);

/* The deck's text with the values of the run, titles that say so, and varied in place of vary;
 * comments stay.  cores: file of the cores of expansion_maker.  The caller frees it. */
char *expansion_text(const struct expansion *expansion, int64_t run, const char *cores);

/* Dies (exit 2) where the run's text is no deck with these values that hsgen takes. */
void expansion_check(const struct expansion *expansion, int64_t run, const char *text);

#endif
