/* partition.h - which rank owns which part of the lattice (METIS).
 *
 * The lattice is cut into cells a horizon wide (at least two sites, more where there would be too
 * many cells) and along x as long as a strip (grid.h), or a part of it where there would be too
 * few, so that strips stay whole; METIS partitions the cells, weighted by the particles in them,
 * instead of the bond graph: a hundred times cheaper for a few per cent more cut.  A cell belongs
 * to one rank whole. */
#ifndef HS_PARTITION_H
#define HS_PARTITION_H

#include "lattice.h"

struct partition {
    int edge[3]; /* sites along a cell */
    int cells[3];
    int *owner; /* [cells[0] * cells[1] * cells[2]] rank, -1 for a cell without particles */
};

/* Computed on rank 0 and shared.  Dies when there are more ranks than cells to give. */
struct partition partition_new(const struct lattice *lattice, int reach, int rank, int size);
void partition_free(struct partition *partition);

static inline int64_t partition_cell(const struct partition *p, int x, int y, int z)
{
    return ((int64_t)(z / p->edge[2]) * p->cells[1] + y / p->edge[1]) * p->cells[0] +
           x / p->edge[0];
}

static inline int partition_owner(const struct partition *p, int x, int y, int z)
{
    return p->owner[partition_cell(p, x, y, z)];
}

#endif
