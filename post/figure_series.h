/* figure_series.h - what is drawn in a figure, and how. */
#ifndef HS_FIGURE_SERIES_H
#define HS_FIGURE_SERIES_H

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
    bool whole;                    /* also the fall behind the fracture */
    double x_range[2], y_range[2]; /* in the units of the axes; NAN: by the data */
};

/* Series that one plot has at most; more of them have a panel each. */
enum { FIGURE_MOST_LINES = 8 };

struct figure_loops {
    const char *title;
    const struct loop *loops;
    long count;
};

#endif
