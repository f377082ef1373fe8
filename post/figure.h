/* figure.h - stress-strain figures by gnuplot, through a pipe. */
#ifndef HS_FIGURE_H
#define HS_FIGURE_H

#include "group.h"
#include "loops.h"

#include <stdbool.h>

struct figure_series {
    const char *title;
    const struct curve *curve;       /* NULL: a group */
    const struct analysis *analysis; /* NULL: a computed bound, no marks, dashed */
    const struct group *group; /* drawn as its mean within a band of one standard deviation; NULL */
    const char *words;         /* of the band, in the legend; NULL: those of a deviation */
};

struct figure_style {
    bool true_curve;
    double x_range[2], y_range[2]; /* in the units of the axes; NAN: by the data */
};

/* Dies unless the name ends in .svg, .png or .pdf (exit 2), and gnuplot is at hand (exit 1). */
void figure_check(const char *name);

/* Lines, of seven colours and, beyond, of other dashes.  Engineering stress against strain with
 * Rm marked, or true stress against strain up to maximum force with Considere's point marked.
 * name tells the format, path is where the figure goes. */
void figure_draw(const char *name, const char *path, const struct figure_series series[], int count,
                 const struct figure_style *style);

/* Flow stress (line), back stress (filled) and effective stress (open, dotted) of loops against
 * true strain, a colour a curve. */
struct figure_loops {
    const char *title;
    const struct loop *loops;
    long count;
};
void figure_draw_loops(const char *name, const char *path, const struct figure_loops series[],
                       int count);

#endif
