/* quantities.h - columns of the history that a deck asks for: a field over some nodes as one
 * number. */
#ifndef HS_QUANTITIES_H
#define HS_QUANTITIES_H

#include "damage.h"
#include "model.h"
#include "scene.h"

struct quantities;

/* scene: resolved on rank 0.  Collective. */
struct quantities *quantities_new(const struct scene *scene, const struct body *body,
                                  const struct damage *damage);
void quantities_free(struct quantities *quantities);

int quantities_count(const struct quantities *quantities);
/* Whether any is of the nodes' states. */
bool quantities_need_states(const struct quantities *quantities);

/* Forces are those of nodes [N], not densities; a mean is weighted by volume.
 * values[quantities_count], the same on all ranks.  model_prepare goes before it where they need
 * states.  Collective. */
void quantities_measure(struct quantities *quantities, struct model *model, struct body *body,
                        double *values);

#endif
