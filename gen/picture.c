#include "picture.h"

#include "canvas.h"

#include <math.h>

enum { LONGEST_SIDE = 1000, MARGIN = 30, GAP = 44 }; /* points */

/* A section: the axes that point right and up, and the layer of the third. */
struct section {
    const char *title;
    int right, up;
};

static const struct section sections[] = {{"xy", 0, 1}, {"xz", 0, 2}, {"yz", 1, 2}};
enum { N_SECTIONS = sizeof sections / sizeof *sections };

/* A sheet has one. */
static int sections_of(const struct recipe *recipe)
{
    return specimen_is_sheet(&recipe->specimen) ? 1 : N_SECTIONS;
}

void picture_check_name(const char *path)
{
    canvas_check_name("picture", path);
}

/* Phase of a site, -1 where there is no node. */
static int phase_at(const struct structure *structure, const struct section *section, int64_t right,
                    int64_t up)
{
    const struct sites *sites = structure->sites;
    int64_t at[3] = {sites->count[0] / 2, sites->count[1] / 2, sites->count[2] / 2};
    at[section->right] = right;
    at[section->up] = up;
    int64_t node = sites_at(sites, at[0], at[1], at[2]);
    return node < 0 ? -1 : structure->phase[node];
}

/* One row of sites as few rectangles: runs of one phase.  cell: points, edges along x, y, z. */
static void draw_row(struct canvas *canvas, const struct structure *structure,
                     const struct section *section, const double cell[3], int64_t up)
{
    const double step = cell[section->right], rise = cell[section->up];
    int64_t width = structure->sites->count[section->right];
    int64_t height = structure->sites->count[section->up];
    for (int64_t start = 0, end; start < width; start = end) {
        int phase = phase_at(structure, section, start, up);
        for (end = start + 1; end < width && phase_at(structure, section, end, up) == phase;) end++;
        if (phase < 0) continue;
        canvas_cell(canvas, (double)start * step, (double)(height - 1 - up) * rise,
                    (double)(end - start) * step, rise, canvas_phase_colour(phase));
    }
}

static void draw_section(struct canvas *canvas, const struct structure *structure,
                         const struct section *section, const double cell[3])
{
    canvas_text(canvas, 0, -6, ALIGN_LEFT, section->title);
    for (int64_t up = 0; up < structure->sites->count[section->up]; up++)
        draw_row(canvas, structure, section, cell, up);
}

/* Of a body that is turned they would be slanted. */
static bool has_marks(const struct specimen *specimen)
{
    return specimen->angle == 0 && (specimen->grip_length > 0 || specimen->gauge_length > 0);
}

/* Grips and gauge, below the section whose lower left corner is the origin.  metre: points. */
static void draw_marks(struct canvas *canvas, const struct specimen *specimen, double metre)
{
    const double length = specimen->size[0], grip = specimen->grip_length,
                 gauge = specimen->gauge_length;
    if (grip > 0) {
        canvas_mark(canvas, 0, grip * metre, "grip");
        canvas_mark(canvas, (length - grip) * metre, length * metre, "grip");
    }
    if (gauge > 0)
        canvas_mark(canvas, 0.5 * (length - gauge) * metre, 0.5 * (length + gauge) * metre,
                    "gauge");
}

static void draw_legend(struct canvas *canvas, const struct recipe *recipe, const double cell[3])
{
    double length = recipe->specimen.size[0], metre = cell[0] / recipe->specimen.spacing[0];
    canvas_scale_bar(canvas, length, metre);
    double x = canvas_bar_length(length) * metre + 90;
    for (int phase = 0; phase < recipe->n_phases; phase++) {
        canvas_box(canvas, x, -4, 12, 12, canvas_phase_colour(phase));
        canvas_text(canvas, x + 18, 8, ALIGN_LEFT, recipe->phase_names[phase]);
        x += 110;
    }
}

/* Edges of a cell in points; returns the longer side of the section xy. */
static double size_cell(const struct sites *sites, double cell[3])
{
    const double *edge = sites->spacing;
    const double y = edge[1] / edge[0], z = edge[2] / edge[0];
    const double longest = fmax((double)sites->count[0], (double)sites->count[1] * y);
    double scale = LONGEST_SIDE / longest;
    if (scale > 1) scale = floor(scale); /* whole pixels along x: no seams */
    cell[0] = scale;
    cell[1] = scale * y;
    cell[2] = scale * z;
    return longest * scale;
}

void picture_write(const struct recipe *recipe, const struct structure *structure, const char *path)
{
    picture_check_name(path);
    const int64_t *count = structure->sites->count;
    double cell[3];
    const double longest = size_cell(structure->sites, cell);
    double width = fmax(longest, 500) + 2 * MARGIN;
    const int shown = sections_of(recipe);
    const double marks = has_marks(&recipe->specimen) ? CANVAS_MARK : 0;
    double height = 2 * MARGIN + marks;
    for (int s = 0; s < shown; s++)
        height += (double)count[sections[s].up] * cell[sections[s].up] + GAP;
    struct canvas *canvas = canvas_open(path, width, height);
    canvas_move(canvas, MARGIN, MARGIN);
    for (int s = 0; s < shown; s++) {
        draw_section(canvas, structure, &sections[s], cell);
        canvas_move(canvas, 0, (double)count[sections[s].up] * cell[sections[s].up]);
        if (s == 0 && marks > 0)
            draw_marks(canvas, &recipe->specimen, cell[0] / recipe->specimen.spacing[0]);
        canvas_move(canvas, 0, GAP + (s == 0 ? marks : 0));
    }
    draw_legend(canvas, recipe, cell);
    canvas_close(canvas);
}
