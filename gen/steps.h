/* steps.h - the offsets of a lattice ball, shortest first. */
#ifndef HS_STEPS_H
#define HS_STEPS_H

#include <stdbool.h>

struct step {
    int offset[3];
    int square; /* of the length, in spacings */
};

/* All offsets but the zero with a length of at most radius spacings; half: one of each pair of
 * opposite ones.  The caller frees them. */
struct step *steps_ball(int radius, bool half, int *count);

#endif
