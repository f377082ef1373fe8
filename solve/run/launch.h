/* launch.h - hssolve -j N: starts the ranks itself, so that no mpirun stands in the pipe. */
#ifndef HS_LAUNCH_H
#define HS_LAUNCH_H

#include "arguments.h"

/* True where this process is to start others: -j above 1 and not itself started by mpirun or srun.
 */
int launch_wanted(const struct arguments *arguments);

/* Spools the pipe, runs mpirun on this program with files, pumps the history out; returns the exit
 * code of the ranks.  The history is the parent's to give out, so that a full disk or a closed pipe
 * is seen here. */
int launch_ranks(const struct arguments *arguments);

#endif
