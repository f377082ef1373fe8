#include "request.h"

#include "die.h"
#include "exodus.h"
#include "figure.h"
#include "keys_options.h"
#include "memory.h"
#include "spool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct key own_rows[] = {
    {"fraction", KEY_NUMBER, offsetof(struct request, fraction), .unit = "1", .low = 0, .high = 1,
     .usual = NAN, .help = "of the second FILE in the mixture"},
    {"strain_range", KEY_NUMBER, offsetof(struct request, strain_range), .unit = "1", .low = 0,
     .high = 10, .size = 2, .rising = true, .usual = NAN,
     .help = "of --difference and the mixtures"},
    {"x_range", KEY_NUMBER, offsetof(struct request, x_range), .unit = "1", .low = -1e6,
     .high = 1e6, .size = 2, .rising = true, .usual = NAN,
     .help = "of the figure's axis, in its unit"},
    {"y_range", KEY_NUMBER, offsetof(struct request, y_range), .unit = "1", .low = -1e9,
     .high = 1e9, .size = 2, .rising = true, .usual = NAN,
     .help = "of the figure's axis, in its unit"},
    {"density", KEY_NUMBER, offsetof(struct request, density), .unit = "kg/m3", .low = 1e-3,
     .high = 1e6, .usual = NAN, .help = "of --material"},
    {"poissons_ratio", KEY_NUMBER, offsetof(struct request, poissons_ratio), .unit = "1",
     .low = -0.99, .high = 0.4999, .usual = NAN, .help = "of --material"},
};
static const struct keys own_keys = KEYS(own_rows);
enum { OWN_OPTIONS = 30, OWN_KEYS = sizeof own_rows / sizeof *own_rows };

static const struct hardening_law *read_law(const char *name)
{
    const struct hardening_law *law = hardening_fitted(name);
    if (law) return law;
    char *names = memory_text("");
    for (int i = 0; (law = hardening_law(i)); i++)
        if (law->n_linear > 0) names = memory_append(names, " %s", law->variant.name);
    die_user("--law: no law '%s'; there are%s", name, names);
}

/* The name becomes a key of the deck and that of a phase. */
static void check_material(const char *name)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    const char *fault = exodus_phase_fault(name);
    if (fault) die_user("--material: the name '%s' %s", name, fault);
    if (!*name || name[strspn(name, plain)])
        die_user("--material: the name '%s', expected letters, digits, _ and - alone", name);
}

static void check(const struct request *request)
{
    const bool page = request->report || request->crate;
    bool bounds = request->voigt || request->reuss;
    bool anything = request->report || request->crate || request->properties || request->json ||
                    request->plot || request->difference || request->loops || request->plot_loops ||
                    request->tidy || request->mean || request->statistics || request->extrapolate ||
                    request->extrapolate_properties || request->sensitivities;
    if (request->calibrate && !request->material) die_user("--calibrate needs --material NAME");
    if (request->material && request->n_files > 1)
        die_user("--material takes one curve, here are %d files", request->n_files);
    if (request->material) check_material(request->material);
    if (request->material && (isnan(request->density) || isnan(request->poissons_ratio)))
        die_user(
            "--material needs --density, as in '8900 kg/m3', and --poissons-ratio, as in 0.31: no "
            "tension test tells them");
    if (request->plot) figure_check(request->plot);
    if (request->report) figure_check_gnuplot(request->report, "report");
    if (request->crate) figure_check_gnuplot(request->crate, "crate");
    if (request->plot_loops) figure_check(request->plot_loops);
    if (request->band && ((!request->plot && !page) || request->true_curve))
        die_user("--band is a way of --plot and --report, for engineering curves");
    if (request->true_curve && !request->plot)
        die_user("--true chooses the figure of --plot; give --plot FILE");
    if (request->whole && !request->plot && !page)
        die_user("--whole chooses the figure of --plot or --report; give one of them");
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
        request->voigt || request->reuss || request->loops || request->plot_loops ||
        request->tidy || request->mean || request->statistics || request->material)
        die_user("--properties, --json, --plot, --loops, --plot-loops, --difference, --voigt, "
                 "--reuss, --tidy, --mean, --statistics and --material are about curves; do "
                 "without --frames");
    if (request->columns) die_user("--columns is about a history; do without --frames");
    if (request->output && request->view.picture && !request->view.csv)
        die_user("-o is the file of --csv; the picture has its own name");
}

