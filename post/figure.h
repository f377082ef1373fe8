/* figure.h - stress-strain figures by gnuplot, through a pipe. */
#ifndef HS_FIGURE_H
#define HS_FIGURE_H

#include "figure_series.h"

#include <stdio.h>

/* Dies unless the name ends in .svg, .png or .pdf (exit 2), and gnuplot is at hand (exit 1). */
void figure_check(const char *name);
/* The second half of that, for what another option makes. */
void figure_check_gnuplot(const char *name, const char *option);

/* Lines of other colours and dashes, in panels where there are many.  Engineering stress against
 * strain with Rm marked, or true stress against strain up to maximum force with Considere's point
 * marked. name tells the format, path is where the figure goes. */
void figure_draw(const char *name, const char *path, const struct figure_series series[], int count,
                 const struct figure_style *style);

/* Flow stress (line), back stress (filled) and effective stress (open, dotted) of loops against
 * true strain, a colour a curve. */
void figure_draw_loops(const char *name, const char *path, const struct figure_loops series[],
                       int count);

/* The same as SVG within a page, on white, with ids that begin with id; what it shows is told by
 * the element "id-words". */
void figure_inline(FILE *page, const char *id, const struct figure_series series[], int count,
                   const struct figure_style *style);
void figure_inline_loops(FILE *page, const char *id, const struct figure_loops series[], int count);

#endif
