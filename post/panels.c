#include "panels.h"

#include "canvas.h"
#include "colours.h"
#include "die.h"
#include "memory.h"
#include "scale.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points. */
enum {
    MARGIN = 24,
    TITLE = 22,
    BAR_GAP = 12,
    BAR_WIDTH = 14,
    BAR_TEXT = 92,
    LEAST_HEIGHT = 100,
    LEAST_WIDTH = 640,
    ROW_GAP = 18,
    TICK_DISTANCE = 24,
    CAPTION = 20,
    MOST_FIELDS = 16,
};

static const double background[3] = {0.90, 0.90, 0.90};

/* What all panels share: the particles drawn, and where. */
struct layout {
    int right, up, normal; /* axes */
    double position;       /* m of the slice */
    int64_t count, *nodes;
    double low[2], high[2]; /* m, around all particles, right and up */
    double scale;           /* points a m */
    double body[2];         /* points, right and up */
    double height;          /* of body or colour bar */
    int columns, rows;
};

/* --- layout ----------------------------------------------------------------------------------- */

static double place(const struct snapshot *snapshot, double factor, int axis, int64_t node)
{
    const double *u = snapshot->displacement[axis];
    double x = snapshot_axis(snapshot, axis)[node];
    return u ? x + factor * u[node] : x;
}

static void find_bounds(struct layout *layout, const struct snapshot *snapshot, double factor)
{
    const int axes[2] = {layout->right, layout->up};
    for (int k = 0; k < 2; k++) {
        layout->low[k] = INFINITY;
        layout->high[k] = -INFINITY;
        for (int64_t i = 0; i < layout->count; i++) {
            double x = place(snapshot, factor, axes[k], layout->nodes[i]);
            double half = 0.5 * snapshot->side[layout->nodes[i]];
            if (!isfinite(x)) continue;
            layout->low[k] = fmin(layout->low[k], x - half);
            layout->high[k] = fmax(layout->high[k], x + half);
        }
        if (layout->low[k] > layout->high[k])
            die_user("--deformed: no particle has a finite displacement in this frame");
    }
}

/* Whole points a particle where there is room for them: no seams. */
static void find_scale(struct layout *layout, double side)
{
    static const double longest[] = {0, 900, 600, 420};
    double size = fmax(layout->high[0] - layout->low[0], layout->high[1] - layout->low[1]);
    layout->scale = longest[layout->columns < 3 ? layout->columns : 3] / size;
    if (side * layout->scale > 1) layout->scale = floor(side * layout->scale) / side;
    for (int k = 0; k < 2; k++)
        layout->body[k] = round((layout->high[k] - layout->low[k]) * layout->scale);
    layout->height = fmax(layout->body[1], LEAST_HEIGHT);
}

