#include "page_fields.h"

#include "html.h"
#include "isometric.h"
#include "memory.h"
#include "panels.h"
#include "scale.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points of a body's longer side, so that letters can be read on a telephone; pixels a point; and
 * the largest picture, in points, that all browsers show. */
enum { LAYER = 340, BODY = 340, PIXELS = 2, MOST_HEIGHT = 8000, MOST_FRAMES = 24 };

static void write_picture(FILE *page, struct canvas *canvas, const char *words)
{
    size_t length;
    unsigned char *bytes = canvas_take(canvas, &length);
    fputs("<img ", page);
    html_picture(page, "image/png", bytes, length);
    fputs(" alt=\"", page);
    html_text(page, words);
    fputs("\"/>\n", page);
    free(bytes);
}

/* --- structure -------------------------------------------------------------------------------- */

static void write_layer(FILE *page, struct snapshot *snapshot, const struct view_request *view)
{
    struct panels panels = panels_make(snapshot, view, LAYER, snapshot->frame, snapshot->frame);
    struct canvas *canvas = canvas_open_png(panels.size[0], panels.size[1], PIXELS);
    panels_draw(&panels, snapshot, view, canvas, "");
    fputs("<figure>\n", page);
    write_picture(page, canvas, "Middle layer of the body, coloured by phase");
    fprintf(page, "<figcaption>Layer across %c: %c to the right, %c up.</figcaption>\n</figure>\n",
            "xyz"[panels.normal], "xyz"[panels.axes[0]], "xyz"[panels.axes[1]]);
    panels_free(&panels);
}

static void write_body(FILE *page, const struct snapshot *snapshot, const struct view_request *view)
{
    double range[2], size[2];
    panels_read_range(snapshot, view, range);
    isometric_size(snapshot, BODY, size);
    struct canvas *canvas = canvas_open_png(size[0], size[1], PIXELS);
    isometric_draw(snapshot, range, BODY, canvas);
    fputs("<figure>\n", page);
    write_picture(page, canvas, "The body in three dimensions, coloured by phase");
    fputs("<figcaption>The whole body, an eighth of it cut away.</figcaption>\n</figure>\n", page);
}

static void write_structure(FILE *page, const struct view_request *asked)
{
    struct view_request view = *asked;
    view.variables = "Phase";
    view.frame_number = 1;
    view.at_time = NAN;
    view.factor = 0;
    view.range = NULL;
    struct snapshot snapshot = snapshot_read(&view);
    if (snapshot.domain.n_phases >= 2) {
        html_section(page, "structure", "Structure");
        write_layer(page, &snapshot, &view);
        write_body(page, &snapshot, &view);
        html_end(page);
    }
    snapshot_free(&snapshot);
}

/* --- films ------------------------------------------------------------------------------------ */

/* Of the gauge at a time, by the history; NAN where there is none of this body. */
static double strain_at(const struct study *study, double time)
{
    const struct curve *curve = &study->curves[0];
    const double *t = table_find(&curve->table, "time_s");
    if (study->count > 1 || !t) return NAN;
    for (long i = 1; i < curve->n; i++)
        if (t[i - 1] <= time && time <= t[i] && t[i] > t[i - 1])
            return curve->strain[i - 1] + (time - t[i - 1]) / (t[i] - t[i - 1]) *
                                              (curve->strain[i] - curve->strain[i - 1]);
    return NAN;
}

static char *words_of(const struct study *study, const struct snapshot *snapshot)
{
    static const double percent = 100;
    const double strain = strain_at(study, snapshot->time);
    char *time = isnan(strain) ? scale_quantity(snapshot->time, "s")
                               : memory_print("strain %.3g %%", percent * strain);
    char *words = memory_print("%s, frame %lld of %lld", time, (long long)snapshot->frame,
                               (long long)snapshot->n_frames);
    free(time);
    return words;
}

