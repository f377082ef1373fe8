/* canvas.h - pictures by cairo: the only file that knows it.
 *
 * Lengths are points, x to the right and y downwards from the origin, which canvas_move shifts.
 * Colours are red, green, blue from 0 to 1 (sRGB).  The same calls give the same bytes: no dates.
 */
#ifndef HS_CANVAS_H
#define HS_CANVAS_H

#include <stddef.h>

struct canvas;

enum canvas_align { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT };

/* Dies (exit 2) unless path ends in .png, .svg or .pdf; option names what gave it in the message.
 */
void canvas_check_name(const char *option, const char *path);

/* A white sheet that appears as the file path when it is closed.  width and height in points (of a
 * PNG: pixels). */
struct canvas *canvas_open(const char *path, double width, double height);
/* A PNG that canvas_take gives; scale: its pixels a point. */
struct canvas *canvas_open_png(double width, double height, double scale);
/* Its bytes, which the caller frees; frees the canvas; dies (exit 1) where that fails. */
unsigned char *canvas_take(struct canvas *canvas, size_t *length);
/* Writes the file and frees; dies (exit 1) where that fails. */
void canvas_close(struct canvas *canvas);

/* Shifts the origin. */
void canvas_move(struct canvas *canvas, double right, double down);

/* A filled rectangle. */
void canvas_box(struct canvas *canvas, double x, double y, double width, double height,
                const double colour[3]);
/* A rectangle with sharp edges: neighbours touch without a seam. */
void canvas_cell(struct canvas *canvas, double x, double y, double width, double height,
                 const double colour[3]);
/* Any quadrilateral, corner by corner; neighbours that share corners touch without a seam. */
void canvas_quad(struct canvas *canvas, double corners[4][2], const double colour[3]);

/* Colour of a phase, distinguishable for all readers (Okabe and Ito): the ninth is as the first. */
const double *canvas_phase_colour(int phase);

/* The outline of a rectangle, a thin black line. */
void canvas_frame(struct canvas *canvas, double x, double y, double width, double height);

/* A black line with ends, from left to right below a body that ends at y = 0, and its name under
 * it; CANVAS_MARK points high. */
enum { CANVAS_MARK = 26 };
void canvas_mark(struct canvas *canvas, double left, double right, const char *name);

/* Black text (UTF-8); x, y is on its base line at the left end, the middle or the right end. */
void canvas_text(struct canvas *canvas, double x, double y, enum canvas_align align,
                 const char *text);

/* A round length (1, 2 or 5 times a power of ten) of about a sixth of size, in the same unit. */
double canvas_bar_length(double size);
/* A bar of canvas_bar_length(size) with its length in mm behind it; size in m, scale in points a m.
 */
void canvas_scale_bar(struct canvas *canvas, double size, double scale);

#endif
