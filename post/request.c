#include "request.h"

#include "die.h"
#include "figure.h"
#include "memory.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct texts {
    const char *fraction, *strain_range, *law;
};

static double read_number(const char *option, const char *text, double low, double high)
{
    double value;
    const char *wrong = units_read(text, "1", &value);
    if (wrong) die_user("--%s: %s", option, wrong);
    if (!(value >= low && value <= high))
        die_user("--%s: %s is out of range, expected %g to %g", option, text, low, high);
    return value;
}

static void read_strain_range(const char *text, double range[2])
{
    char *low = memory_text(text), *colon = strchr(low, ':');
    if (!colon) die_user("--strain-range: '%s', expected A:B", text);
    *colon = '\0';
    range[0] = read_number("strain-range", low, 0, 10);
    range[1] = read_number("strain-range", colon + 1, 0, 10);
    if (range[0] >= range[1]) die_user("--strain-range: '%s', expected A below B", text);
    free(low);
}

static const struct hardening_law *read_law(const char *name)
{
    const struct hardening_law *law = hardening_fitted(name);
    if (law) return law;
    char *names = memory_text("");
    for (int i = 0; (law = hardening_law(i)); i++)
        if (law->n_linear > 0) names = memory_print("%s %s", names, law->variant.name);
    die_user("--law: no law '%s'; there are%s", name, names);
}

static void check(const struct request *request)
{
    bool bounds = request->voigt || request->reuss;
    bool anything = request->properties || request->json || request->plot || request->difference;
    if (request->plot) figure_check_name(request->plot);
    if (request->true_curve && !request->plot)
        die_user("--true chooses the figure of --plot; give --plot FILE");
    if (request->columns && (anything || bounds || request->n_files > 1))
        die_user("--columns prints one history and makes nothing else");
    if (request->n_files > 1 && request->output)
        die_user("-o writes one curve, here are %d files; give --plot, --properties or --json",
                 request->n_files);
    if (request->n_files > 1 && !anything && !bounds)
        die_user("%d files and nothing to do with them; give --plot, --properties, --json, "
                 "--difference, --voigt or --reuss",
                 request->n_files);
    if (request->difference && request->n_files != 2)
        die_user("--difference takes two files, here are %d", request->n_files);
    if (bounds && request->n_files != 2)
        die_user("--voigt and --reuss take the two constituents' files, here are %d",
                 request->n_files);
    if (bounds && isnan(request->fraction))
        die_user("--voigt and --reuss need --fraction, that of the second file");
    int pipes = 0;
    for (int i = 0; i < request->n_files; i++) pipes += strcmp(request->files[i], "-") == 0;
    if (pipes > 1) die_user("standard input ('-') can be read once");
}

static void check_view(const struct request *request, bool files)
{
    if (files) die_user("--frames takes the fields; curves (FILE) are for another call");
    if (request->properties || request->json || request->plot || request->difference ||
        request->voigt || request->reuss)
        die_user("--properties, --json, --plot, --difference, --voigt and --reuss are about "
                 "curves; do without --frames");
    if (request->columns) die_user("--columns is about a history; do without --frames");
    if (request->output && request->view.picture && !request->view.csv)
        die_user("-o is the file of --csv; the picture has its own name");
}

struct request request_read(int argc, char **argv)
{
    static const char *const standard_input[] = {"-"};
    struct request r = {.fraction = NAN, .strain_range = {NAN, NAN}};
    struct texts texts = {.law = "voce"};
    const struct option_row own[] = {
        {'o', "output", "FILE", "curve to a file instead of standard output", NULL, &r.output},
        {'p', "properties", "FILE", "properties as CSV", NULL, &r.properties},
        {'j', "json", "FILE", "properties as JSON", NULL, &r.json},
        {0, "plot", "FILE", "figure; the name ends in .svg, .png or .pdf", NULL, &r.plot},
        {0, "true", NULL, "figure of the true curve", &r.true_curve, NULL},
        {0, "difference", NULL, "stress of the first FILE relative to the second", &r.difference,
         NULL},
        {0, "columns", NULL, "a history's columns as they are, of whatever test", &r.columns, NULL},
        {0, "voigt", "FILE", "iso-strain mixture of two FILEs, a curve", NULL, &r.voigt},
        {0, "reuss", "FILE", "iso-stress mixture of two FILEs, a curve", NULL, &r.reuss},
        {0, "fraction", "SHARE", "of the second FILE in the mixture", NULL, &texts.fraction},
        {0, "law", "NAME", "hardening law of the constituents (voce)", NULL, &texts.law},
        {0, "strain-range", "A:B", "of --difference and the mixtures", NULL, &texts.strain_range},
        {'d', "deck", "FILE", "take 'post:' from this deck, not the one within", NULL, &r.deck},
        {'q', "quiet", NULL, "no table of properties on stderr", &r.quiet, NULL},
    };
    enum { OWN = sizeof own / sizeof *own };
    enum { ROWS = OWN + VIEW_OPTION_COUNT + CHOICE_COUNT };
    struct option_row rows[ROWS];
    memcpy(rows, own, sizeof own);
    view_request_options(rows + OWN, &r.view);
    choices_options(rows + OWN + VIEW_OPTION_COUNT, r.choices);
    const struct option_table table = {
        "hspost", "[FILE...] [-o FILE]",
        "Makes tensile curves, properties and figures of histories (hssolve) and of tables\n"
        "(CSV with engineering_strain,engineering_stress_MPa). No FILE or '-': standard input.\n"
        "With --frames instead: pictures of particle fields.",
        rows, ROWS};
    int first = options_read(&table, argc, argv);

    r.n_files = argc > first ? argc - first : 1;
    r.files = argc > first ? (const char *const *)(argv + first) : standard_input;
    if (texts.fraction) r.fraction = read_number("fraction", texts.fraction, 0, 1);
    if (texts.strain_range) read_strain_range(texts.strain_range, r.strain_range);
    r.law = read_law(texts.law);
    view_request_check(&r.view);
    if (r.view.frames)
        check_view(&r, argc > first);
    else
        check(&r);
    return r;
}