static struct layout make_layout(const struct snapshot *snapshot,
                                 const struct view_request *request)
{
    static const int across[3][2] = {{1, 2}, {0, 2}, {0, 1}};
    struct layout layout = {.normal = request->normal};
    layout.right = across[request->normal][0];
    layout.up = across[request->normal][1];
    layout.nodes = snapshot_slice(snapshot, request->normal, request->position, &layout.position,
                                  &layout.count);
    layout.columns = (int)ceil(sqrt(snapshot->n_fields));
    layout.rows = (snapshot->n_fields + layout.columns - 1) / layout.columns;
    find_bounds(&layout, snapshot, request->factor);
    find_scale(&layout, snapshot->side[layout.nodes[0]]);
    return layout;
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

/* One range for all fields, or one each. */
static void find_ranges(const struct snapshot *snapshot, const struct view_request *request,
                        const struct layout *layout, double ranges[][2])
{
    char *given = memory_text(request->range ? request->range : ""), *rest = given;
    char *texts[MOST_FIELDS];
    int count = 0;
    for (char *text; (text = strsep(&rest, ","));) {
        if (count == snapshot->n_fields) die_user("--range: more ranges than variables");
        texts[count++] = text;
    }
    if (count != 1 && count != snapshot->n_fields)
        die_user("--range: %d ranges for %d variables, expected one for all or for each", count,
                 snapshot->n_fields);
    for (int i = 0; i < snapshot->n_fields; i++) {
        const struct field *field = &snapshot->fields[i];
        if (!read_range(texts[count == 1 ? 0 : i], field, ranges[i]))
            scale_find_range(field->values, layout->nodes, layout->count, ranges[i]);
    }
    free(given);
}

/* --- drawing ---------------------------------------------------------------------------------- */

static void draw_particles(struct canvas *canvas, const struct snapshot *snapshot, double factor,
                           const struct layout *layout, const double *values,
                           const struct scale *scale)
{
    for (int64_t k = 0; k < layout->count; k++) {
        int64_t node = layout->nodes[k];
        double half = 0.5 * snapshot->side[node], colour[3];
        double x = place(snapshot, factor, layout->right, node) - half - layout->low[0];
        double y = layout->high[1] - place(snapshot, factor, layout->up, node) - half;
        if (!isfinite(x) || !isfinite(y)) continue;
        /* Deformed neighbours do not lie on whole points: the overlap hides rounding. */
        double edge = fmax(2 * half * layout->scale, 1) + (factor != 0);
        colour_of((values[node] - scale->low) / (scale->high - scale->low), colour);
        canvas_cell(canvas, x * layout->scale, y * layout->scale, edge, edge, colour);
    }
}

/* From the top downwards; x is its left edge. */
static void draw_bar(struct canvas *canvas, double x, double height, const struct scale *scale)
{
    for (int k = 0; k < (int)height; k++) {
        double colour[3];
        colour_of(1 - (k + 0.5) / height, colour);
        canvas_cell(canvas, x, k, BAR_WIDTH, 1, colour);
    }
    canvas_frame(canvas, x, 0, BAR_WIDTH, height);
    for (int k = 0; k < scale->n_ticks; k++) {
        static const double black[3] = {0, 0, 0};
        double share = (scale->ticks[k] - scale->low) / (scale->high - scale->low);
        char *text = scale_text(scale, scale->ticks[k]);
        canvas_box(canvas, x + BAR_WIDTH, height * (1 - share) - 0.5, 4, 1, black);
        canvas_text(canvas, x + BAR_WIDTH + 7, height * (1 - share) + 5, ALIGN_LEFT, text);
        free(text);
    }
}

static void draw_panel(struct canvas *canvas, const struct snapshot *snapshot, double factor,
                       const struct layout *layout, const struct field *field,
                       const double range[2])
{
    struct scale scale = scale_make(range, field->unit, (int)layout->height / TICK_DISTANCE);
    char *title =
        *scale.unit ? memory_print("%s (%s)", field->name, scale.unit) : memory_text(field->name);
    canvas_text(canvas, 0, -7, ALIGN_LEFT, title);
    canvas_box(canvas, 0, 0, layout->body[0], layout->body[1], background);
    draw_particles(canvas, snapshot, factor, layout, field->values, &scale);
    draw_bar(canvas, layout->body[0] + BAR_GAP, layout->height, &scale);
    free(title);
    scale_free(&scale);
}

static void draw_caption(struct canvas *canvas, const struct snapshot *snapshot,
                         const struct view_request *request, const struct layout *layout)
{
    double size = layout->high[0] - layout->low[0];
    char *time = scale_quantity(snapshot->time, "s");
    char *position = scale_quantity(layout->position, "m");
    char *deformed = request->factor != 0 ? memory_print(", displacements × %g", request->factor)
                                          : memory_text("");
    char *text =
        memory_print("%c to the right, %c up; %c = %s, frame %lld of %lld, t = %s%s",
                     "xyz"[layout->right], "xyz"[layout->up], "xyz"[layout->normal], position,
                     (long long)snapshot -> frame, (long long)snapshot -> n_frames, time, deformed);
    canvas_scale_bar(canvas, size, layout->scale);
    canvas_text(canvas, canvas_bar_length(size) * layout->scale + 90, 8, ALIGN_LEFT, text);
    free(text);
    free(deformed);
    free(position);
    free(time);
}

void panels_draw(const struct snapshot *snapshot, const struct view_request *request)
{
    double ranges[MOST_FIELDS][2];
    if (snapshot->n_fields > MOST_FIELDS)
        die_user("--picture: %d variables, expected %d at most", snapshot->n_fields, MOST_FIELDS);
    struct layout layout = make_layout(snapshot, request);
    find_ranges(snapshot, request, &layout, ranges);
    double panel[2] = {layout.body[0] + BAR_GAP + BAR_WIDTH + BAR_TEXT,
                       TITLE + layout.height + ROW_GAP};
    double width = fmax(layout.columns * panel[0], LEAST_WIDTH) + 2 * MARGIN;
    double height = layout.rows * panel[1] + CAPTION + 2 * MARGIN;
    struct canvas *canvas = canvas_open(request->picture, width, height);
    canvas_move(canvas, MARGIN, MARGIN + TITLE);
    for (int i = 0; i < snapshot->n_fields; i++) {
        double right = i % layout.columns * panel[0], down = i / layout.columns * panel[1];
        canvas_move(canvas, right, down);
        draw_panel(canvas, snapshot, request->factor, &layout, &snapshot->fields[i], ranges[i]);
        canvas_move(canvas, -right, -down);
    }
    canvas_move(canvas, 0, layout.rows * panel[1] - TITLE);
    draw_caption(canvas, snapshot, request, &layout);
    canvas_close(canvas);
    free(layout.nodes);
}
