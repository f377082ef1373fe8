/* variation.h - the sections vary and refine of a study: what varies, and through which values. */
#ifndef HS_VARIATION_H
#define HS_VARIATION_H

#include "deck_path.h"
#include "varied.h"

#include <stdint.h>

/* Values of one key. */
struct variation_key {
    const char *name;        /* as the study calls it */
    char *heading;           /* where that is of a table; NULL */
    const char *path;        /* in the deck, whole; NULL: no key, but what to call the values */
    struct deck_node node;   /* the value that is replaced */
    char **texts;            /* as YAML writes them */
    struct deck_node *where; /* of each, for messages */
};

/* One thing that varies: one key, or several together. */
struct variation {
    const char *name;
    struct deck_node where;
    int count; /* of values */
    int n_keys;
    struct variation_key *keys; /* [n_keys], each of count texts */
    enum varied_role role;
};

struct variations {
    int count;
    struct variation *items;
    int64_t runs; /* combinations of values */
    bool zipped;
    struct deck_paths paths; /* of the deck, without vary */
};

/* Reads and checks both sections; dies (exit 2) at what the deck does not have, at empty lists, and
 * where there is nothing to vary or there are more than 100,000 combinations. */
struct variations variations_read(const struct deck *deck);
void variations_free(struct variations *variations);

/* Index of the value that item k has in a run, the first one varying slowest. */
int variations_index(const struct variations *variations, int64_t run, int k);

#endif
