/* symmetry_check.h - whether a structure is its own image across planes of symmetry. */
#ifndef HS_SYMMETRY_CHECK_H
#define HS_SYMMETRY_CHECK_H

#include "recipe.h"

/* Warns where what the deck has below a plane of symmetry, cores or an image's phases on the sites,
 * is not the image of what it has above, which is made in its place. */
void symmetry_warn(const struct recipe *recipe, const struct cores *cores);

#endif
