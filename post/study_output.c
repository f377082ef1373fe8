#include "study_output.h"

#include "bounds.h"
#include "calibrate.h"
#include "crate.h"
#include "die.h"
#include "difference.h"
#include "memory.h"
#include "page.h"
#include "sensitivity.h"
#include "study_figure.h"
#include "text_output.h"
#include "tidy.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_curve(const struct study *study, const struct curve *curve, const char *name)
{
    struct text_output output = text_output_open(name);
    fputs(study->maker, output.file);
    curve_write(output.file, curve);
    text_output_close(&output);
}

static void write_properties(const struct study *study, const char *name,
                             void (*write)(FILE *, const struct properties[], const struct label[],
                                           int))
{
    if (!name) return;
    struct text_output output = text_output_open(name);
    write(output.file, study->properties, study->labels, study->count);
    text_output_close(&output);
}

static void write_tidy(const struct study *study, const char *name)
{
    if (!name) return;
    struct text_output output = text_output_open(name);
    tidy_write(output.file, study->curves, study->labels, study->count);
    text_output_close(&output);
}

/* Means over the curves of each title. */
static void treat_groups(const struct request *request, const struct study *study)
{
    if (request->statistics) {
        struct text_output output = text_output_open(request->statistics);
        groups_write_properties(output.file, study->properties, study->labels, study->count);
        text_output_close(&output);
    }
    if (!request->mean) return;
    int count;
    struct group *groups = groups_make(study->analyses, study->labels, study->count, &count);
    struct text_output output = text_output_open(request->mean);
    groups_write(output.file, groups, count, study->labels, study->count);
    text_output_close(&output);
    groups_free(groups, count);
}

/* What the curves of several spacings go to, and what depends on the keys that are changed. */
static void treat_resolution(const struct request *request, const struct study *study)
{
    if (!request->extrapolate && !request->extrapolate_properties && !request->sensitivities)
        return;
    int n_groups, count;
    const double order = study->choices[0].resolution_order;
    struct group *groups = groups_make(study->analyses, study->labels, study->count, &n_groups);
    struct extrapolation *all = extrapolations_make(groups, n_groups, study->analyses,
                                                    study->labels, study->count, order, &count);
    if (request->extrapolate) {
        struct text_output output = text_output_open(request->extrapolate);
        extrapolations_write(output.file, all, count, groups, study->labels, study->count);
        text_output_close(&output);
    }
    if (request->extrapolate_properties) {
        struct text_output output = text_output_open(request->extrapolate_properties);
        extrapolations_write_properties(output.file, all, count, groups, study->properties,
                                        study->labels, study->count, order);
        text_output_close(&output);
    }
    if (request->sensitivities) {
        struct text_output output = text_output_open(request->sensitivities);
        sensitivities_write(output.file, all, count, groups, n_groups, study->properties,
                            study->labels, study->count, order);
        text_output_close(&output);
    }
    extrapolations_free(all, count);
    groups_free(groups, n_groups);
}

/* Fills bounds[] with the mixtures asked for, writes them, and returns their number. */
static int make_bounds(const struct request *request, const struct study *study,
                       struct curve bounds[2])
{
    const char *const names[] = {request->voigt, request->reuss};
    int count = 0;
    for (int k = 0; k < 2; k++) {
        if (!names[k]) continue;
        bounds[count] =
            bounds_curve(k == 0 ? BOUND_VOIGT : BOUND_REUSS, study->curves, study->analyses,
                         request->law, request->fraction, request->strain_range);
        write_curve(study, &bounds[count++], names[k]);
    }
    return count;
}

static void draw(const struct request *request, const struct study *study,
                 const struct curve bounds[], int n_bounds)
{
    if (!request->plot) return;
    struct study_figure figure = study_figure_make(request, study, bounds, n_bounds);
    struct spool spool = spool_output(request->plot);
    const struct figure_style style = {request->true_curve,
                                       request->whole,
                                       {request->x_range[0], request->x_range[1]},
                                       {request->y_range[0], request->y_range[1]}};
    figure_draw(request->plot, spool.path, figure.series, figure.count, &style);
    spool_finish(&spool);
    study_figure_free(&figure);
}

static void compare(const struct request *request, const struct study *study)
{
    struct difference difference =
        difference_of(&study->curves[0], &study->curves[1], request->strain_range);
    difference_write(stdout, &difference);
}

static void treat_loops(const struct request *request, const struct study *study)
{
    if (request->loops) {
        struct text_output output = text_output_open(request->loops);
        loops_write_header(output.file, study->count > 1);
        for (int i = 0; i < study->count; i++)
            loops_write(output.file, study->loops[i].loops, study->loops[i].count,
                        study->count > 1 ? study->labels[i].curve : NULL);
        text_output_close(&output);
    }
    if (!request->plot_loops) return;
    struct spool spool = spool_output(request->plot_loops);
    figure_draw_loops(request->plot_loops, spool.path, study->loops, study->count);
    spool_finish(&spool);
}

static void make_material(const struct request *request, const struct study *study)
{
    struct material material =
        material_make(request->material, &study->curves[0], &study->analyses[0], request->law_name);
    material.density = request->density;
    material.poissons_ratio = request->poissons_ratio;
    struct text_output output = text_output_open(request->output);
    fputs(study->maker, output.file);
    if (request->calibrate)
        calibrate(output.file, request->calibrate, &material,
                  &(struct measured){&study->curves[0], &study->analyses[0], &study->choices[0]});
    else
        material_print(output.file, &material, &study->curves[0], "corner");
    text_output_close(&output);
    material_free(&material);
}

void study_write(const struct request *request, const struct study *study)
{
    for (int i = 0; i < study->count; i++) {
        properties_print(&study->properties[i], study->labels[i].curve);
        loops_print(study->loops[i].loops, study->loops[i].count);
    }
    /* The curve is what the run was for: first, and to the end, whatever becomes of the rest. */
    if (study->count == 1 && !request->material) {
        write_curve(study, &study->curves[0], request->output);
        if (fflush(stdout) != 0) die_run("cannot write to standard output: %s", strerror(errno));
    }
    write_properties(study, request->properties, properties_write_csv);
    write_properties(study, request->json, properties_write_json);
    write_tidy(study, request->tidy);
    treat_groups(request, study);
    treat_resolution(request, study);
    struct curve bounds[2];
    int n_bounds = make_bounds(request, study, bounds);
    if (request->difference) compare(request, study);
    treat_loops(request, study);
    draw(request, study, bounds, n_bounds);
    if (request->report) page_write(request, study, request->report);
    if (request->crate) crate_write(request, study);
    if (request->material) make_material(request, study);
    for (int i = 0; i < n_bounds; i++) curve_free(&bounds[i]);
}
