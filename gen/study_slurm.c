#include "study_slurm.h"

/* A usual bound of Slurm is 1001 (MaxArraySize). */
enum { MOST_TASKS = 1000 };

static const char head[] =
    "#!/bin/bash\n"
    "# Made by hsgen --study --slurm; made anew by it.\n"
    "#\n"
    "#   bash slurm.sh [OPTIONS OF SBATCH]   all runs as a job array, and a job behind it that "
    "gathers\n"
    "#   sbatch [OPTIONS] slurm.sh           only the runs; of them some: --array=3-5\n"
    "#   make status                         what is done, stopped, failed\n"
    "#\n"
    "# Options of sbatch stand over those here: bash slurm.sh --time=8:00:00 --ntasks=4 "
    "--mem-per-cpu=2G\n"
    "# A run that nears its time limit, or is preempted, ends in order with a checkpoint, and its "
    "task is queued again.\n"
    "# What is done is not done again by the next call.  HS_SRUN: how ranks are started, usually "
    "srun --mpi=pmix\n"
    "#SBATCH --ntasks=1\n"
    "#SBATCH --time=4:00:00\n"
    "#SBATCH --signal=USR1@120\n"
    "#SBATCH --requeue\n"
    "#SBATCH --open-mode=append\n"
    "#SBATCH --output=slurm-%A_%a.out\n";

/* Only rank 0 reads the pipe of hsgen; a single rank needs no MPI. */
static const char body[] =
    "\n"
    "set -u\n"
    "if [ -z \"${SLURM_JOB_ID:-}\" ]; then\n"
    "    cd \"$(dirname \"$0\")\" || exit\n"
    "    job=$(sbatch --parsable --job-name=\"${PWD##*/}\" \"$@\" slurm.sh) || exit\n"
    "    sbatch --job-name=\"${PWD##*/}\" \"$@\" --ntasks=1 --output=slurm-%j.out "
    "--dependency=\"afterany:${job%%;*}\" --wrap 'make -s gathered status'\n"
    "    exit\n"
    "fi\n"
    "\n"
    "if [ \"${SLURM_NTASKS:-1}\" -gt 1 ]; then srun=${HS_SRUN:-srun --mpi=pmix}; else srun='srun "
    "--mpi=none'; fi\n"
    "mapfile -t runs < <(sed -e 1d -e 's/,.*//' study.csv)\n"
    "failed=0\n"
    "for ((k = SLURM_ARRAY_TASK_ID; k < ${#runs[@]}; k += tasks)); do\n"
    "    make -s LAUNCH=\"$srun --input=0\" \"${runs[k]}/curve.csv\"\n"
    "    if [ -e \"${runs[k]}/stopped\" ]; then\n"
    "        scontrol requeue \"$SLURM_JOB_ID\" && exit\n"
    "        failed=1\n"
    "    fi\n"
    "    [ -e \"${runs[k]}/curve.csv\" ] || failed=1\n"
    "done\n"
    "exit $failed\n";

void study_slurm_write(FILE *file, int runs)
{
    const int tasks = runs < MOST_TASKS ? runs : MOST_TASKS;
    fprintf(file, "%s#SBATCH --array=0-%d\n", head, tasks - 1);
    fputs("\n# One task a run; of more runs than tasks each takes several, one after the other.\n",
          file);
    fprintf(file, "tasks=%d\n%s", tasks, body);
}
