#include "ranks.h"

#include "die.h"

#include <mpi.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static void abort_all(int code)
{
    int running = 0, size = 1;
    MPI_Initialized(&running);
    if (running) MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (running && size > 1) MPI_Abort(MPI_COMM_WORLD, code);
    exit(code);
}

/* Rank 0 ends this process meanwhile; what it did not meet itself is told after all. */
static void wait_for_first(void)
{
    sleep(20);
}

struct ranks ranks_start(int *argc, char ***argv)
{
    /* Without a launcher: no daemon, no network.  Under mpirun or srun these change nothing. */
    if (!getenv("PMIX_RANK") && !getenv("OMPI_COMM_WORLD_SIZE") && !getenv("SLURM_PROCID")) {
        setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
        setenv("OMPI_MCA_pml", "ob1", 0);
        setenv("OMPI_MCA_btl", "self,vader", 0);
        setenv("OMPI_MCA_osc", "^ucx", 0);
        /* Runs side by side would make and remove the same directory under each other. */
        setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    }
    if (MPI_Init(argc, argv) != MPI_SUCCESS) die_run("MPI does not start");
    struct ranks ranks;
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.size);
    die_set_exit(abort_all);
    if (ranks.rank != 0) die_set_wait(wait_for_first);
    return ranks;
}

void ranks_stop(void)
{
    MPI_Finalize();
    die_set_exit(exit);
    die_set_wait(NULL);
}

void ranks_share(void *data, size_t bytes)
{
    const size_t most = (size_t)1 << 30;
    for (size_t at = 0; at < bytes; at += most) {
        size_t part = bytes - at < most ? bytes - at : most;
        MPI_Bcast((char *)data + at, (int)part, MPI_BYTE, 0, MPI_COMM_WORLD);
    }
}

void ranks_sum(double *values, int count)
{
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

void ranks_minimum(double *values, int count)
{
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
}

void ranks_wait(void)
{
    MPI_Barrier(MPI_COMM_WORLD);
}

double ranks_clock(void)
{
    return MPI_Wtime();
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
