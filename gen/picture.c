#include "picture.h"

#include "canvas.h"

#include <math.h>

enum { LONGEST_SIDE = 1000, MARGIN = 30, GAP = 44 }; /* points */

/* Okabe and Ito's palette, told apart by colour-blind readers: coarse, fine, third phase. */
static const double colours[3][3] = {{0.90, 0.62, 0.00}, {0.00, 0.45, 0.70}, {0.60, 0.60, 0.60}};

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

/* One row of sites as few rectangles: runs of one phase. */
static void draw_row(struct canvas *canvas, const struct structure *structure,
                     const struct section *section, double scale, int64_t up)
{
    int64_t width = structure->sites->count[section->right];
    int64_t height = structure->sites->count[section->up];
    for (int64_t start = 0, end; start < width; start = end) {
        int phase = phase_at(structure, section, start, up);
        for (end = start + 1; end < width && phase_at(structure, section, end, up) == phase;) end++;
        if (phase < 0) continue;
        canvas_cell(canvas, (double)start * scale, (double)(height - 1 - up) * scale,
                    (double)(end - start) * scale, scale, colours[phase]);
    }
}

static void draw_section(struct canvas *canvas, const struct structure *structure,
                         const struct section *section, double scale)
{
    canvas_text(canvas, 0, -6, ALIGN_LEFT, section->title);
    for (int64_t up = 0; up < structure->sites->count[section->up]; up++)
        draw_row(canvas, structure, section, scale, up);
}

static void draw_legend(struct canvas *canvas, const struct recipe *recipe, double scale)
{
    double length = recipe->specimen.size[0], metre = scale / recipe->specimen.spacing;
    canvas_scale_bar(canvas, length, metre);
    double x = canvas_bar_length(length) * metre + 90;
    for (int phase = 0; phase < recipe->n_phases; phase++) {
        canvas_box(canvas, x, -4, 12, 12, colours[phase]);
        canvas_text(canvas, x + 18, 8, ALIGN_LEFT, recipe->phase_names[phase]);
        x += 110;
    }
}

void picture_write(const struct recipe *recipe, const struct structure *structure, const char *path)
{
    picture_check_name(path);
    const int64_t *count = structure->sites->count;
    int64_t longest = count[0] > count[1] ? count[0] : count[1];
    double scale = (double)LONGEST_SIDE / (double)longest;
    if (scale > 1) scale = floor(scale); /* whole pixels: no seams */
    double width = fmax((double)longest * scale, 500) + 2 * MARGIN;
    const int shown = sections_of(recipe);
    double height = 2 * MARGIN;
    for (int s = 0; s < shown; s++) height += (double)count[sections[s].up] * scale + GAP;
    struct canvas *canvas = canvas_open(path, width, height);
    canvas_move(canvas, MARGIN, MARGIN);
    for (int s = 0; s < shown; s++) {
        draw_section(canvas, structure, &sections[s], scale);
        canvas_move(canvas, 0, (double)structure->sites->count[sections[s].up] * scale + GAP);
    }
    draw_legend(canvas, recipe, scale);
    canvas_close(canvas);
}
