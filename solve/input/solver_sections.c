#include "solver_sections.h"

#include "cracks.h"
#include "damage.h"
#include "material_read.h"
#include "scene.h"

const struct section *const solver_sections[] = {&section_materials,
                                                 &section_damage,
                                                 &section_damage_rule,
                                                 &section_cracks,
                                                 &section_boundary,
                                                 &section_ramp,
                                                 &section_steps,
                                                 &section_initial,
                                                 &section_solver,
                                                 &section_output,
                                                 NULL};
