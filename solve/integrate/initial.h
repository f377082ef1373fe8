/* initial.h - displacements and velocities that a body starts with. */
#ifndef HS_INITIAL_H
#define HS_INITIAL_H

#include "body.h"
#include "scene.h"

/* Sets body->u or body->v, as the kind says, where the deck's section initial gives it.  scene:
 * resolved on rank 0.  Collective. */
void initial_set(const struct scene *scene, struct body *body, enum scene_kind kind);

#endif
