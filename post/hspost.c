/* hspost - tensile curves, properties and figures from histories and tables, pictures of fields. */
#include "bounds.h"
#include "columns.h"
#include "deck.h"
#include "die.h"
#include "difference.h"
#include "figure.h"
#include "keys_options.h"
#include "memory.h"
#include "request.h"
#include "sections.h"
#include "snapshot.h"
#include "spool.h"
#include "text_output.h"
#include "view.h"

#include <stdlib.h>
#include <string.h>

/* One curve with all that is known of it. */
struct study {
    struct curve *curves;          /* [count] */
    struct choices *choices;       /* [count] */
    struct analysis *analyses;     /* [count] */
    struct properties *properties; /* [count] */
    const char **titles;           /* [count] */
    struct figure_loops *loops;    /* [count] */
    int count;
    const char *maker; /* "# program: ..." and "# command: ..." lines */
};

static char *describe_maker(int argc, char **argv)
{
    char *command = options_command(argc, argv);
    const char *version = options_version();
    char *text = memory_print("# program: %.*s\n# command: %s\n", (int)strcspn(version, "\n"),
                              version, command);
    free(command);
    return text;
}

/* The deck whose section post counts; NULL: there is none. */
static struct deck *find_deck(const struct request *request, const struct input *input)
{
    const char *within = attributes_text(&input->attributes, "deck");
    const char *name = attributes_text(&input->attributes, "deck_name");
    if (request->deck) return deck_read(request->deck);
    if (!within) return NULL;
    return deck_parse(within, strlen(within), name ? name : "the deck within the history");
}

static struct choices choose(const struct request *request, const struct deck *deck)
{
    struct choices choices = choices_read(deck);
    keys_read_options(&post_section.keys, request->choices, &choices);
    return choices;
}

static struct study read_and_analyse(const struct request *request, const char *maker)
{
    size_t n = (size_t)request->n_files;
    struct study study = {.count = request->n_files, .maker = maker};
    study.curves = memory_new(n, sizeof *study.curves);
    study.choices = memory_new(n, sizeof *study.choices);
    study.analyses = memory_new(n, sizeof *study.analyses);
    study.properties = memory_new(n, sizeof *study.properties);
    study.titles = memory_new(n, sizeof *study.titles);
    study.loops = memory_new(n, sizeof *study.loops);
    for (size_t i = 0; i < n; i++) {
        struct input input = input_read(request->files[i], request->columns_of);
        struct deck *deck = find_deck(request, &input);
        study.choices[i] = choose(request, deck);
        study.curves[i] = curve_make(&input, &study.choices[i]);
        deck_free(deck);
        input_free(&input);
        study.analyses[i] = analysis_make(&study.curves[i], &study.choices[i]);
        if (!request->accept) analysis_check_plausible(&study.curves[i], &study.analyses[i]);
        study.properties[i] =
            analysis_report(&study.curves[i], &study.analyses[i], &study.choices[i]);
        study.titles[i] = study.curves[i].title;
        study.loops[i].title = study.titles[i];
        study.loops[i].loops = loops_find(&study.curves[i], &study.analyses[i],
                                          study.choices[i].loop_offset, &study.loops[i].count);
    }
    return study;
}

static void write_curve(const struct study *study, const struct curve *curve, const char *name)
{
    struct text_output output = text_output_open(name);
    fputs(study->maker, output.file);
    curve_write(output.file, curve);
    text_output_close(&output);
}

static void write_properties(const struct study *study, const char *name,
                             void (*write)(FILE *, const struct properties[], const char *const[],
                                           int))
{
    if (!name) return;
    struct text_output output = text_output_open(name);
    write(output.file, study->properties, study->titles, study->count);
    text_output_close(&output);
}

/* Fills bounds[] with the mixtures asked for, writes them, and returns their number. */
static int make_bounds(const struct request *request, const struct study *study,
                       struct curve bounds[2])
{
    const char *const names[] = {request->voigt, request->reuss};
    int count = 0;
    for (int k = 0; k < 2; k++) {
        if (!names[k]) continue;
        bounds[count] =
            bounds_curve(k == 0 ? BOUND_VOIGT : BOUND_REUSS, study->curves, study->analyses,
                         request->law, request->fraction, request->strain_range);
        write_curve(study, &bounds[count++], names[k]);
    }
    return count;
}

