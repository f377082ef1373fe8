#include "panels.h"

#include "cells.h"
#include "colours.h"
#include "die.h"
#include "legend.h"
#include "memory.h"
#include "scale.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points. */
enum {
    MARGIN = 24,
    SMALL_MARGIN = 14, /* and legend, of a picture whose size is given */
    SMALL_LEGEND = 76,
    TITLE = 22,
    BAR_GAP = 12,
    LEAST_HEIGHT = 100,
    LEAST_WIDTH = 640,
    ROW_GAP = 18,
    CAPTION = 20,
    MOST_FIELDS = 16,
};

static const double background[3] = {0.90, 0.90, 0.90};

/* --- layout ----------------------------------------------------------------------------------- */

static void extend_bounds(struct panels *panels, const struct snapshot *snapshot, double factor)
{
    struct cell *cells = cells_make(snapshot, panels->axes, panels->nodes, panels->count, factor);
    for (int64_t i = 0; i < panels->count; i++)
        for (int c = 0; c < 4; c++)
            for (int a = 0; a < 2; a++) {
                const double x = cells[i].corner[c][a];
                if (!isfinite(x)) continue;
                panels->low[a] = fmin(panels->low[a], x);
                panels->high[a] = fmax(panels->high[a], x);
            }
    free(cells);
}

/* Whole points a particle where there is room for them: no seams. */
static void find_scale(struct panels *panels, double side, double longest)
{
    static const double usual[] = {0, 900, 600, 420};
    if (longest == 0) longest = usual[panels->columns < 3 ? panels->columns : 3];
    double size = fmax(panels->high[0] - panels->low[0], panels->high[1] - panels->low[1]);
    panels->scale = longest / size;
    if (side * panels->scale > 1) panels->scale = floor(side * panels->scale) / side;
    for (int k = 0; k < 2; k++)
        panels->body[k] = round((panels->high[k] - panels->low[k]) * panels->scale);
}

static bool has_marks(const struct snapshot *snapshot, const struct panels *panels)
{
    const struct domain *domain = &snapshot->domain;
    return panels->axes[0] == 0 &&
           (domain_set(domain, "grip_left") || domain_set(domain, "gauge_left"));
}

static void find_size(struct panels *panels, const struct snapshot *snapshot, bool whole)
{
    panels->margin = whole ? MARGIN : SMALL_MARGIN;
    panels->legend = BAR_GAP + (whole ? LEGEND_WIDTH : SMALL_LEGEND);
    panels->height = fmax(fmax(panels->body[1], LEAST_HEIGHT), legend_least_height(snapshot));
    const double panel[2] = {panels->body[0] + panels->legend,
                             TITLE + panels->height + ROW_GAP + (panels->marked ? CANVAS_MARK : 0)};
    panels->size[0] =
        fmax(panels->columns * panel[0], whole ? LEAST_WIDTH : 0) + 2 * panels->margin;
    panels->size[1] = panels->rows * panel[1] + CAPTION + 2 * panels->margin;
}

/* --- ranges ----------------------------------------------------------------------------------- */

/* "A:B", or nothing: automatic. */
static bool read_range(const char *text, const struct field *field, double range[2])
{
    if (*text == '\0') return false;
    char *low = memory_text(text), *colon = strchr(low, ':');
    if (!colon) die_user("--range %s: expected A:B", text);
    *colon = '\0';
    for (int k = 0; k < 2; k++) {
        const char *wrong = units_read(k == 0 ? low : colon + 1, field->unit, &range[k]);
        if (wrong) die_user("--range of %s: %s", field->name, wrong);
    }
    if (!(range[0] < range[1])) die_user("--range %s: the first must be below the second", text);
    free(low);
    return true;
}

/* Texts of the ranges that are given, "" where one is automatic; one for all fields, or one each.
 * The caller frees *given, which they lie in. */
static void split_ranges(const struct snapshot *snapshot, const struct view_request *request,
                         char **given, const char *texts[])
{
    int count = 0;
    char *rest = *given = memory_text(request->range ? request->range : "");
    for (char *text; (text = strsep(&rest, ","));) {
        if (count == snapshot->n_fields) die_user("--range: more ranges than variables");
        texts[count++] = text;
    }
    if (count != 1 && count != snapshot->n_fields)
        die_user("--range: %d ranges for %d variables, expected one for all or for each", count,
                 snapshot->n_fields);
    for (int i = count; i < snapshot->n_fields; i++) texts[i] = texts[0];
}

