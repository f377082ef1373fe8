/* fill.h - the sites of the lattice that a body fills.
 *
 * Whole cells (volumes: whole): a node sits where the centre of its cell is inside, and owns all of
 * the cell.
 *
 * Cut cells (volumes: cut): a node owns the part of its cell that lies in the body.  Where that is
 * less than FILL_LEAST of the cell there is no node: the part goes to the neighbour across a face
 * that has most of its own cell inside, in equal shares where several have as much; the smallest
 * parts first, so that what goes to a cell that is itself too small goes on with its own.  A part
 * that no neighbour exceeds keeps its node.  The body's volume is the sum of what the nodes own. */
#ifndef HS_FILL_H
#define HS_FILL_H

#include "specimen.h"

#define FILL_LEAST 0.05

struct sites fill_sites(const struct specimen *specimen);

#endif
