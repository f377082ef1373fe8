/* deck_path.h - places of a deck by their path: domain.ufg_fraction, boundary.2.velocity (items
 * count from 1). */
#ifndef HS_DECK_PATH_H
#define HS_DECK_PATH_H

#include "deck.h"

struct deck_place {
    char *path;
    struct deck_node node; /* the value there */
};

struct deck_paths {
    int count;
    struct deck_place *items;
};

/* All places below the sections that are not in except (ended by NULL), containers before what they
 * hold.  Dies where there are more than 20,000, as aliases can make. */
struct deck_paths deck_paths_list(const struct deck *deck, const char *const except[]);
void deck_paths_free(struct deck_paths *paths);

/* The place that a name means: a whole path, or the end of one, from a dot on, that is the end of
 * no other place's. Dies at where, with the nearest known, or with all that it may mean. */
const struct deck_place *deck_paths_find(const struct deck_paths *paths, struct deck_node where,
                                         const char *name);

#endif
