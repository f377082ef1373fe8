#include "canvas.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct canvas {
    char *name; /* in messages */
    struct spool output;
    bool png;
    unsigned char *bytes; /* of a PNG that goes to no file */
    size_t length;
    cairo_surface_t *surface;
    cairo_t *cairo;
};

enum { FONT_SIZE = 13 };

static bool ends_in(const char *path, const char *end)
{
    size_t length = strlen(path), tail = strlen(end);
    return length > tail && strcmp(path + length - tail, end) == 0;
}

void canvas_check_name(const char *option, const char *path)
{
    if (!ends_in(path, ".png") && !ends_in(path, ".svg") && !ends_in(path, ".pdf"))
        die_user("--%s %s: expected a name that ends in .png, .svg or .pdf", option, path);
}

static cairo_surface_t *pdf_surface(const char *path, double width, double height)
{
    cairo_surface_t *surface = cairo_pdf_surface_create(path, width, height);
    /* Otherwise the time of the run gets in. */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, NULL);
    return surface;
}

static void begin(struct canvas *canvas)
{
    cairo_t *cairo = canvas->cairo = cairo_create(canvas->surface);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, FONT_SIZE);
}

struct canvas *canvas_open(const char *path, double width, double height)
{
    struct canvas *canvas = memory_new(1, sizeof *canvas);
    canvas->name = memory_text(path);
    canvas->png = ends_in(path, ".png");
    canvas->output = spool_output(path);
    if (canvas->png)
        canvas->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)width, (int)height);
    else if (ends_in(path, ".svg"))
        canvas->surface = cairo_svg_surface_create(canvas->output.path, width, height);
    else
        canvas->surface = pdf_surface(canvas->output.path, width, height);
    begin(canvas);
    return canvas;
}

struct canvas *canvas_open_png(double width, double height, double scale)
{
    struct canvas *canvas = memory_new(1, sizeof *canvas);
    canvas->name = memory_text("a picture");
    canvas->png = true;
    canvas->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(scale * width),
                                                 (int)ceil(scale * height));
    begin(canvas);
    cairo_scale(canvas->cairo, scale, scale);
    return canvas;
}

/* The end of drawing; dies where something went wrong before. */
static void finish(struct canvas *canvas, cairo_status_t status)
{
    cairo_surface_finish(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(canvas->surface);
    cairo_surface_destroy(canvas->surface);
    if (status != CAIRO_STATUS_SUCCESS)
        die_run("%s: %s", canvas->name, cairo_status_to_string(status));
}

static cairo_status_t add_bytes(void *place, const unsigned char *bytes, unsigned length)
{
    struct canvas *canvas = place;
    unsigned char *all = memory_new(canvas->length + length, 1);
    if (canvas->bytes) memcpy(all, canvas->bytes, canvas->length);
    memcpy(all + canvas->length, bytes, length);
    free(canvas->bytes);
    canvas->bytes = all;
    canvas->length += length;
    return CAIRO_STATUS_SUCCESS;
}

unsigned char *canvas_take(struct canvas *canvas, size_t *length)
{
    cairo_status_t status = cairo_status(canvas->cairo);
    cairo_destroy(canvas->cairo);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_write_to_png_stream(canvas->surface, add_bytes, canvas);
    finish(canvas, status);
    unsigned char *bytes = canvas->bytes;
    *length = canvas->length;
    free(canvas->name);
    free(canvas);
    return bytes;
}

void canvas_close(struct canvas *canvas)
{
    cairo_status_t status = cairo_status(canvas->cairo);
    cairo_destroy(canvas->cairo);
    if (canvas->png && status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_write_to_png(canvas->surface, canvas->output.path);
    finish(canvas, status);
    spool_finish(&canvas->output);
    free(canvas->name);
    free(canvas);
}

void canvas_move(struct canvas *canvas, double right, double down)
{
    cairo_translate(canvas->cairo, right, down);
}

void canvas_box(struct canvas *canvas, double x, double y, double width, double height,
                const double colour[3])
{
    cairo_set_source_rgb(canvas->cairo, colour[0], colour[1], colour[2]);
    cairo_rectangle(canvas->cairo, x, y, width, height);
    cairo_fill(canvas->cairo);
}

void canvas_cell(struct canvas *canvas, double x, double y, double width, double height,
                 const double colour[3])
{
    cairo_set_antialias(canvas->cairo, CAIRO_ANTIALIAS_NONE);
    canvas_box(canvas, x, y, width, height, colour);
    cairo_set_antialias(canvas->cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void canvas_quad(struct canvas *canvas, double corners[4][2], const double colour[3])
{
    static const double overlap = 1; /* hides the hairlines that viewers of SVG and PDF leave */
    cairo_t *cairo = canvas->cairo;
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_move_to(cairo, corners[0][0], corners[0][1]);
    for (int k = 1; k < 4; k++) cairo_line_to(cairo, corners[k][0], corners[k][1]);
    cairo_close_path(cairo);
    if (!canvas->png) {
        cairo_set_line_width(cairo, overlap);
        cairo_stroke_preserve(cairo);
    }
    cairo_fill(cairo);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

/* Coarse, fine, grips or third phase, further ones. */
const double *canvas_phase_colour(int phase)
{
    static const double colours[][3] = {{0.90, 0.62, 0.00}, {0.00, 0.45, 0.70}, {0.60, 0.60, 0.60},
                                        {0.00, 0.62, 0.45}, {0.80, 0.47, 0.65}, {0.84, 0.37, 0.00},
                                        {0.34, 0.71, 0.91}, {0.94, 0.89, 0.26}};
    return colours[phase % (int)(sizeof colours / sizeof *colours)];
}

void canvas_frame(struct canvas *canvas, double x, double y, double width, double height)
{
    cairo_set_source_rgb(canvas->cairo, 0, 0, 0);
    cairo_set_line_width(canvas->cairo, 1);
    cairo_rectangle(canvas->cairo, x, y, width, height);
    cairo_stroke(canvas->cairo);
}

void canvas_text(struct canvas *canvas, double x, double y, enum canvas_align align,
                 const char *text)
{
    cairo_text_extents_t extents = {0};
    if (align != ALIGN_LEFT) cairo_text_extents(canvas->cairo, text, &extents);
    double before = align == ALIGN_CENTRE ? 0.5 : align == ALIGN_RIGHT ? 1 : 0;
    cairo_set_source_rgb(canvas->cairo, 0, 0, 0);
    cairo_move_to(canvas->cairo, x - before * extents.x_advance, y);
    cairo_show_text(canvas->cairo, text);
}

static const double black[3] = {0, 0, 0};

void canvas_mark(struct canvas *canvas, double left, double right, const char *name)
{
    enum { TICK = 6, LINE = 2 };
    const double width = fmax(right - left, LINE);
    canvas_box(canvas, left, TICK / 2, width, LINE, black);
    canvas_box(canvas, left, 0, LINE, TICK + LINE, black);
    canvas_box(canvas, left + width - LINE, 0, LINE, TICK + LINE, black);
    canvas_text(canvas, 0.5 * (left + right), CANVAS_MARK - 4, ALIGN_CENTRE, name);
}

double canvas_bar_length(double size)
{
    double power = pow(10, floor(log10(size / 6)));
    double digit = size / 6 / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

void canvas_scale_bar(struct canvas *canvas, double size, double scale)
{
    double length = canvas_bar_length(size);
    char *text = memory_print("%g mm", 1e3 * length);
    canvas_box(canvas, 0, 0, length * scale, 4, black);
    canvas_text(canvas, length * scale + 8, 8, ALIGN_LEFT, text);
    free(text);
}
