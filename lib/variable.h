/* variable.h - units of the nodal variables in a file of frames.
 *
 * A variable's unit is known by how its name begins, as Displacement, or the file says it in an
 * attribute hs_unit_NAME; without either it is a pure number. */
#ifndef HS_VARIABLE_H
#define HS_VARIABLE_H

#include "domain.h"

/* SI: "Pa", "N/m3"; "1": a pure number.  Lives as long as the attributes. */
const char *variable_unit(const struct attributes *file, const char *variable);

/* The attribute, where variable_unit would say something else without it. */
void variable_set_unit(struct attributes *file, const char *variable, const char *unit);

#endif
