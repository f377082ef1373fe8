/* ranks.h - the processes that share a run, and sums that do not depend on how many there are. */
#ifndef HS_RANKS_H
#define HS_RANKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct ranks {
    int rank, size;
};

/* Whether a launcher (mpirun, srun) has started this process, with others or alone. */
bool ranks_launched(void);

/* Starts MPI where a launcher has started this process: alone there is nobody to speak with, and
 * what MPI needs, a folder, a daemon, ports, can fail.  Makes die() end all ranks with its code; a
 * user's error, which all ranks meet, is told by rank 0. */
struct ranks ranks_start(int *argc, char ***argv);
void ranks_stop(void);

/* Broadcast from rank 0. */
void ranks_share(void *data, size_t bytes);

/* Sums and minima over all ranks, in place. */
void ranks_sum(double *values, int count);
void ranks_minimum(double *values, int count);

/* One number of each rank: all[size]. */
void ranks_tell_all(int64_t value, int64_t *all);

void ranks_wait(void); /* until all are here */

double ranks_clock(void); /* s */
/* Seconds that this rank has computed. */
double ranks_processor(void);

/* Most memory that all ranks together have held so far [bytes], as the system counts it.
 * Collective. */
double ranks_memory(void);

#endif
