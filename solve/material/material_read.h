/* material_read.h - the deck's section "materials". */
#ifndef HS_MATERIAL_READ_H
#define HS_MATERIAL_READ_H

#include "keys.h"
#include "material.h"

extern const struct section section_materials;

/* One entry for each phase of the domain; a phase without an entry is an error, an entry without a
 * phase only a note.  Dies where the materials have not one formulation in common. */
struct materials materials_read(struct deck_node section, int n_phases, char *const phase_names[],
                                enum plane plane);

#endif
