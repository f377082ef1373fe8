/* hspost - tensile curves, properties and figures from histories and tables, pictures of fields. */
#include "columns.h"
#include "crate.h"
#include "deck.h"
#include "die.h"
#include "memory.h"
#include "request.h"
#include "snapshot.h"
#include "study_output.h"
#include "taken.h"
#include "view.h"

#include <stdlib.h>
#include <string.h>

static char *describe_maker(int argc, char **argv)
{
    char *command = options_command(argc, argv);
    const char *version = options_version();
    char *text = memory_print("# program: %.*s\n# command: %s\n", (int)strcspn(version, "\n"),
                              version, command);
    free(command);
    return text;
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
    study_choose(request, deck);
    deck_free(deck);
    struct study study = study_read(request, "");
    for (int i = 0; i < study.count; i++)
        note("%s: curve '%s' of %ld points, %d properties", request->files[i],
             study.labels[i].curve, study.curves[i].n, study.properties[i].count);
    study_free(&study);
}

enum { OUTPUTS = 16 };

static void outputs_of(const struct request *request, const char *files[OUTPUTS])
{
    const char *const all[OUTPUTS] = {request->output,      request->properties,
                                      request->json,        request->plot,
                                      request->voigt,       request->reuss,
                                      request->loops,       request->plot_loops,
                                      request->tidy,        request->mean,
                                      request->statistics,  request->view.picture,
                                      request->extrapolate, request->extrapolate_properties,
                                      request->report,      request->sensitivities};
    memcpy(files, all, sizeof all);
}

static void treat_curves(const struct request *request, const char *maker)
{
    const char *files[OUTPUTS];
    struct study study = study_read(request, maker);
    outputs_of(request, files);
    taken_check(files, OUTPUTS); /* before anything is told of them */
    study_write(request, &study);
    study_free(&study);
}

/* Before anything is read, which may take as long as a run. */
static void check_outputs(const struct request *request)
{
    const char *files[OUTPUTS];
    outputs_of(request, files);
    for (int i = 0; i < OUTPUTS; i++)
        if (files[i]) spool_check_output(files[i]);
    taken_check(files, OUTPUTS);
    if (request->crate && !request->check) crate_check(request->crate);
}

/* Fields by themselves, not for a report. */
static bool view_alone(const struct request *request)
{
    return request->view.frames && !request->report && !request->crate;
}

/* Does all but writing: what is wrong ends the program. */
static void check_all(const struct request *request)
{
    const char *files[OUTPUTS];
    outputs_of(request, files);
    if (view_alone(request))
        check_frames(&request->view);
    else if (request->columns && request->n_files > 0)
        check_columns(request->files[0]);
    else
        check_curves(request);
    for (int i = 0; i < OUTPUTS; i++)
        if (files[i]) note("would write %s", files[i]);
}

int main(int argc, char **argv)
{
    die_set_program("hspost");
    struct request request = request_read(argc, argv);
    note_set_quiet(request.quiet);
    check_outputs(&request);
    char *maker = describe_maker(argc, argv);
    if (request.check)
        check_all(&request);
    else if (view_alone(&request))
        view_write(&request.view, request.output, maker);
    else if (request.columns)
        columns_write(request.files[0], request.output, maker);
    else
        treat_curves(&request, maker);
    free(maker);
    request_free(&request);
    if (fflush(stdout) != 0 || ferror(stdout)) die_run("cannot write to standard output");
    return 0;
}
