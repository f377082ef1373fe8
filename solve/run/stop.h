/* stop.h - what asks a run to end in order before its end: a signal, its time limit, the end of a
 * batch job. */
#ifndef HS_STOP_H
#define HS_STOP_H

#include <signal.h>

enum { STOP_SIGNALS = 5 };

struct stop {
    double deadline; /* s of ranks_clock; INFINITY: none */
    struct sigaction before[STOP_SIGNALS];
};

/* From here to stop_end SIGTERM, SIGINT, SIGHUP, SIGUSR1 and SIGXCPU are noted, not obeyed; those
 * that are ignored (nohup) stay so, and a second SIGINT ends the program at once.  limit: seconds
 * from now on, 0: none; the environment's SLURM_JOB_END_TIME is another, less a minute. */
struct stop stop_begin(double limit);
void stop_end(const struct stop *stop);

/* Why the run is to stop, once it may not take another `needed` seconds (static storage); NULL: it
 * may go on. */
const char *stop_asked(const struct stop *stop, double needed);

/* A launcher hands such signals to the process that it waits for, as SIGUSR1. */
void stop_pass_on(int process);
/* The signal that was noted last, 0: none. */
int stop_signal(void);

#endif
