#include "arguments.h"

#include "die.h"
#include "options.h"

#include <stdlib.h>

static int number_of_ranks(const char *text)
{
    char *end;
    long ranks = strtol(text, &end, 10);
    if (end == text || *end || ranks < 1 || ranks > 100000)
        die_user("-j %s: expected a number of ranks, 1 or more", text);
    return (int)ranks;
}

struct arguments arguments_read(int argc, char **argv)
{
    struct arguments a = {.ranks = 1};
    const char *ranks = NULL;
    const struct option_row rows[] = {
        {'i', "input", "FILE",
         "the domain: Genesis, or Peridigm text with --deck (default: the pipe)", NULL, &a.input},
        {'d', "deck", "FILE", "the study's deck (default: the one inside the domain)", NULL,
         &a.deck},
        {'j', "ranks", "N", "run on N processes of this machine", NULL, &ranks},
        {'o', "output", "FILE", "fields for ParaView (Exodus), as the deck's output section asks",
         NULL, &a.fields},
        {'H', "history", "FILE", "the history (default: the pipe)", NULL, &a.history},
        {'q', "quiet", NULL, "no notes, no progress", &a.quiet, NULL},
        {0, "spooled-history", "FILE", "used by -j for the processes it starts", NULL, &a.spooled},
    };
    const struct option_table table = {
        "hssolve", "[-i domain.g] [-d study.yaml] [-j N] [-o fields.e] [-H history.e]",
        "Peridynamic tension test of a multi-phase body: domain in, histories out.", rows,
        sizeof rows / sizeof *rows};
    int first = options_read(&table, argc, argv);
    if (first < argc) die_user("unexpected argument '%s' (the domain goes with -i)", argv[first]);
    if (ranks) a.ranks = number_of_ranks(ranks);
    if (a.quiet) note_set_quiet(1);
    a.command = options_command(argc, argv);
    return a;
}
