/* hssolve - a peridynamic tension test: domain in, histories out. */
#include "arguments.h"
#include "cracks.h"
#include "damage.h"
#include "die.h"
#include "domain_facts.h"
#include "exodus.h"
#include "launch.h"
#include "material_read.h"
#include "ranks.h"
#include "record.h"
#include "restart.h"
#include "scene.h"
#include "simulation.h"

#include <stdlib.h>

static int repair(const char *name)
{
    double time;
    const int64_t records = exodus_repair(name, &time);
    note("%s is whole up to record %lld, t = %.6g s", name, (long long)records, time);
    return 0;
}

static void release(struct arguments *arguments, struct spool inputs[2])
{
    free(arguments->command);
    for (int k = 0; k < 2; k++)
        if (inputs[k].path) spool_close(&inputs[k]);
}

int main(int argc, char **argv)
{
    die_set_program("hssolve");
    /* What --keys prints: the sections of the deck that hssolve reads, and what it writes. */
    const struct section *const sections[] = {
        &section_domain_facts, &section_domain_grips, &section_domain_gauge,
        &section_materials,    &section_damage,       &section_damage_rule,
        &section_cracks,       &section_boundary,     &section_ramp,
        &section_steps,        &section_table,        &section_initial,
        &section_macroscopic,  &section_solver,       &section_programme,
        &section_output,       record_section(),      NULL};
    struct arguments arguments = arguments_read(argc, argv, sections);
    struct spool inputs[2] = {{.descriptor = -1}, {.descriptor = -1}};
    if (arguments.restart && !arguments.spooled) restart_unpack(&arguments, inputs);
    if (arguments.repair || launch_wanted(&arguments)) {
        const int code = arguments.repair ? repair(arguments.repair) : launch_ranks(&arguments);
        release(&arguments, inputs);
        return code;
    }

    struct ranks ranks = ranks_start(&argc, &argv);
    if (ranks.rank == 0 && !arguments.input && !arguments.check) {
        inputs[0] = spool_input(NULL); /* a checkpoint takes it along */
        arguments.input = inputs[0].path;
    }
    struct simulation *simulation = simulation_new(&arguments, ranks);
    simulation_announce(simulation);
    const char *failure = arguments.check ? NULL : simulation_run(simulation);
    if (!arguments.check) simulation_finish(simulation, failure);
    const bool spooled = arguments.spooled != NULL;
    const bool stopped = simulation_stopped(simulation);
    if (failure && !stopped) {
        ranks_wait();
        if (ranks.rank == 0) die_run("%s", failure);
        ranks_wait();
    }
    simulation_free(simulation);
    release(&arguments, inputs);
    ranks_wait();
    ranks_stop();
    /* mpirun takes another code of a rank for an accident; the parent of -j sees that the history
     * is gone. */
    return stopped && !spooled ? EXIT_STOPPED : 0;
}
