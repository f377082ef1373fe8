#include "view.h"

#include "csv.h"
#include "exodus.h"
#include "isometric.h"
#include "memory.h"
#include "panels.h"
#include "snapshot.h"
#include "text_output.h"

#include <stdlib.h>
#include <string.h>

/* The particles of the slice where one is asked for, else all. */
static int64_t *choose_particles(const struct snapshot *snapshot,
                                 const struct view_request *request, int64_t *count)
{
    double found;
    if (request->slice)
        return snapshot_slice(snapshot, request->normal, request->position, &found, count);
    *count = snapshot->domain.n_nodes;
    int64_t *nodes = memory_new((size_t)*count, sizeof *nodes);
    for (int64_t i = 0; i < *count; i++) nodes[i] = i;
    return nodes;
}

static void write_csv(const struct snapshot *snapshot, const struct view_request *request,
                      const char *name, const char *maker)
{
    int64_t count, *nodes = choose_particles(snapshot, request, &count);
    struct text_output output = text_output_open(name);
    FILE *file = output.file;
    fprintf(file, "%s# frame: %lld\n# time_s: ", maker, (long long)snapshot->frame);
    csv_number(file, snapshot->time);
    fputs("\nx_m,y_m,z_m", file);
    for (int i = 0; i < snapshot->n_fields; i++) {
        fputc(',', file);
        csv_text(file, snapshot->fields[i].name);
    }
    fputc('\n', file);
    for (int64_t k = 0; k < count; k++) {
        for (int axis = 0; axis < 3; axis++) {
            if (axis > 0) fputc(',', file);
            csv_number(file, snapshot_axis(snapshot, axis)[nodes[k]]);
        }
        for (int i = 0; i < snapshot->n_fields; i++) {
            fputc(',', file);
            csv_number(file, snapshot->fields[i].values[nodes[k]]);
        }
        fputc('\n', file);
    }
    text_output_close(&output);
    free(nodes);
}

/* name.png as name-03.png. */
static char *numbered(const char *name, int64_t frame, int64_t frames)
{
    int digits = 1;
    for (int64_t n = frames; n >= 10; n /= 10) digits++;
    const char *dot = strrchr(name, '.');
    return memory_print("%.*s-%0*lld%s", (int)(dot - name), name, digits, (long long)frame, dot);
}

static void draw_one(const struct panels *panels, const struct snapshot *snapshot,
                     const struct view_request *request, const char *name)
{
    struct canvas *canvas = canvas_open(name, panels->size[0], panels->size[1]);
    panels_draw(panels, snapshot, request, canvas, NULL);
    canvas_close(canvas);
}

/* One picture, or one of each frame. */
static void draw(struct snapshot *snapshot, const struct view_request *request)
{
    const int64_t frames = snapshot->n_frames;
    const bool all = request->every_frame || request->common;
    const int64_t first = all ? 1 : snapshot->frame, last = all ? frames : snapshot->frame;
    struct panels panels = panels_make(snapshot, request, 0, first, last);
    for (int64_t frame = 1; request->every_frame && frame <= frames; frame++) {
        char *name = numbered(request->picture, frame, frames);
        snapshot_go(snapshot, request, frame);
        draw_one(&panels, snapshot, request, name);
        free(name);
    }
    if (!request->every_frame) draw_one(&panels, snapshot, request, request->picture);
    panels_free(&panels);
}

static void draw_body(const struct snapshot *snapshot, const struct view_request *request)
{
    enum { LONGEST = 900 };
    double range[2], size[2];
    panels_read_range(snapshot, request, range);
    isometric_size(snapshot, LONGEST, size);
    struct canvas *canvas = canvas_open(request->picture, size[0], size[1]);
    isometric_draw(snapshot, range, LONGEST, canvas);
    canvas_close(canvas);
}

static void list(const struct view_request *request, const char *name, const char *maker)
{
    struct spool input = spool_input(request->frames);
    struct frames frames = exodus_frames_open(&input);
    struct text_output output = text_output_open(name);
    fprintf(output.file, "%s# nodes: %lld\n# variables:", maker, (long long)frames.n_nodes);
    for (int i = 0; i < frames.n_variables; i++) fprintf(output.file, " %s", frames.variables[i]);
    fputs("\nframe,time_s\n", output.file);
    for (int64_t i = 0; i < frames.n_frames; i++) {
        fprintf(output.file, "%lld,", (long long)i + 1);
        csv_number(output.file, frames.time[i]);
        fputc('\n', output.file);
    }
    text_output_close(&output);
    exodus_frames_close(&frames);
    spool_close(&input);
}

void view_write(const struct view_request *request, const char *output, const char *maker)
{
    if (!request->picture && !request->csv) {
        list(request, output, maker);
        return;
    }
    struct snapshot snapshot = snapshot_read(request);
    if (request->picture && request->isometric)
        draw_body(&snapshot, request);
    else if (request->picture)
        draw(&snapshot, request);
    if (request->csv) write_csv(&snapshot, request, output, maker);
    snapshot_free(&snapshot);
}
