#include "ranks.h"

#include "die.h"

#include <mpi.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

/* MPI has been started: there may be more ranks than this one. */
static bool with_others(void)
{
    int running = 0;
    MPI_Initialized(&running);
    return running;
}

static void abort_all(int code)
{
    const bool running = with_others();
    int size = 1;
    if (running) MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (running && size > 1) MPI_Abort(MPI_COMM_WORLD, code);
    exit(code);
}

/* Rank 0 ends this process meanwhile; what it did not meet itself is told after all. */
static void wait_for_first(void)
{
    sleep(20);
}

/* mpirun tells its processes; srun, too, but so it does to a shell that it started as a single
 * task. */
bool ranks_launched(void)
{
    const char *tasks = getenv("SLURM_STEP_NUM_TASKS");
    return getenv("OMPI_COMM_WORLD_SIZE") || getenv("PMIX_RANK") || getenv("PMI_RANK") ||
           (tasks && strtol(tasks, NULL, 10) > 1);
}

struct ranks ranks_start(int *argc, char ***argv)
{
    struct ranks ranks = {0, 1};
    if (!ranks_launched()) return ranks;
    if (MPI_Init(argc, argv) != MPI_SUCCESS) die_run("MPI does not start");
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.size);
    die_set_exit(abort_all);
    if (ranks.rank != 0) die_set_wait(wait_for_first);
    return ranks;
}

void ranks_stop(void)
{
    if (with_others()) MPI_Finalize();
    die_set_exit(exit);
    die_set_wait(NULL);
}

void ranks_share(void *data, size_t bytes)
{
    const size_t most = (size_t)1 << 30;
    for (size_t at = 0; with_others() && at < bytes; at += most) {
        size_t part = bytes - at < most ? bytes - at : most;
        MPI_Bcast((char *)data + at, (int)part, MPI_BYTE, 0, MPI_COMM_WORLD);
    }
}

void ranks_sum(double *values, int count)
{
    if (with_others())
        MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

void ranks_minimum(double *values, int count)
{
    if (with_others())
        MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
}

void ranks_tell_all(int64_t value, int64_t *all)
{
    *all = value;
    if (with_others()) MPI_Allgather(&value, 1, MPI_INT64_T, all, 1, MPI_INT64_T, MPI_COMM_WORLD);
}

void ranks_wait(void)
{
    if (with_others()) MPI_Barrier(MPI_COMM_WORLD);
}

double ranks_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double ranks_processor(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double ranks_memory(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    double bytes = 1024.0 * (double)usage.ru_maxrss;
    ranks_sum(&bytes, 1);
    return bytes;
}
