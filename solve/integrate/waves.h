/* waves.h - the waves of one axis of a box in which a stiffness is nearly diagonal, as an
 * orthonormal transform.
 *
 * Sines start where the body is held, cosines where it is free.  Between nodes that are particles
 * an end lies half a spacing beyond the outermost node; between corners a free end lies at the
 * outermost one, which counts half, a held one a spacing beyond.  A periodic axis has both, of
 * whole periods about the middle: cosines of none to less than n/2 periods, then sines down from
 * n/2 to 1; exchanged, both of one number have each other's places.  The matrix of the waves is
 * folded (folding.h), with the same bits on any processor; where too much of it would be left FFTW
 * transforms.  In single precision: it is for a preconditioner. */
#ifndef HS_WAVES_H
#define HS_WAVES_H

#include "folding.h"

#include <stdbool.h>

enum { WAVES_WIDTH = FOLDING_WIDTH };

struct waves;

/* n: nodes; low, high: whether something of the body is held beyond that end. */
struct waves *waves_new(int n, bool corners, bool low, bool high);
struct waves *waves_new_periodic(int n, bool exchanged);
void waves_free(struct waves *waves);

/* Wave number per site of wave k, and whether it is a sine. */
double waves_number(const struct waves *waves, int k);
bool waves_is_sine(const struct waves *waves, int k);

/* WAVES_WIDTH lines at once, values[n][line], which are used up: from numbers at the nodes to
 * amplitudes, out[n][line], or back; the second is the transposed of the first.  Both are aligned
 * to 64 bytes. */
void waves_transform(const struct waves *waves, bool back, float (*values)[WAVES_WIDTH],
                     float (*out)[WAVES_WIDTH]);

#endif