static void own_options(struct option_row rows[OWN_OPTIONS], struct request *r)
{
    const struct option_row own[OWN_OPTIONS] = {
        {'o', "output", "FILE", "curve to a file instead of standard output", NULL, &r->output},
        {'p', "properties", "FILE", "properties as CSV", NULL, &r->properties},
        {'j', "json", "FILE", "properties as JSON", NULL, &r->json},
        {0, "plot", "FILE", "figure; the name ends in .svg, .png or .pdf", NULL, &r->plot},
        {0, "report", "FILE", "page with figures, properties, checks, origin: HTML", NULL,
         &r->report},
        {0, "crate", "DIRECTORY", "report, tables, inputs, decks, and an RO-Crate that says how",
         NULL, &r->crate},
        {0, "true", NULL, "figure of the true curve", &r->true_curve, NULL},
        {0, "whole", NULL, "figure with the fall behind the fracture", &r->whole, NULL},
        {0, "loops", "FILE", "loops of unloading and reloading as CSV: back stress and more", NULL,
         &r->loops},
        {0, "plot-loops", "FILE", "figure of flow, back and effective stress", NULL,
         &r->plot_loops},
        {0, "band", NULL, "figure of the mean of each title's curves and a standard deviation",
         &r->band, NULL},
        {0, "tidy", "FILE", "all curves as one long CSV without comments", NULL, &r->tidy},
        {0, "mean", "FILE", "mean curve and deviations of each title's curves as CSV", NULL,
         &r->mean},
        {0, "statistics", "FILE", "means and deviations of the properties as CSV", NULL,
         &r->statistics},
        {0, "extrapolate", "FILE",
         "of a study at several spacings: curves at the spacing 0, and the error", NULL,
         &r->extrapolate},
        {0, "extrapolate-properties", "FILE", "the same of the properties", NULL,
         &r->extrapolate_properties},
        {0, "sensitivities", "FILE",
         "of a study that changes one key at a time: what each change does to the properties", NULL,
         &r->sensitivities},
        {0, "files-from", "LIST", "further FILEs, a name a line", NULL, &r->files_from},
        {0, "difference", NULL, "stress of the first FILE relative to the second", &r->difference,
         NULL},
        {0, "columns", NULL, "a history's columns as they are, of whatever test", &r->columns,
         NULL},
        {0, "material", "NAME", "section materials of a deck, made of the curve, instead of it",
         NULL, &r->material},
        {0, "calibrate", "DIRECTORY",
         "with --material: run its test there by hsgen and hssolve, and compare", NULL,
         &r->calibrate},
        {0, "voigt", "FILE", "iso-strain mixture of two FILEs, a curve", NULL, &r->voigt},
        {0, "reuss", "FILE", "iso-stress mixture of two FILEs, a curve", NULL, &r->reuss},
        {0, "law", "NAME", "hardening law of constituents (voce), or of --material", NULL,
         &r->law_name},
        {0, "columns-of", "LIST",
         "of a table: strain=NAME,stress=NAME:MPa or force=, extension=, time=", NULL,
         &r->columns_of},
        {'d', "deck", "FILE", "take 'post:' from this deck, not the one within", NULL, &r->deck},
        {0, "check", NULL, "read and check all, say what would be made, make nothing", &r->check,
         NULL},
        {0, "accept", NULL, "measure also what cannot be a metal's curve", &r->accept, NULL},
        {'q', "quiet", NULL, "no table of properties on stderr", &r->quiet, NULL},
    };
    memcpy(rows, own, sizeof own);
}

/* Reads the options; returns the index of the first file. */
static int read_options(struct request *r, int argc, char **argv)
{
    static const struct section *const sections[] = {&post_section, NULL};
    const struct keys *choices = &post_section.keys;
    const char *texts[OWN_KEYS] = {0};
    const int count = OWN_OPTIONS + OWN_KEYS + VIEW_OPTION_COUNT + choices->count;
    struct option_row *rows = memory_new((size_t)count, sizeof *rows), *next = rows;
    own_options(rows, r);
    keys_options(&own_keys, next += OWN_OPTIONS, texts);
    view_request_options(next += OWN_KEYS, &r->view);
    r->choices = memory_new((size_t)choices->count, sizeof *r->choices);
    keys_options(choices, next += VIEW_OPTION_COUNT, r->choices);
    const struct option_table table = {
        "hspost",
        "[FILE...] [-o FILE]",
        "Makes tensile curves, properties and figures of histories (hssolve) and of tables of\n"
        "testing machines (text, CSV). No FILE or '-': standard input.\n"
        "With --frames instead: pictures of particle fields.",
        rows,
        count,
        sections};
    int first = options_read(&table, argc, argv);
    keys_options_free(choices, next);
    keys_options_free(&own_keys, rows + OWN_OPTIONS);
    free(rows);
    keys_read_options(&own_keys, texts, r);
    const bool tabulated = r->material && r->law_name && strcmp(r->law_name, "tabulated") == 0;
    r->law = read_law(r->law_name && !tabulated ? r->law_name : "voce");
    return first;
}

/* The names of a list behind those of the command line, of which there are so many. */
static void add_files(struct request *r, int given)
{
    enum { LARGEST = 20000000 };
    long length;
    int count = 0;
    for (int i = 0; i < given; i++) {
        r->listed = memory_grow(r->listed, count, sizeof *r->listed);
        r->listed[count++] = r->files[i];
    }
    r->list = spool_text(r->files_from, LARGEST, &length);
    for (char *rest = r->list, *name; (name = strsep(&rest, "\r\n"));) {
        if (!*name) continue;
        r->listed = memory_grow(r->listed, count, sizeof *r->listed);
        r->listed[count++] = name;
    }
    if (count == 0) die_user("--files-from %s: no names in it", r->files_from);
    r->files = r->listed;
    r->n_files = count;
}

void request_free(struct request *request)
{
    free(request->list);
    free(request->listed);
    free(request->choices);
}

struct request request_read(int argc, char **argv)
{
    static const char *const standard_input[] = {"-"};
    struct request r = {.fraction = NAN,
                        .strain_range = {NAN, NAN},
                        .x_range = {NAN, NAN},
                        .y_range = {NAN, NAN},
                        .density = NAN,
                        .poissons_ratio = NAN};
    const int first = read_options(&r, argc, argv);
    /* A check of the options alone waits for no pipe. */
    r.n_files = argc > first || r.check ? argc - first : 1;
    r.files = argc > first ? (const char *const *)(argv + first) : standard_input;
    if (r.files_from) add_files(&r, argc - first);
    const bool page = r.report || r.crate;
    view_request_check(&r.view, page);
    if (r.view.frames && !page)
        check_view(&r, argc > first);
    else
        check(&r);
    return r;
}