static void draw(const struct request *request, const struct study *study,
                 const struct curve bounds[], int n_bounds)
{
    if (!request->plot) return;
    int count = study->count;
    struct figure_series *series = memory_new((size_t)(count + n_bounds), sizeof *series);
    for (int i = 0; i < count; i++)
        series[i] = (struct figure_series){&study->curves[i], &study->analyses[i]};
    for (int i = 0; i < n_bounds; i++) series[count++] = (struct figure_series){&bounds[i], NULL};
    struct spool spool = spool_output(request->plot);
    figure_draw(request->plot, spool.path, series, count, request->true_curve);
    spool_finish(&spool);
    free(series);
}

static void compare(const struct request *request, const struct study *study)
{
    struct difference difference =
        difference_of(&study->curves[0], &study->curves[1], request->strain_range);
    difference_write(stdout, &difference);
}

static void treat_loops(const struct request *request, const struct study *study)
{
    if (request->loops) {
        struct text_output output = text_output_open(request->loops);
        loops_write_header(output.file, study->count > 1);
        for (int i = 0; i < study->count; i++)
            loops_write(output.file, study->loops[i].loops, study->loops[i].count,
                        study->count > 1 ? study->titles[i] : NULL);
        text_output_close(&output);
    }
    if (!request->plot_loops) return;
    struct spool spool = spool_output(request->plot_loops);
    figure_draw_loops(request->plot_loops, spool.path, study->loops, study->count);
    spool_finish(&spool);
}

static void study_free(struct study *study)
{
    for (int i = 0; i < study->count; i++) {
        curve_free(&study->curves[i]);
        properties_free(&study->properties[i]);
        analysis_free(&study->analyses[i]);
        free((void *)study->loops[i].loops);
    }
    free(study->curves);
    free(study->choices);
    free(study->analyses);
    free(study->properties);
    free(study->titles);
    free(study->loops);
}

static void treat_curves(const struct request *request, const char *maker)
{
    struct study study = read_and_analyse(request, maker);
    for (int i = 0; i < study.count; i++) {
        properties_print(&study.properties[i], study.titles[i]);
        loops_print(study.loops[i].loops, study.loops[i].count);
    }
    write_properties(&study, request->properties, properties_write_csv);
    write_properties(&study, request->json, properties_write_json);
    treat_loops(request, &study);
    struct curve bounds[2];
    int n_bounds = make_bounds(request, &study, bounds);
    draw(request, &study, bounds, n_bounds);
    if (request->difference) compare(request, &study);
    if (study.count == 1) write_curve(&study, &study.curves[0], request->output);
    for (int i = 0; i < n_bounds; i++) curve_free(&bounds[i]);
    study_free(&study);
}

static void check_frames(const struct view_request *request)
{
    struct snapshot snapshot = snapshot_read(request);
    note("%s: frame %lld of %lld, %g s, %lld particles, %d variables", request->frames,
         (long long)snapshot.frame, (long long)snapshot.n_frames, snapshot.time,
         (long long)snapshot.domain.n_nodes, snapshot.n_fields);
    snapshot_free(&snapshot);
}

static void check_columns(const char *file)
{
    struct input input = input_read(file, NULL);
    note("%s: %d columns of %ld rows", input.name, input.table.n_columns, input.table.n_rows);
    input_free(&input);
}

static void check_curves(const struct request *request)
{
    struct deck *deck = request->deck ? deck_read(request->deck) : NULL;
    choose(request, deck);
    deck_free(deck);
    struct study study = read_and_analyse(request, "");
    for (int i = 0; i < study.count; i++)
        note("%s: curve '%s' of %ld points, %d properties", request->files[i], study.titles[i],
             study.curves[i].n, study.properties[i].count);
    study_free(&study);
}

/* Does all but writing: what is wrong ends the program. */
static void check_all(const struct request *request)
{
    const char *const files[] = {request->output, request->properties, request->json,
                                 request->plot,   request->voigt,      request->reuss,
                                 request->loops,  request->plot_loops, request->view.picture};
    if (request->view.frames)
        check_frames(&request->view);
    else if (request->columns && request->n_files > 0)
        check_columns(request->files[0]);
    else
        check_curves(request);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (files[i]) note("would write %s", files[i]);
}

int main(int argc, char **argv)
{
    die_set_program("hspost");
    struct request request = request_read(argc, argv);
    note_set_quiet(request.quiet);
    char *maker = describe_maker(argc, argv);
    if (request.check)
        check_all(&request);
    else if (request.view.frames)
        view_write(&request.view, request.output, maker);
    else if (request.columns)
        columns_write(request.files[0], request.output, maker);
    else
        treat_curves(&request, maker);
    free(maker);
    free(request.choices);
    if (fflush(stdout) != 0 || ferror(stdout)) die_run("cannot write to standard output");
    return 0;
}
