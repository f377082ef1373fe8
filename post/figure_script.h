/* figure_script.h - what gnuplot is told about a figure. */
#ifndef HS_FIGURE_SCRIPT_H
#define HS_FIGURE_SCRIPT_H

#include "figure_series.h"

#include <stdio.h>

/* Rows of panels, in which more series than FIGURE_MOST_LINES stand; 0: all are in one plot. */
int figure_rows(int count);

/* Rows of the legend above a plot. */
int figure_legend_rows(const struct figure_series series[], int count);
int figure_loops_legend_rows(const struct figure_loops series[], int count);

void figure_write_curves(FILE *gnuplot, const struct figure_series series[], int count,
                         const struct figure_style *style);
void figure_write_loops(FILE *gnuplot, const struct figure_loops series[], int count);

#endif