/* Those of this frame, too. */
static void extend_range(double value, double range[2])
{
    if (!isfinite(value)) return;
    range[0] = fmin(range[0], value);
    range[1] = fmax(range[1], value);
}

void panels_read_range(const struct snapshot *snapshot, const struct view_request *request,
                       double range[2])
{
    const struct field *field = &snapshot->fields[0];
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int64_t i = 0; i < snapshot->domain.n_nodes; i++) extend_range(field->values[i], range);
    if (!read_range(request->range ? request->range : "", field, range)) scale_widen(range);
}

static void go_through(struct panels *panels, struct snapshot *snapshot,
                       const struct view_request *request, int64_t first, int64_t last,
                       double ranges[][2])
{
    const int64_t at = snapshot->frame;
    for (int64_t frame = first; frame <= last; frame++) {
        if (frame != snapshot->frame) snapshot_go(snapshot, request, frame);
        extend_bounds(panels, snapshot, request->factor);
        for (int i = 0; i < snapshot->n_fields; i++)
            for (int64_t k = 0; k < panels->count; k++)
                extend_range(snapshot->fields[i].values[panels->nodes[k]], ranges[i]);
    }
    if (at != snapshot->frame) snapshot_go(snapshot, request, at);
}

struct panels panels_make(struct snapshot *snapshot, const struct view_request *request,
                          double longest, int64_t first, int64_t last)
{
    static const int across[3][2] = {{1, 2}, {0, 2}, {0, 1}};
    const int normal = request->normal;
    const char *texts[MOST_FIELDS];
    char *given;
    if (snapshot->n_fields > MOST_FIELDS)
        die_user("--picture: %d variables, expected %d at most", snapshot->n_fields, MOST_FIELDS);
    split_ranges(snapshot, request, &given, texts);
    struct panels panels = {.axes = {across[normal][0], across[normal][1]},
                            .normal = normal,
                            .low = {INFINITY, INFINITY},
                            .high = {-INFINITY, -INFINITY}};
    panels.nodes =
        snapshot_slice(snapshot, normal, request->position, &panels.position, &panels.count);
    panels.columns = (int)ceil(sqrt(snapshot->n_fields));
    panels.rows = (snapshot->n_fields + panels.columns - 1) / panels.columns;
    panels.marked = has_marks(snapshot, &panels);
    panels.ranges = memory_new((size_t)snapshot->n_fields, sizeof *panels.ranges);
    for (int i = 0; i < snapshot->n_fields; i++)
        memcpy(panels.ranges[i], (double[]){INFINITY, -INFINITY}, sizeof panels.ranges[i]);
    go_through(&panels, snapshot, request, first, last, panels.ranges);
    if (panels.low[0] > panels.high[0])
        die_user("--deformed: no particle has a finite displacement in this frame");
    for (int i = 0; i < snapshot->n_fields; i++)
        if (!read_range(texts[i], &snapshot->fields[i], panels.ranges[i]))
            scale_widen(panels.ranges[i]);
    free(given);
    const double edge = snapshot->edge[panels.axes[0]];
    find_scale(&panels, edge > 0 ? edge : snapshot->side[panels.nodes[0]], longest);
    find_size(&panels, snapshot, longest == 0);
    return panels;
}

void panels_free(struct panels *panels)
{
    free(panels->nodes);
    free(panels->ranges);
    *panels = (struct panels){0};
}

/* --- drawing ---------------------------------------------------------------------------------- */

static void draw_cells(struct canvas *canvas, const struct panels *panels,
                       const struct snapshot *snapshot, double factor, const struct field *field,
                       const double range[2])
{
    struct cell *cells = cells_make(snapshot, panels->axes, panels->nodes, panels->count, factor);
    for (int64_t k = 0; k < panels->count; k++) {
        const double value = field->values[panels->nodes[k]];
        double corners[4][2], colour[3];
        bool there = true;
        for (int c = 0; c < 4; c++) {
            corners[c][0] = (cells[k].corner[c][0] - panels->low[0]) * panels->scale;
            corners[c][1] = (panels->high[1] - cells[k].corner[c][1]) * panels->scale;
            there = there && isfinite(corners[c][0]) && isfinite(corners[c][1]);
        }
        if (!there) continue;
        if (!field->phase) colour_of((value - range[0]) / (range[1] - range[0]), colour);
        canvas_quad(canvas, corners, field->phase ? canvas_phase_colour((int)value) : colour);
    }
    free(cells);
}

