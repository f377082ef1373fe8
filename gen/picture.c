#include "picture.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static bool ends_in(const char *path, const char *end)
{
    size_t length = strlen(path), tail = strlen(end);
    return length > tail && strcmp(path + length - tail, end) == 0;
}

void picture_check_name(const char *path)
{
    if (!ends_in(path, ".png") && !ends_in(path, ".svg"))
        die_user("--picture %s: expected a name that ends in .png or .svg", path);
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
static void draw_row(cairo_t *cairo, const struct structure *structure,
                     const struct section *section, double scale, int64_t up)
{
    int64_t width = structure->sites->count[section->right];
    int64_t height = structure->sites->count[section->up];
    for (int64_t start = 0, end; start < width; start = end) {
        int phase = phase_at(structure, section, start, up);
        for (end = start + 1; end < width && phase_at(structure, section, end, up) == phase;) end++;
        if (phase < 0) continue;
        cairo_set_source_rgb(cairo, colours[phase][0], colours[phase][1], colours[phase][2]);
        cairo_rectangle(cairo, (double)start * scale, (double)(height - 1 - up) * scale,
                        (double)(end - start) * scale, scale);
        cairo_fill(cairo);
    }
}

static void draw_section(cairo_t *cairo, const struct structure *structure,
                         const struct section *section, double scale)
{
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_move_to(cairo, 0, -6);
    cairo_show_text(cairo, section->title);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    for (int64_t up = 0; up < structure->sites->count[section->up]; up++)
        draw_row(cairo, structure, section, scale, up);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

/* A round length (1, 2 or 5 times a power of ten, m) of about a sixth of the specimen. */
static double bar_length(double size)
{
    double power = pow(10, floor(log10(size / 6)));
    double digit = size / 6 / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

static void draw_legend(cairo_t *cairo, const struct recipe *recipe, double scale)
{
    double length = bar_length(recipe->specimen.size[0]);
    double points = length / recipe->specimen.spacing * scale;
    char *text = memory_print("%g mm", 1e3 * length);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_rectangle(cairo, 0, 0, points, 4);
    cairo_fill(cairo);
    cairo_move_to(cairo, points + 8, 8);
    cairo_show_text(cairo, text);
    free(text);
    double x = points + 90;
    for (int phase = 0; phase < recipe->n_phases; phase++) {
        cairo_set_source_rgb(cairo, colours[phase][0], colours[phase][1], colours[phase][2]);
        cairo_rectangle(cairo, x, -4, 12, 12);
        cairo_fill(cairo);
        cairo_set_source_rgb(cairo, 0, 0, 0);
        cairo_move_to(cairo, x + 18, 8);
        cairo_show_text(cairo, recipe->phase_names[phase]);
        x += 110;
    }
}

static void draw(cairo_t *cairo, const struct recipe *recipe, const struct structure *structure,
                 double scale)
{
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, 13);
    cairo_translate(cairo, MARGIN, MARGIN);
    for (int s = 0; s < sections_of(recipe); s++) {
        draw_section(cairo, structure, &sections[s], scale);
        cairo_translate(cairo, 0, (double)structure->sites->count[sections[s].up] * scale + GAP);
    }
    draw_legend(cairo, recipe, scale);
}

void picture_write(const struct recipe *recipe, const struct structure *structure, const char *path)
{
    picture_check_name(path);
    const int64_t *count = structure->sites->count;
    int64_t longest = count[0] > count[1] ? count[0] : count[1];
    double scale = (double)LONGEST_SIDE / (double)longest;
    if (scale > 1) scale = floor(scale); /* whole pixels: no seams */
    double width = fmax((double)longest * scale, 500) + 2 * MARGIN;
    int shown = sections_of(recipe);
    double height = 2 * MARGIN;
    for (int s = 0; s < shown; s++) height += (double)count[sections[s].up] * scale + GAP;
    bool png = ends_in(path, ".png");
    struct spool output = spool_output(path);
    cairo_surface_t *surface =
        png ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)width, (int)height)
            : cairo_svg_surface_create(output.path, width, height);
    cairo_t *cairo = cairo_create(surface);
    draw(cairo, recipe, structure, scale);
    cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    if (png && status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_write_to_png(surface, output.path);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS) die_run("%s: %s", path, cairo_status_to_string(status));
    spool_finish(&output);
}
