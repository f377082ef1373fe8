#include "page.h"

#include "html.h"
#include "memory.h"
#include "page_origin.h"
#include "page_style.h"
#include "page_values.h"
#include "study_figure.h"
#include "text_output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- head ------------------------------------------------------------------------------------- */

/* What all titles begin with, up to a comma. */
static char *title_of(const struct study *study)
{
    const char *first = study->labels[0].title;
    size_t shared = strlen(first);
    for (int k = 1; k < study->count; k++) {
        size_t same = 0;
        while (same < shared && study->labels[k].title[same] == first[same]) same++;
        shared = same;
    }
    if (first[shared] != '\0')
        while (shared > 0 && first[shared] != ',') shared--;
    return shared > 0 ? memory_print("%.*s", (int)shared, first)
                      : memory_print("%d curves", study->count);
}

static void write_links(FILE *page, bool phases)
{
    static const char *const sections[][2] = {
        {"curves", "Curves"},   {"properties", "Properties"}, {"phases", "Phases"},
        {"quality", "Quality"}, {"provenance", "Provenance"}, {"deck", "Deck"},
        {"cite", "How to cite"}};
    fputs("<nav>", page);
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        if (phases || strcmp(sections[i][0], "phases") != 0)
            fprintf(page, "<a href=\"#%s\">%s</a> ", sections[i][0], sections[i][1]);
    fputs("</nav>\n", page);
}

static void write_head(FILE *page, const struct study *study)
{
    char *title = title_of(study);
    bool phases = false;
    for (int k = 0; k < study->count; k++) phases = phases || study->curves[k].n_phases >= 2;
    fputs("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
          "<meta charset=\"utf-8\"/>\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>",
          page);
    html_text(page, title);
    fprintf(page, "</title>\n<style>\n%s</style>\n</head>\n<body>\n<header>\n<h1>", page_style);
    html_text(page, title);
    fputs("</h1>\n", page);
    if (study->question) {
        fputs("<p class=\"question\">", page);
        html_text(page, study->question);
        fputs("</p>\n", page);
    }
    if (study->count == 1) page_cards(page, &study->properties[0]);
    write_links(page, phases);
    fputs("</header>\n<main>\n", page);
    free(title);
}

/* --- figures ---------------------------------------------------------------------------------- */

static void write_figure(FILE *page, const char *id, const struct figure_series series[], int count,
                         const struct figure_style *style, const char *words)
{
    fputs("<figure>\n", page);
    figure_inline(page, id, series, count, style);
    fprintf(page, "<figcaption id=\"%s-words\">%s</figcaption>\n</figure>\n", id, words);
}

static bool has_resolution(const struct study *study)
{
    for (int k = 0; k < study->count; k++)
        for (int i = 0; i < study->labels[k].values.count; i++)
            if (study->labels[k].values.items[i].role == VARIED_RESOLUTION) return true;
    return false;
}

static void write_extrapolation(FILE *page, const struct request *request,
                                const struct study *study)
{
    struct request asked = *request;
    const struct figure_style style = {.x_range = {NAN, NAN}, .y_range = {NAN, NAN}};
    asked.band = true;
    asked.extrapolate = "";
    struct study_figure figure = study_figure_make(&asked, study, NULL, 0);
    if (figure.n_limits > 0) {
        html_section(page, "resolution", "Resolution");
        write_figure(page, "extrapolated", figure.series, figure.count, &style,
                     "Curves extrapolated to the spacing 0, each within its estimated "
                     "discretisation error.");
        page_resolution(page, study, &figure);
        html_end(page);
    }
    study_figure_free(&figure);
}

static void write_loops(FILE *page, const struct study *study)
{
    long loops = 0;
    for (int k = 0; k < study->count; k++) loops += study->loops[k].count;
    if (loops == 0 || study->count > FIGURE_MOST_LINES) return;
    fputs("<figure>\n", page);
    figure_inline_loops(page, "loops", study->loops, study->count);
    fputs("<figcaption id=\"loops-words\">Flow stress, and back and effective stress of the loops "
          "of unloading and reloading.</figcaption>\n</figure>\n",
          page);
}

static void write_curves(FILE *page, const struct request *request, const struct study *study)
{
    struct figure_style style = {false,
                                 request->whole,
                                 {request->x_range[0], request->x_range[1]},
                                 {request->y_range[0], request->y_range[1]}};
    struct study_figure figure = study_figure_make(request, study, NULL, 0);
    const bool bands = figure.series[0].group;
    html_section(page, "curves", "Curves");
    write_figure(page, "engineering", figure.series, figure.count, &style,
                 bands ? "Engineering stress against strain: the mean of the curves of one title, "
                         "within a band of one standard deviation."
                       : "Engineering stress against strain, to the fracture; circles mark the "
                         "tensile strength where the test reached it.");
    style = (struct figure_style){true, false, {NAN, NAN}, {NAN, NAN}};
    if (!bands && figure.count <= FIGURE_MOST_LINES)
        write_figure(page, "true", figure.series, figure.count, &style,
                     "True stress against true strain to the maximum force; circles mark where "
                     "the slope has fallen to the stress (Considère).");
    write_loops(page, study);
    html_end(page);
    study_figure_free(&figure);
}

/* --- all -------------------------------------------------------------------------------------- */

void page_write(const struct request *request, const struct study *study)
{
    struct text_output output = text_output_open(request->report);
    FILE *page = output.file;
    write_head(page, study);
    page_varied(page, study);
    write_curves(page, request, study);
    if (has_resolution(study)) write_extrapolation(page, request, study);
    page_properties(page, study);
    page_phases(page, study);
    page_quality(page, study);
    page_provenance(page, study);
    page_decks(page, study);
    page_citation(page, study);
    fputs("</main>\n</body>\n</html>\n", page);
    text_output_close(&output);
}
