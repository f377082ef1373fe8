/* simulation.h - everything a run consists of, and its course from the domain to the last record.
 */
#ifndef HS_SIMULATION_H
#define HS_SIMULATION_H

#include "arguments.h"
#include "ranks.h"

struct simulation;

/* Reads domain and deck, partitions, builds body and model, finds the stable step.  Collective. */
struct simulation *simulation_new(const struct arguments *arguments, struct ranks ranks);

/* One line of sanity for people: nodes, bonds, ranks, step, wave speed, memory, and the time by one
 * evaluation of the force; where all that is wanted is a check, also phases, records and frames.
 * Collective. */
void simulation_announce(struct simulation *simulation);

/* Advances to the end.  NULL, or why it had to stop (valid as long as the simulation). */
const char *simulation_run(struct simulation *simulation);

/* Whether that was because it was asked to (stop.h). */
bool simulation_stopped(const struct simulation *simulation);

/* Makes the outputs appear: under their names, or, where the run failed, as NAME.failed with all
 * that was good.  Prints the summary. */
void simulation_finish(struct simulation *simulation, const char *failure);

void simulation_free(struct simulation *simulation);

#endif
