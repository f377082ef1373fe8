/* partition.h - which rank owns which part of the lattice: a box each.
 *
 * The body is cut across an axis into two with as many nodes as the ranks of either ask for, each
 * of them again, and so on (M. J. Berger, S. H. Bokhari, A partitioning strategy for nonuniform
 * problems on multiprocessors, IEEE Trans. Comput. C-36 (1987) 570).  Fields are arrays over a
 * rank's box: in parts that are boxes they hold next to nothing that is not its own. */
#ifndef HS_PARTITION_H
#define HS_PARTITION_H

#include "lattice.h"

/* A node of the tree of cuts; the part below a cut is the next one in the list. */
struct partition_cut {
    int axis;  /* -1: a part that is not cut */
    int at;    /* first layer above */
    int above; /* index of the cut there; of a part its rank */
};

struct partition_box {
    int low[3], high[3]; /* sites from low to below high: the smallest such box about its nodes */
};

struct partition {
    int ranks;
    struct partition_cut *cuts;
    struct partition_box *boxes; /* [ranks] */
    int *owner;                  /* [sites] of a row, whose parts lie anywhere in it; else NULL */
};

/* The same on each rank, which makes it for itself.  Dies where there are more ranks than can be
 * given nodes. */
struct partition partition_new(const struct lattice *lattice, int size);
void partition_free(struct partition *partition);

static inline int partition_owner(const struct partition *p, int x, int y, int z)
{
    const int at[3] = {x, y, z};
    const struct partition_cut *cut = p->cuts;
    if (p->owner) return p->owner[x];
    while (cut->axis >= 0) cut = at[cut->axis] < cut->at ? cut + 1 : p->cuts + cut->above;
    return cut->above;
}

#endif
