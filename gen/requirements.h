/* requirements.h - what a structure is asked to be, beyond its fraction. */
#ifndef HS_REQUIREMENTS_H
#define HS_REQUIREMENTS_H

#include "deck.h"

enum {
    REQUIRE_UFG_CONNECTED = 1, /* the fine phase percolates along all axes */
    REQUIRE_CG_CONNECTED = 2,  /* the coarse one does */
    REQUIRE_CORES_APART = 4 /* different cores do not touch, with the film asked for between them */
};

extern const char *const requirement_names[]; /* in the order of the bits, ended by NULL */

/* The bits of a list of names, none of an empty one; usual where there is no list (index 0). */
unsigned requirements_read(struct deck_node list, unsigned usual);

#endif
