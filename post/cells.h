/* cells.h - the corners of what a layer of particles is drawn as. */
#ifndef HS_CELLS_H
#define HS_CELLS_H

#include "snapshot.h"

/* m, along the two axes of the picture: lower left, lower right, upper right, upper left. */
struct cell {
    double corner[4][2];
};

/* The cells [count] of these nodes, with factor of their displacements; the caller frees them.
 *
 * On a lattice cells share their corners as long as they are together: a corner is the mean of
 * where its cells put it by their displacement and its gradient, by differences to the neighbours.
 * An affine deformation comes out exactly, also at a face, wherever a cell has a neighbour along
 * both axes.  Neighbours that are further apart than
 * 2.5 times their distance (without the factor) are parted.  Scattered particles are squares. */
struct cell *cells_make(const struct snapshot *snapshot, const int axes[2], const int64_t nodes[],
                        int64_t count, double factor);

#endif
