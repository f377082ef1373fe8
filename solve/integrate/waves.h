/* waves.h - the waves of one axis of a box in which a stiffness is nearly diagonal, as an orthonormal transform.
 *
 * Sines start where the body is held, cosines where it is free.  Between nodes that are particles an end lies half a
 * spacing beyond the outermost node; between corners a free end lies at the outermost one, which counts half, a held one a
 * spacing beyond.  A periodic axis has both, of whole periods, in the order of FFTW's half-complex transforms: cosines of
 * 0 to n/2 periods, then sines of as many as are left, down to 1.  Axes of up to SHORT sites are multiplied by a matrix: n multiplications a number in one vector
 * loop are faster than FFTW's real transforms there, and have the same bits on any processor.  In single precision:
 * it is for a preconditioner. */
#ifndef HS_WAVES_H
#define HS_WAVES_H

#include <stdbool.h>
#include <stdint.h>

struct waves;

/* n: nodes, each with inner numbers; low, high: whether something of the body is held beyond that end. */
struct waves *waves_new(int n, int64_t inner, bool corners, bool low, bool high);
struct waves *waves_new_periodic(int n, int64_t inner);
void waves_free(struct waves *waves);

/* Wave number per site of wave k. */
double waves_number(const struct waves *waves, int k);

/* values[outer][n][inner], in place of which room, as long, may be used: from numbers at the nodes to amplitudes, or back; the second is the transposed of the first.
 * Returns which of the two has the result. */
float *waves_transform(const struct waves *waves, bool back, int64_t outer, float *values,
                       float *room);

#endif
