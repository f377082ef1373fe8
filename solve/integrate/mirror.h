/* mirror.h - planes of symmetry: of a body that is a half, a quarter or an eighth of one.
 *
 * The lowest layer of corners lies in the plane, and does not leave it.  What acts on it from the
 * other side is what acts from this one, with the part across the plane turned: it holds no other
 * component.  That is exact for corners, whose families do not reach over the plane. */
#ifndef HS_MIRROR_H
#define HS_MIRROR_H

#include "body.h"
#include "scene.h"

/* Numbers of the nodes in the plane across an axis, ascending, but of those that the scene holds
 * across it, on rank 0 (elsewhere NULL); to be freed.  scene: resolved on rank 0. */
int64_t *mirror_nodes(const struct scene *scene, const struct body *body, int axis, int64_t *count);

#endif
