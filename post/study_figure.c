#include "study_figure.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>

static bool wants_bands(const struct request *request, const struct study *study,
                        const struct study_figure *figure)
{
    const bool many = study->count > FIGURE_MOST_LINES && figure->n_groups < study->count;
    bool any = false;
    for (int i = 0; i < figure->n_groups; i++) any = any || figure->groups[i].n > 0;
    if (!any) return false;
    return request->band || (many && !request->true_curve);
}

/* One series a group, or one a body that is extrapolated. */
static void add_bands(struct study_figure *figure)
{
    for (int i = 0; i < figure->n_limits; i++)
        figure->series[figure->count++] =
            (struct figure_series){.title = figure->limits[i].title,
                                   .group = &figure->limits[i].curve,
                                   .words = "extrapolated, with error"};
    for (int i = 0; figure->n_limits == 0 && i < figure->n_groups; i++)
        if (figure->groups[i].n > 0)
            figure->series[figure->count++] = (struct figure_series){
                .title = figure->groups[i].title, .group = &figure->groups[i]};
}

struct study_figure study_figure_make(const struct request *request, const struct study *study,
                                      const struct curve bounds[], int n_bounds)
{
    struct study_figure figure = {0};
    figure.groups = groups_make(study->analyses, study->labels, study->count, &figure.n_groups);
    figure.series = memory_new((size_t)(study->count + n_bounds), sizeof *figure.series);
    const bool bands = wants_bands(request, study, &figure);
    if (bands && !request->band)
        note("%d curves in one figure: means and deviations of those of one title", study->count);
    if (bands && request->extrapolate)
        figure.limits =
            extrapolations_make(figure.groups, figure.n_groups, study->analyses, study->labels,
                                study->count, study->choices[0].resolution_order, &figure.n_limits);
    if (bands) add_bands(&figure);
    for (int i = 0; !bands && i < study->count; i++)
        figure.series[figure.count++] = (struct figure_series){.title = study->labels[i].curve,
                                                               .curve = &study->curves[i],
                                                               .analysis = &study->analyses[i]};
    for (int i = 0; i < n_bounds; i++)
        figure.series[figure.count++] =
            (struct figure_series){.title = bounds[i].title, .curve = &bounds[i]};
    return figure;
}

void study_figure_free(struct study_figure *figure)
{
    extrapolations_free(figure->limits, figure->n_limits);
    groups_free(figure->groups, figure->n_groups);
    free(figure->series);
    *figure = (struct study_figure){0};
}
