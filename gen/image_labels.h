/* image_labels.h - which value of an image is which phase, as the deck says it. */
#ifndef HS_IMAGE_LABELS_H
#define HS_IMAGE_LABELS_H

#include "deck.h"
#include "image.h"

/* The deck's words for it; index 0: not there. */
struct image_words {
    struct deck_node labels;    /* {phase: value or [values], ...} */
    struct deck_node threshold; /* {at: value, below: phase, above: phase} */
    struct deck_node empty;     /* value or [values]: no material */
};

struct section;
extern const struct section image_threshold_section;

/* The names of phases in their order; returns how many, `most` at most, else dies. */
int image_phases(struct deck_node domain, const struct image_words *words, int most,
                 const char *names[]);

/* The phase of each voxel: its place among the names, or `empty`.  Dies where a value that is asked
 * for is not in the image, or one of the image's belongs to no phase.  The caller frees them. */
uint8_t *image_label(const struct image *image, const char *path, const struct image_words *words,
                     uint8_t empty);

#endif