/* Those that are shown, below each other; returns their number. */
static int draw_frames(const struct panels *panels, struct snapshot *snapshot,
                       const struct view_request *view, const struct study *study,
                       struct canvas **canvas)
{
    const int64_t frames = snapshot->n_frames;
    int64_t room = (int64_t)(MOST_HEIGHT / panels->size[1]);
    if (room > MOST_FRAMES) room = MOST_FRAMES;
    const int64_t count = frames < room ? frames : room > 1 ? room : 1;
    *canvas = canvas_open_png(panels->size[0], (double)count * panels->size[1], PIXELS);
    for (int64_t k = 0; k < count; k++) {
        snapshot_go(snapshot, view, count == 1 ? frames : 1 + k * (frames - 1) / (count - 1));
        char *words = words_of(study, snapshot);
        panels_draw(panels, snapshot, view, *canvas, words);
        canvas_move(*canvas, 0, panels->size[1]);
        free(words);
    }
    return (int)count;
}

static void write_film(FILE *page, struct snapshot *snapshot, const struct view_request *view,
                       const struct study *study)
{
    struct canvas *canvas;
    struct panels panels = panels_make(snapshot, view, LAYER, 1, snapshot->n_frames);
    const int count = draw_frames(&panels, snapshot, view, study, &canvas);
    char *words =
        memory_print("%s in a layer of the body, %d frames", snapshot->fields[0].name, count);
    fprintf(page,
            "<figure class=\"film\" tabindex=\"0\">\n<div style=\"--n:%d;aspect-ratio:%g/%g\">",
            count, panels.size[0], panels.size[1]);
    write_picture(page, canvas, words);
    fputs("</div>\n<figcaption>", page);
    html_text(page, words);
    fprintf(page,
            ", displacements × %g, one range of colours; layer across %c. It stands still while "
            "pointed at or chosen; on paper it is the last frame.</figcaption>\n</figure>\n",
            view->factor, "xyz"[panels.normal]);
    free(words);
    panels_free(&panels);
}

static bool is_zero(const struct panels *panels)
{
    return panels->ranges[0][0] == 0 && panels->ranges[0][1] == 1;
}

/* Of one variable; where nobody asked for it, only what is there and not 0. */
static void write_field(FILE *page, const struct view_request *asked, const struct study *study,
                        const char *name, bool wanted)
{
    struct view_request view = *asked;
    view.variables = name;
    view.at_time = NAN;
    view.frame_number = 0;
    struct snapshot snapshot = snapshot_read(&view);
    struct panels panels =
        panels_make(&snapshot, &view, LAYER, snapshot.n_frames, snapshot.n_frames);
    if (wanted || !is_zero(&panels)) write_film(page, &snapshot, &view, study);
    panels_free(&panels);
    snapshot_free(&snapshot);
}

static bool has(const struct view_request *view, const char *variable)
{
    struct spool input = spool_input(view->frames);
    struct frames frames = exodus_frames_open(&input);
    const bool found = frames_find(&frames, variable) >= 0;
    exodus_frames_close(&frames);
    spool_close(&input);
    return found;
}

void page_fields(FILE *page, const struct request *request, const struct study *study)
{
    static const char *const usual[] = {"EquivalentPlasticStrain", "Damage", "VonMises"};
    struct view_request view = request->view;
    if (!view.frames) return;
    if (!view.deformed && has(&view, "DisplacementX") && has(&view, "DisplacementY"))
        view.factor = 1;
    write_structure(page, &view);
    html_section(page, "fields", "Fields");
    fputs("<p class=\"quiet\">Of <code>", page);
    html_text(page, view.frames);
    fputs("</code>.</p>\n", page);
    char *names = memory_text(view.variables), *rest = names;
    for (char *name; names && (name = strsep(&rest, ","));)
        write_field(page, &view, study, name, true);
    for (size_t i = 0; !names && i < sizeof usual / sizeof *usual; i++)
        if (has(&view, usual[i])) write_field(page, &view, study, usual[i], false);
    free(names);
    html_end(page);
}
