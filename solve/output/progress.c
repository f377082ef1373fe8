#include "progress.h"

#include "ranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

struct progress progress_start(bool shown)
{
    double now = ranks_clock();
    bool terminal = isatty(STDERR_FILENO) || getenv("HSSOLVE_TERMINAL");
    return (struct progress){shown, terminal, now, now};
}

void progress_update(struct progress *progress, double done, int64_t step, double strain,
                     double stress, double drift)
{
    if (!progress->shown) return;
    double now = ranks_clock();
    if (now - progress->last < (progress->terminal ? 0.5 : 30)) return;
    progress->last = now;
    done = fmin(fmax(done, 0), 1); /* a strain may overshoot, or go the other way */
    double spent = now - progress->started, remaining = done > 0 ? spent * (1 - done) / done : 0;
    fprintf(stderr, "%shssolve: %3.0f %%  step %lld  ", progress->terminal ? "\r\033[K" : "",
            100 * done, (long long)step);
    if (!isnan(strain))
        fprintf(stderr, "gauge strain %.4f  stress %.1f MPa  ", strain, stress * 1e-6);
    fprintf(stderr, "energy drift %.1e  %.0f s left%s", drift, remaining,
            progress->terminal ? "" : "\n");
    fflush(stderr);
}

void progress_search(struct progress *progress, int64_t step, int64_t evaluations, double residual,
                     double tolerance)
{
    if (!progress->shown) return;
    const double now = ranks_clock();
    if (now - progress->last < (progress->terminal ? 0.5 : 10)) return;
    progress->last = now;
    fprintf(stderr, "%shssolve: step %lld: %lld evaluations, residual %.1e of %.1e%s",
            progress->terminal ? "\r\033[K" : "", (long long)step, (long long)evaluations, residual,
            tolerance, progress->terminal ? "" : "\n");
    fflush(stderr);
}

double progress_finish(struct progress *progress)
{
    if (progress->shown && progress->terminal) fprintf(stderr, "\r\033[K");
    return ranks_clock() - progress->started;
}
