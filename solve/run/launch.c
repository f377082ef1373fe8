#include "launch.h"

#include "die.h"
#include "exodus.h"
#include "memory.h"
#include "ranks.h"
#include "spool.h"
#include "stop.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/* Cores that this process may run on. */
static int cores(void)
{
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : INT_MAX;
}

int launch_wanted(const struct arguments *arguments)
{
    if (arguments->ranks <= 1 || ranks_launched()) return false;
    if (arguments->ranks > cores() && !arguments->oversubscribe && !getenv("HSSOLVE_OVERSUBSCRIBE"))
        die_user(
            "-j %d: there are %d cores for this process, and more ranks than cores wait for each "
            "other at every step; --oversubscribe runs them all the same",
            arguments->ranks, cores());
    return true;
}

/* A path to a file that only this process has open. */
static char *seen_by_others(const char *path)
{
    const char *own = "/proc/self/";
    if (strncmp(path, own, strlen(own)) != 0) return memory_text(path);
    return memory_print("/proc/%ld/%s", (long)getpid(), path + strlen(own));
}

static void set_environment(void)
{
    if (geteuid() == 0) { /* mpirun refuses root unless both are set; -j is the user's own word */
        setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
        setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
    }
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self,vader", 0);
    setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 0);
    setenv("OMPI_MCA_osc", "^ucx", 0);
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0); /* leave the core to others while waiting */
    /* Ranks say themselves what is wrong; of Open MPI 4 and 5. */
    setenv("OMPI_MCA_orte_execute_quiet", "1", 0);
    setenv("PRTE_MCA_prte_execute_quiet", "1", 0);
}

/* mpirun would kill the ranks a second after these.  It passes SIGUSR1 on to them, who then end in
 * order (stop.h). */
static void leave_signals_to_parent(void)
{
    sigset_t left;
    sigemptyset(&left);
    sigaddset(&left, SIGTERM);
    sigaddset(&left, SIGINT);
    sigaddset(&left, SIGHUP);
    sigprocmask(SIG_BLOCK, &left, NULL);
    setpgid(0, 0); /* a terminal's, too */
}

static void become_mpirun(const struct arguments *a, const char *input, const char *history)
{
    char *self = realpath("/proc/self/exe", NULL), *ranks = memory_print("%d", a->ranks);
    const char *argv[32] = {"mpirun", "--oversubscribe", "--bind-to", "none", "-np", ranks, self};
    int n = 7;
    argv[n++] = "--input";
    argv[n++] = input;
    if (a->deck) {
        argv[n++] = "--deck";
        argv[n++] = a->deck;
    }
    if (a->fields) {
        argv[n++] = "--output";
        argv[n++] = a->fields;
    }
    if (a->history) {
        argv[n++] = "--history";
        argv[n++] = a->history;
    }
    if (a->check) {
        argv[n++] = "--check";
    } else {
        argv[n++] = "--spooled-history";
        argv[n++] = history;
    }
    if (a->checkpoint) {
        argv[n++] = "--checkpoint";
        argv[n++] = a->checkpoint;
    }
    if (a->restart) {
        argv[n++] = "--restart";
        argv[n++] = a->restart;
    }
    char *limit = memory_print("%.17g", a->time_limit);
    if (a->time_limit > 0) {
        argv[n++] = "--time-limit";
        argv[n++] = limit;
    }
    if (a->quiet) argv[n++] = "--quiet";
    if (a->profile) argv[n++] = "--profile";
    set_environment();
    setenv("HSSOLVE_COMMAND", a->command, 1);
    if (isatty(STDERR_FILENO)) setenv("HSSOLVE_TERMINAL", "1", 1);
    leave_signals_to_parent();
    prctl(PR_SET_PDEATHSIG, SIGUSR1); /* the ranks do not outlive the one who started them */
    int nothing = open("/dev/null", O_RDONLY);
    if (nothing >= 0) dup2(nothing, STDIN_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO); /* nothing stray may reach the pipe */
    execvp("mpirun", (char *const *)argv);
    die_run("cannot start mpirun: %s", strerror(errno));
}

/* How the ranks ended, in words, where they could not say so themselves. */
static void tell_end(int status, int code)
{
    if (stop_signal() || (code <= 128 && code >= 0)) return;
    if (WIFSIGNALED(status))
        warn("mpirun was ended by signal %d (%s)", WTERMSIG(status), strsignal(WTERMSIG(status)));
    else
        warn("a rank was ended by signal %d (%s%s)", code - 128, strsignal(code - 128),
             code - 128 == SIGKILL ? ": out of memory?" : "");
}

/* What killed ranks have left of the history; what they kept themselves is gone from here. */
static void keep_history(const struct arguments *a, struct spool *history)
{
    double time;
    const bool file = a->history && strncmp(a->history, "/dev/", strlen("/dev/")) != 0;
    char *name = memory_print("%s.failed", file ? a->history : "hssolve-history");
    if (spool_keep(history, name)) {
        const int64_t records = exodus_repair(name, &time);
        warn("the history up to record %lld, t = %.4g s, is kept in %s", (long long)records, time,
             name);
    }
    free(name);
}

static int wait_for(pid_t child, int *status)
{
    while (waitpid(child, status, 0) < 0)
        if (errno != EINTR) die_run("waitpid: %s", strerror(errno));
    if (!WIFEXITED(*status)) return -1;
    const int code = WEXITSTATUS(*status);
    return code;
}

int launch_ranks(const struct arguments *a)
{
    struct arguments within = *a; /* what the ranks are told */
    struct spool input = spool_input(a->input), history = {.descriptor = -1};
    struct spool deck = a->deck ? spool_input(a->deck) : (struct spool){.descriptor = -1};
    if (!a->check) history = spool_output(a->history);
    history.precious = "hssolve-history.failed";
    spool_refuse_unread(&history);
    char *input_path = seen_by_others(input.path),
         *history_path = a->check ? NULL : seen_by_others(history.path);
    char *deck_path = a->deck ? seen_by_others(deck.path) : NULL;
    within.deck = deck_path;
    char *folder = spool_folder(); /* of these ranks alone: others' runs come and go beside them */
    setenv("OMPI_MCA_orte_tmpdir_base", folder, 1); /* Open MPI 4 */
    setenv("PRTE_MCA_prte_tmpdir_base", folder, 1); /* 5 */
    pid_t child = fork();
    if (child < 0) die_run("cannot fork: %s", strerror(errno));
    if (child == 0) become_mpirun(&within, input_path, history_path);
    stop_pass_on(child);
    int status, code = wait_for(child, &status);
    tell_end(status, code);
    spool_remove_folder(folder);
    /* Ranks that stopped have taken the history away. */
    if (code == 0 && !a->check && spool_is_empty(&history)) code = EXIT_STOPPED;
    if (code == 0 && !a->check)
        spool_finish(&history);
    else if ((code < 0 || code > 128) && code != EXIT_STOPPED && !a->check)
        keep_history(a, &history);
    spool_close(&history);
    spool_close(&input);
    if (a->deck) spool_close(&deck);
    free(deck_path);
    free(input_path);
    free(history_path);
    if (stop_signal() && code != 0) return EXIT_STOPPED;
    return code == 0 || code == EXIT_USER || code == EXIT_STOPPED ? code : EXIT_RUN;
}
