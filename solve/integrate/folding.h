/* folding.h - products with a matrix whose columns or rows mirror each other, as those of waves do.
 *
 * Where each row is even or odd about the middle of its columns, sums and differences of the
 * mirrored numbers leave two blocks of half the size, which may have the same kind of symmetry
 * again; so do columns about the middle of their rows.  The fast cosine and sine transforms are
 * such foldings (Wang, IEEE Trans. Acoust. Speech Signal Process. 32 (1984) 803); here they are
 * found from the numbers.  What has no symmetry left is multiplied.  All numbers of WIDTH vectors
 * are treated alike, each in the same order, so that a vector's result has the same bits whatever
 * stands beside it, and on any processor. */
#ifndef HS_FOLDING_H
#define HS_FOLDING_H

#include <stdint.h>

enum { FOLDING_WIDTH = 16 };

struct folding;

/* matrix[rows][columns]. */
struct folding *folding_new(int rows, int columns, const double *matrix);
void folding_free(struct folding *folding);

/* out[row][l] = sum over the columns of matrix[row][column] in[column][l].  in is used up; both are
 * aligned to 64 bytes. */
void folding_multiply(const struct folding *folding, float (*in)[FOLDING_WIDTH],
                      float (*out)[FOLDING_WIDTH]);

/* Multiplications of one vector. */
int64_t folding_cost(const struct folding *folding);

#endif
