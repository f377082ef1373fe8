/* structure.h - the microstructure on the nodes of one lattice. */
#ifndef HS_STRUCTURE_H
#define HS_STRUCTURE_H

#include "fraction.h"
#include "recipe.h"
#include "sites.h"

struct structure {
    const struct sites *sites;
    const struct cores *cores; /* NULL: none whose images would have to be told apart */
    uint8_t *counted;          /* [n_nodes] 1: outside the grips */
    uint8_t *phase;            /* [n_nodes] PHASE_CG, PHASE_UFG, PHASE_GRIP */
    int64_t *grain;            /* [n_nodes] ids of an image, 0 beyond it; NULL: none are known */
    int32_t *core;             /* [n_nodes] the core or cell that the node lies in or near to */
    struct threshold threshold;
};

/* cores may be NULL for a homogeneous structure; else they have to outlive it. */
struct structure structure_new(const struct recipe *recipe, const struct sites *sites,
                               const struct cores *cores);
void structure_free(struct structure *structure);

/* Whether two nodes lie in one core.  at: the lattice indices of the other, which in a periodic
 * body may lie beyond the box: an image of the node, in an image of its core. */
bool structure_one_core(const struct structure *structure, int64_t node, int64_t other,
                        const int64_t at[3]);

/* Length (m) that the threshold stands for: how far the outermost coarse node is from its core's
 * centre (spheres, > 0) or from its cell's face (cells, < 0). */
double structure_reach(const struct structure *structure);

#endif
