#include "page.h"

#include "die.h"
#include "html.h"
#include "memory.h"
#include "page_fields.h"
#include "page_origin.h"
#include "page_style.h"
#include "page_values.h"
#include "study_figure.h"
#include "text_output.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- head ------------------------------------------------------------------------------------- */

static char *title_of(const struct study *study)
{
    const char *first = study->labels[0].title;
    const size_t shared = labels_shared(study->labels, study->count);
    for (int k = 0; k < study->count && shared == 0; k++)
        if (strcmp(study->labels[k].title, first) != 0)
            return memory_print("%d curves", study->count);
    return shared > 0 ? memory_print("%.*s", (int)shared - 2, first) : memory_text(first);
}

/* To each section of the page. */
static void write_links(FILE *page, const char *body)
{
    static const char section[] = "<section id=\"", heading[] = "<h2>";
    fputs("<nav>", page);
    while ((body = strstr(body, section))) {
        const char *id = body += strlen(section);
        const char *words = body = strstr(body, heading) + strlen(heading);
        fprintf(page, "<a href=\"#%.*s\">%.*s</a> ", (int)strcspn(id, "\""), id,
                (int)strcspn(words, "<"), words);
    }
    fputs("</nav>\n", page);
}

static void write_head(FILE *page, const struct study *study, const char *body)
{
    char *title = title_of(study);
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
    write_links(page, body);
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
    if (loops < 2 || study->count > FIGURE_MOST_LINES) return;
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
    struct request asked = *request;
    asked.band = page_groups(study) < study->count;
    struct study_figure figure = study_figure_make(&asked, study, NULL, 0);
    const bool bands = figure.series[0].group;
    html_section(page, "curves", "Curves");
    write_figure(
        page, "engineering", figure.series, figure.count, &style,
        figure.count > FIGURE_MOST_LINES
            ? "Engineering stress against strain, the first of them in grey for comparison."
        : bands ? "Engineering stress against strain: the mean of the curves of one title, "
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

/* The caller frees it. */
static char *body_of(const struct request *request, const struct study *study)
{
    char *text;
    size_t length;
    FILE *page = open_memstream(&text, &length);
    if (!page) die_run("a report: %s", strerror(errno));
    page_varied(page, study);
    write_curves(page, request, study);
    if (has_resolution(study)) write_extrapolation(page, request, study);
    page_properties(page, study);
    page_phases(page, study);
    page_fields(page, request, study);
    page_quality(page, study);
    page_provenance(page, study);
    page_decks(page, study);
    page_citation(page, study);
    if (fclose(page) != 0) die_run("a report: %s", strerror(errno));
    return text;
}

void page_write(const struct request *request, const struct study *study, const char *file)
{
    char *body = body_of(request, study);
    struct text_output output = text_output_open(file);
    write_head(output.file, study, body);
    fprintf(output.file, "%s</main>\n</body>\n</html>\n", body);
    text_output_close(&output);
    free(body);
}
