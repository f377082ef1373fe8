#include "arguments.h"

#include "die.h"
#include "options.h"
#include "units.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int number_of_ranks(const char *text)
{
    char *end;
    long ranks = strtol(text, &end, 10);
    if (end == text || *end || ranks < 1 || ranks > 100000)
        die_user("-j %s: expected a number of ranks, 1 or more", text);
    return (int)ranks;
}

static double seconds(const char *text)
{
    double value = 0;
    const char *fault = units_read(text, "s", &value);
    if (fault) die_user("--time-limit: %s", fault);
    if (!(value > 0)) die_user("--time-limit %s: expected a time above 0, such as '90 min'", text);
    return value;
}

static bool is(const char *name, const char *other)
{
    return name && other && strcmp(name, other) == 0;
}

/* What is closed here would be taken by the next file that is opened. */
static void check_streams(const struct arguments *a)
{
    if (!a->input && !a->restart && fcntl(STDIN_FILENO, F_GETFD) < 0)
        die_user("standard input is closed: give the domain with -i");
    if (!a->history && !a->spooled && fcntl(STDOUT_FILENO, F_GETFD) < 0)
        die_user("standard output is closed: name the history with -H");
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDWR);
}

static void check_names(struct arguments *a)
{
    if (is(a->input, "-")) a->input = NULL;
    if (is(a->history, "-")) a->history = NULL;
    if (is(a->fields, "-") || is(a->fields, "/dev/stdout"))
        die_user("-o %s: the fields need a file of their own, the pipe is for the history",
                 a->fields);
    if (is(a->fields, a->history))
        die_user("-o and -H both name %s: fields and history are two files", a->fields);
    if (is(a->deck, "-") && !a->input)
        die_user("domain and deck cannot both come from standard input");
}

struct arguments arguments_read(int argc, char **argv, const struct section *const sections[])
{
    struct arguments a = {.ranks = 1};
    const char *ranks = NULL, *limit = NULL;
    const struct option_row rows[] = {
        {'i', "input", "FILE",
         "the domain: Genesis, or Peridigm text with --deck (default: the pipe)", NULL, &a.input},
        {'d', "deck", "FILE", "the study's deck (default: the one inside the domain)", NULL,
         &a.deck},
        {'j', "ranks", "N", "run on N processes of this machine", NULL, &ranks},
        {0, "oversubscribe", NULL, "more processes than there are cores", &a.oversubscribe, NULL},
        {'o', "output", "FILE", "fields for ParaView (Exodus), as the deck's output section asks",
         NULL, &a.fields},
        {'H', "history", "FILE", "the history (default: the pipe)", NULL, &a.history},
        {0, "checkpoint", "FILE",
         "where the state of the run goes to (default: beside the history), every 10 min at least",
         NULL, &a.checkpoint},
        {0, "restart", "FILE", "go on from this checkpoint, with its domain and deck", NULL,
         &a.restart},
        {0, "time-limit", "TIME", "stop in order before so much time has passed: '90 min'", NULL,
         &limit},
        {0, "repair", "FILE", "make whole a history or fields that an ended run left; then leave",
         NULL, &a.repair},
        {0, "profile", NULL, "at the end, where the time went and what was left out", &a.profile,
         NULL},
        {0, "check", NULL, "check everything, say what would be done, and leave", &a.check, NULL},
        {'q', "quiet", NULL, "no notes, no progress", &a.quiet, NULL},
        {0, "spooled-history", "FILE", "used by -j for the processes it starts", NULL, &a.spooled},
    };
    const struct option_table table = {
        "hssolve",
        "[-i domain.g] [-d study.yaml] [-j N] [-o fields.e] [-H history.e] [--check]",
        "Peridynamic tension test of a multi-phase body: domain in, histories out.",
        rows,
        sizeof rows / sizeof *rows,
        sections};
    int first = options_read(&table, argc, argv);
    if (first < argc) die_user("unexpected argument '%s' (the domain goes with -i)", argv[first]);
    if (ranks) a.ranks = number_of_ranks(ranks);
    if (limit) a.time_limit = seconds(limit);
    if (a.repair) return a;
    check_names(&a);
    check_streams(&a);
    if (a.quiet) note_set_quiet(1);
    a.command = options_command(argc, argv);
    return a;
}
