/* structure.h - the microstructure on the nodes of one lattice. */
#ifndef HS_STRUCTURE_H
#define HS_STRUCTURE_H

#include "fraction.h"
#include "recipe.h"
#include "sites.h"

struct structure {
    const struct sites *sites;
    uint8_t *counted; /* [n_nodes] 1: outside the grips */
    uint8_t *phase;   /* [n_nodes] PHASE_CG, PHASE_UFG, PHASE_GRIP */
    int32_t *core;    /* [n_nodes] the core or cell that the node lies in or near to */
    struct threshold threshold;
};

/* cores may be NULL for a homogeneous structure. */
struct structure structure_new(const struct recipe *recipe, const struct sites *sites,
                               const struct cores *cores);
void structure_free(struct structure *structure);

/* Length (m) that the threshold stands for: how far the outermost coarse node is from its core's
 * centre (spheres, > 0) or from its cell's face (cells, < 0). */
double structure_reach(const struct structure *structure);

#endif
