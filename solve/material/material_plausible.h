/* material_plausible.h - numbers that no metal has, as a forgotten GPa makes of it. */
#ifndef HS_MATERIAL_PLAUSIBLE_H
#define HS_MATERIAL_PLAUSIBLE_H

#include "material.h"

/* Dies at the first material whose modulus, density, yield or hardening is far from any solid's,
 * and says how to have it all the same.  section: "materials", of which they have been read. */
void material_check_plausible(const struct materials *materials, struct deck_node section);

#endif
