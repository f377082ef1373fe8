#include "stop.h"

#include "ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* What a batch job needs at its end beside the run: to write, to copy. */
static const double BATCH_MARGIN = 60;

static const int signals[STOP_SIGNALS] = {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGXCPU};

/* Of this process, as its signals are. */
static volatile sig_atomic_t noted, child;

static void note_signal(int number)
{
    if (number == SIGINT && noted == SIGINT) {
        signal(number, SIG_DFL);
        raise(number);
    }
    noted = number;
    if (child > 0) kill((pid_t)child, SIGUSR1);
}

/* Reads and writes go on behind a signal. */
static void note_signals(struct sigaction before[STOP_SIGNALS])
{
    struct sigaction action = {.sa_flags = SA_RESTART};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    for (int k = 0; k < STOP_SIGNALS; k++) {
        sigaction(signals[k], NULL, &before[k]);
        if (before[k].sa_handler != SIG_IGN) sigaction(signals[k], &action, NULL);
    }
}

struct stop stop_begin(double limit)
{
    struct stop stop = {.deadline = limit > 0 ? ranks_clock() + limit : INFINITY};
    const char *job_end = getenv("SLURM_JOB_END_TIME");
    if (job_end && *job_end) {
        const double left = strtod(job_end, NULL) - (double)time(NULL) - BATCH_MARGIN;
        stop.deadline = fmin(stop.deadline, ranks_clock() + left);
    }
    noted = 0;
    note_signals(stop.before);
    return stop;
}

void stop_end(const struct stop *stop)
{
    for (int k = 0; k < STOP_SIGNALS; k++) sigaction(signals[k], &stop->before[k], NULL);
}

const char *stop_asked(const struct stop *stop, double needed)
{
    /* The launcher's SIGUSR1 stands for whatever it was sent itself. */
    if (noted == SIGUSR1 && getenv("HSSOLVE_COMMAND")) return "a signal";
    if (noted) return strsignal(noted);
    return ranks_clock() + needed >= stop->deadline ? "the time limit" : NULL;
}

void stop_pass_on(int process)
{
    struct sigaction before[STOP_SIGNALS];
    child = process;
    note_signals(before);
}

int stop_signal(void)
{
    return noted;
}
