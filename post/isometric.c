#include "isometric.h"

#include "colours.h"
#include "legend.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points. */
enum { MARGIN = 16, TITLE = 22, GAP = 12, LEAST_HEIGHT = 120 };

/* x goes to the right and down, y to the right and up, z up. */
static const double aside = 0.8660254037844386, down = 0.5;

/* Light from above and a little from the right. */
static const double light[3] = {0.80, 0.62, 1.0}; /* on the faces towards x, -y, z */

struct body {
    const struct snapshot *snapshot;
    const double *at[3]; /* positions at rest */
    double low[3], high[3], middle[3];
    double scale, left, top; /* points a m, and m of the picture's corner */
    int64_t size[3];
    unsigned char *there; /* [size] whether a brick is shown; NULL: of scattered particles */
};

static double edge_of(const struct body *body, int64_t node, int axis)
{
    const double edge = body->snapshot->edge[axis];
    return edge > 0 ? edge : body->snapshot->side[node];
}

static bool is_cut(const struct body *body, int64_t node)
{
    return body->at[0][node] > body->middle[0] && body->at[1][node] < body->middle[1] &&
           body->at[2][node] > body->middle[2];
}

static void project(const struct body *body, const double x[3], double point[2])
{
    point[0] = (aside * (x[0] + x[1]) - body->left) * body->scale;
    point[1] = (down * (x[0] - x[1]) - x[2] - body->top) * body->scale;
}

static int64_t site_of(const struct body *body, int64_t node, int axis)
{
    const double edge = body->snapshot->edge[axis];
    return (int64_t)llround((body->at[axis][node] - body->low[axis]) / edge - 0.5);
}

static struct body body_of(const struct snapshot *snapshot, double longest)
{
    struct body body = {.snapshot = snapshot};
    for (int a = 0; a < 3; a++) {
        body.at[a] = snapshot_axis(snapshot, a);
        body.low[a] = INFINITY;
        body.high[a] = -INFINITY;
        for (int64_t i = 0; i < snapshot->domain.n_nodes; i++) {
            const double half = 0.5 * edge_of(&body, i, a);
            body.low[a] = fmin(body.low[a], body.at[a][i] - half);
            body.high[a] = fmax(body.high[a], body.at[a][i] + half);
        }
        body.middle[a] = 0.5 * (body.low[a] + body.high[a]);
    }
    const double width = aside * (body.high[0] - body.low[0] + body.high[1] - body.low[1]);
    const double height = down * (body.high[0] - body.low[0] + body.high[1] - body.low[1]) +
                          body.high[2] - body.low[2];
    body.scale = longest / fmax(width, height);
    body.left = aside * (body.low[0] + body.low[1]);
    body.top = down * (body.low[0] - body.high[1]) - body.high[2];
    return body;
}

void isometric_size(const struct snapshot *snapshot, double longest, double size[2])
{
    const struct body body = body_of(snapshot, longest);
    const double lower[3] = {body.high[0], body.low[1], body.low[2]};
    const double right[3] = {body.high[0], body.high[1], body.low[2]};
    double end[2];
    project(&body, lower, end);
    size[1] = fmax(end[1], LEAST_HEIGHT) + TITLE + 2 * MARGIN;
    project(&body, right, end);
    size[0] = end[0] + GAP + LEGEND_WIDTH + 2 * MARGIN;
}

/* Where the bricks of a lattice are, so that faces between two of them are not drawn. */
static void find_sites(struct body *body)
{
    enum { ROOM = 16, MORE = 1000000 };
    const int64_t n = body->snapshot->domain.n_nodes;
    double sites = 1;
    for (int a = 0; a < 3; a++) {
        const double edge = body->snapshot->edge[a];
        if (!(edge > 0)) return;
        const double size = (body->high[a] - body->low[a]) / edge;
        sites *= size + 1;
        if (!(sites < (double)(ROOM * n + MORE))) return;
        body->size[a] = (int64_t)llround(size);
    }
    body->there = memory_new((size_t)(body->size[0] * body->size[1] * body->size[2]), 1);
    for (int64_t i = 0; i < n; i++) {
        if (is_cut(body, i)) continue;
        body->there[(site_of(body, i, 2) * body->size[1] + site_of(body, i, 1)) * body->size[0] +
                    site_of(body, i, 0)] = 1;
    }
}

