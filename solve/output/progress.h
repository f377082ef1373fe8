/* progress.h - how far the run is, for people. */
#ifndef HS_PROGRESS_H
#define HS_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    bool shown, terminal;
    double started, last; /* s */
};

/* shown: false on all ranks but one, and after --quiet.  Where mpirun stands between a rank and the
 * terminal, HSSOLVE_TERMINAL says that there is one. */
struct progress progress_start(bool shown);

/* Called at every step; prints every half second on a terminal, every half minute elsewhere.
 * done: share of the run, 0 to 1; strain: NAN where there is no gauge. */
void progress_update(struct progress *progress, double done, int64_t step, double strain,
                     double stress, double drift);
/* Called while an equilibrium is searched: prints every half second on a terminal, every ten
 * elsewhere. */
void progress_search(struct progress *progress, int64_t step, int64_t evaluations, double residual,
                     double tolerance);
/* Seconds since the start. */
double progress_finish(struct progress *progress);

#endif
