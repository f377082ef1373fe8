/* hssolve - a peridynamic tension test: domain in, histories out. */
#include "arguments.h"
#include "die.h"
#include "launch.h"
#include "ranks.h"
#include "simulation.h"
#include "solver_sections.h"

#include <stdlib.h>

int main(int argc, char **argv)
{
    die_set_program("hssolve");
    struct arguments arguments = arguments_read(argc, argv, solver_sections);
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
