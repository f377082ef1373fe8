/* placement.h - the numbers of a vector (unknowns.h) at their places in the boxes of slabs.h. */
#ifndef HS_PLACEMENT_H
#define HS_PLACEMENT_H

#include "slabs.h"
#include "unknowns.h"

struct placement;

/* held: held components have their places in the box, too.  Collective. */
struct placement *placement_new(const struct unknowns *unknowns, const struct box box[3],
                                const struct slabs *slabs, bool held);
void placement_free(struct placement *placement);

/* Whether nodes share places.  Collective. */
bool placement_is_crowded(const struct placement *placement);

/* Into the slabs' values: nodes that share a place are summed, in the order of their sites, those
 * between places are shared out; where no node is there is 0.  Collective. */
void placement_put(struct placement *placement, const double *vector);
/* And back, to a direction (direction.h); components without a place are left as they are.
 * Collective. */
void placement_take(struct placement *placement, float *direction);

#endif
