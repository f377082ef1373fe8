/* labels.h - what tells a curve from its sisters, and which are sisters. */
#ifndef HS_LABELS_H
#define HS_LABELS_H

#include "varied.h"

#include <stddef.h>

struct label {
    /* In legends and tables: the title, where it is alone; else with what varied, or the file. */
    char *curve;
    const char *title; /* the group: sisters have the same */
    const char *file;
    /* Lines of the deck in which sisters differ, "seed: 2; ..."; of a study its scatter, "seed 2";
     * "" where that is not known. */
    char *varied;
    struct varied values; /* of a study: all that varied, and the values here */
};

/* Length of what the titles of all begin with, to a comma and a blank behind it; 0 where they do
 * not, or where one title has nothing more. */
size_t labels_shared(const struct label labels[], int count);

/* Whether all that varied has the same values in both, but the scatter and what has this role. */
bool labels_differ_in(const struct label *a, const struct label *b, enum varied_role role);

/* titles, files and decks (text, NULL where there is none) of count curves, which live longer,
 * and what their decks say varied, which goes over to the labels.  The caller frees them. */
struct label *labels_make(const char *const titles[], const char *const files[],
                          const char *const decks[], const struct varied varied[], int count);
void labels_free(struct label labels[], int count);

#endif
