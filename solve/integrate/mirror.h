/* mirror.h - planes of symmetry: of a body that is a half, a quarter or an eighth of one.
 *
 * The lowest layer of corners lies in the plane, and does not leave it.  What acts on it from the other side is what acts
 * from this one, with the part across the plane turned: it holds no other component.  That is exact for corners, whose
 * families do not reach over the plane. */
#ifndef HS_MIRROR_H
#define HS_MIRROR_H

#include "boundary.h"

/* Adds a set that holds the nodes of each plane, but those that another set holds across it, to boundary->sets, which has
 * room for three more.  Collective. */
void mirror_add(struct boundary *boundary, const struct scene *scene, const struct body *body,
                double largest_stress);

#endif