/* Where a set of nodes is now along x [points]; false where there is none. */
static bool find_set(const struct panels *panels, const struct snapshot *snapshot, double factor,
                     const char *name, double ends[2])
{
    const struct node_set *set = domain_set(&snapshot->domain, name);
    const double *u = snapshot->displacement[0];
    ends[0] = INFINITY;
    ends[1] = -INFINITY;
    for (int64_t i = 0; set && i < set->count; i++) {
        const int64_t node = set->nodes[i];
        const double x = snapshot->domain.x[node] + (u ? factor * u[node] : 0) - panels->low[0];
        const double half = 0.5 * snapshot->side[node];
        if (!isfinite(x)) continue;
        ends[0] = fmin(ends[0], (x - half) * panels->scale);
        ends[1] = fmax(ends[1], (x + half) * panels->scale);
    }
    return ends[0] <= ends[1];
}

static void draw_marks(struct canvas *canvas, const struct panels *panels,
                       const struct snapshot *snapshot, double factor)
{
    double left[2], right[2];
    if (find_set(panels, snapshot, factor, "grip_left", left))
        canvas_mark(canvas, left[0], left[1], "grip");
    if (find_set(panels, snapshot, factor, "grip_right", right))
        canvas_mark(canvas, right[0], right[1], "grip");
    if (find_set(panels, snapshot, factor, "gauge_left", left) &&
        find_set(panels, snapshot, factor, "gauge_right", right)) {
        canvas_mark(canvas, 0.5 * (left[0] + left[1]), 0.5 * (right[0] + right[1]), "gauge");
    }
}

static void draw_panel(struct canvas *canvas, const struct panels *panels,
                       const struct snapshot *snapshot, double factor, int i)
{
    const struct field *field = &snapshot->fields[i];
    const double *range = panels->ranges[i];
    char *title = legend_title(field, range);
    canvas_text(canvas, 0, -7, ALIGN_LEFT, title);
    canvas_box(canvas, 0, 0, panels->body[0], panels->body[1], background);
    draw_cells(canvas, panels, snapshot, factor, field, range);
    canvas_move(canvas, panels->body[0] + BAR_GAP, 0);
    legend_draw(canvas, snapshot, field, range, panels->height);
    canvas_move(canvas, -panels->body[0] - BAR_GAP, 0);
    if (panels->marked) {
        canvas_move(canvas, 0, panels->body[1] + 6);
        draw_marks(canvas, panels, snapshot, factor);
        canvas_move(canvas, 0, -panels->body[1] - 6);
    }
    free(title);
}

static char *describe(const struct panels *panels, const struct snapshot *snapshot, double factor)
{
    char *time = scale_quantity(snapshot->time, "s");
    char *position = scale_quantity(panels->position, "m");
    char *deformed = factor != 0 ? memory_print(", displacements × %g", factor) : memory_text("");
    char *text = memory_print("%c to the right, %c up; %c = %s, frame %lld of %lld, t = %s%s",
                              "xyz"[panels->axes[0]], "xyz"[panels->axes[1]], "xyz"[panels->normal],
                              position, (long long)snapshot -> frame,
                              (long long)snapshot -> n_frames, time, deformed);
    free(deformed);
    free(position);
    free(time);
    return text;
}

void panels_draw(const struct panels *panels, const struct snapshot *snapshot,
                 const struct view_request *request, struct canvas *canvas, const char *words)
{
    const double panel[2] = {panels->body[0] + panels->legend,
                             TITLE + panels->height + ROW_GAP + (panels->marked ? CANVAS_MARK : 0)};
    const double size = panels->high[0] - panels->low[0];
    canvas_move(canvas, panels->margin, panels->margin + TITLE);
    for (int i = 0; i < snapshot->n_fields; i++) {
        double right = i % panels->columns * panel[0], down = i / panels->columns * panel[1];
        canvas_move(canvas, right, down);
        draw_panel(canvas, panels, snapshot, request->factor, i);
        canvas_move(canvas, -right, -down);
    }
    canvas_move(canvas, 0, panels->rows * panel[1] - TITLE);
    canvas_scale_bar(canvas, size, panels->scale);
    char *text = words ? memory_text(words) : describe(panels, snapshot, request->factor);
    canvas_text(canvas, canvas_bar_length(size) * panels->scale + 90, 8, ALIGN_LEFT, text);
    canvas_move(canvas, -panels->margin, -panels->margin - panels->rows * panel[1]);
    free(text);
}