/* Whether the brick beside it, along an axis, hides this one's face. */
static bool is_hidden(const struct body *body, int64_t node, int axis)
{
    int64_t s[3];
    if (!body->there) return false;
    for (int a = 0; a < 3; a++) s[a] = site_of(body, node, a);
    s[axis] += axis == 1 ? -1 : 1;
    if (s[axis] < 0 || s[axis] >= body->size[axis]) return false;
    return body->there[(s[2] * body->size[1] + s[1]) * body->size[0] + s[0]];
}

static void draw_face(const struct body *body, int64_t node, int axis, const double colour[3],
                      struct canvas *canvas)
{
    static const int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
    double corners[4][2], shade[3];
    for (int c = 0; c < 4; c++) {
        double x[3];
        x[axis] = body->at[axis][node] + (axis == 1 ? -0.5 : 0.5) * edge_of(body, node, axis);
        for (int k = 0; k < 2; k++)
            x[across[k]] =
                body->at[across[k]][node] + 0.5 * around[c][k] * edge_of(body, node, across[k]);
        project(body, x, corners[c]);
    }
    for (int k = 0; k < 3; k++) shade[k] = light[axis] * colour[k];
    canvas_quad(canvas, corners, shade);
}

struct brick {
    double depth; /* towards the eye */
    int64_t node;
};

static int nearer(const void *a, const void *b)
{
    const struct brick *p = a, *q = b;
    return p->depth < q->depth   ? -1
           : p->depth > q->depth ? 1
           : p->node < q->node   ? -1
                                 : p->node > q->node;
}

/* Those with a face to be seen, the furthest first. */
static struct brick *find_bricks(const struct body *body, int64_t *count)
{
    struct brick *bricks = NULL;
    *count = 0;
    for (int64_t i = 0; i < body->snapshot->domain.n_nodes; i++) {
        if (is_cut(body, i)) continue;
        if (is_hidden(body, i, 0) && is_hidden(body, i, 1) && is_hidden(body, i, 2)) continue;
        bricks = memory_grow(bricks, *count, sizeof *bricks);
        bricks[(*count)++] = (struct brick){body->at[0][i] - body->at[1][i] + body->at[2][i], i};
    }
    if (*count > 0) qsort(bricks, (size_t)*count, sizeof *bricks, nearer);
    return bricks;
}

/* What it is, how large, and what the colours mean. */
static void draw_words(const struct body *body, const struct field *field, const double range[2],
                       struct canvas *canvas)
{
    static const double milli = 1e-3;
    double size[3], end[2];
    const double right[3] = {body->high[0], body->high[1], body->low[2]};
    for (int a = 0; a < 3; a++) size[a] = (body->high[a] - body->low[a]) / milli;
    char *name = legend_title(field, range);
    char *title = memory_print("%s, %.4g × %.4g × %.4g mm", name, size[0], size[1], size[2]);
    canvas_text(canvas, 0, -7, ALIGN_LEFT, title);
    project(body, right, end);
    canvas_move(canvas, end[0] + GAP, 0);
    legend_draw(canvas, body->snapshot, field, range, LEAST_HEIGHT);
    canvas_move(canvas, -end[0] - GAP, 0);
    free(title);
    free(name);
}

void isometric_draw(const struct snapshot *snapshot, const double range[2], double longest,
                    struct canvas *canvas)
{
    struct body body = body_of(snapshot, longest);
    const struct field *field = &snapshot->fields[0];
    int64_t count;
    find_sites(&body);
    struct brick *bricks = find_bricks(&body, &count);
    canvas_move(canvas, MARGIN, MARGIN + TITLE);
    for (int64_t k = 0; k < count; k++) {
        const int64_t node = bricks[k].node;
        const double value = field->values[node];
        double colour[3];
        colour_of((value - range[0]) / (range[1] - range[0]), colour);
        if (field->phase) memcpy(colour, canvas_phase_colour((int)value), sizeof colour);
        for (int axis = 0; axis < 3; axis++)
            if (!is_hidden(&body, node, axis)) draw_face(&body, node, axis, colour, canvas);
    }
    draw_words(&body, field, range, canvas);
    canvas_move(canvas, -MARGIN, -MARGIN - TITLE);
    free(bricks);
    free(body.there);
}
