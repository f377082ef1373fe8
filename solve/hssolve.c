/* hssolve - a peridynamic tension test: domain in, histories out. */
#include "arguments.h"
#include "cracks.h"
#include "damage.h"
#include "die.h"
#include "launch.h"
#include "material_read.h"
#include "ranks.h"
#include "record.h"
#include "scene.h"
#include "simulation.h"

#include <stdlib.h>

int main(int argc, char **argv)
{
    die_set_program("hssolve");
    /* What --keys prints: the sections of the deck that hssolve reads, and what it writes. */
    const struct section *const sections[] = {
        &section_materials, &section_damage, &section_damage_rule, &section_cracks,
        &section_boundary,  &section_ramp,   &section_steps,       &section_initial,
        &section_solver,    &section_output, record_section(),     NULL};
    struct arguments arguments = arguments_read(argc, argv, sections);
    if (launch_wanted(&arguments)) return launch_ranks(&arguments);

    struct ranks ranks = ranks_start(&argc, &argv);
    struct simulation *simulation = simulation_new(&arguments, ranks);
    simulation_announce(simulation);
    const char *failure = arguments.check ? NULL : simulation_run(simulation);
    if (!arguments.check) simulation_finish(simulation, failure);
    if (failure) {
        ranks_wait();
        if (ranks.rank == 0) die_run("%s", failure);
        ranks_wait();
    }
    simulation_free(simulation);
    free(arguments.command);
    ranks_stop();
    return 0;
}
