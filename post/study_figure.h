/* study_figure.h - which lines and bands a figure of several curves has. */
#ifndef HS_STUDY_FIGURE_H
#define HS_STUDY_FIGURE_H

#include "extrapolation.h"
#include "study.h"

struct study_figure {
    int count, n_groups, n_limits;
    struct figure_series *series; /* [count]; they point into what follows and into the study */
    struct group *groups;
    struct extrapolation *limits;
};

/* One line a curve; with --band, or where there are more curves than one plot holds and some share
 * a title, one band a title, or, with --extrapolate, one band a body; behind them the bounds. */
struct study_figure study_figure_make(const struct request *request, const struct study *study,
                                      const struct curve bounds[], int n_bounds);
void study_figure_free(struct study_figure *figure);

#endif
