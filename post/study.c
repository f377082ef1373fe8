#include "study.h"

#include "deck.h"
#include "die.h"
#include "keys_options.h"
#include "memory.h"
#include "sections.h"

#include <stdlib.h>
#include <string.h>

/* The deck whose section post counts; NULL: there is none. */
static struct deck *find_deck(const struct request *request, const struct input *input)
{
    const char *within = attributes_text(&input->attributes, "deck");
    const char *name = attributes_text(&input->attributes, "deck_name");
    if (request->deck) return deck_read(request->deck);
    if (!within) return NULL;
    return deck_parse(within, strlen(within), name ? name : "the deck within the history");
}

struct choices study_choose(const struct request *request, const struct deck *deck)
{
    struct choices choices = choices_read(deck);
    keys_read_options(&post_section.keys, request->choices, &choices);
    return choices;
}

struct study study_read(const struct request *request, const char *maker)
{
    size_t n = (size_t)request->n_files;
    /* The table on standard error has neither errors nor laws. */
    const bool in_full = request->properties || request->json || request->statistics ||
                         request->tidy || request->extrapolate_properties ||
                         request->sensitivities || request->report || request->crate;
    struct study study = {.count = request->n_files, .maker = maker};
    study.curves = memory_new(n, sizeof *study.curves);
    study.choices = memory_new(n, sizeof *study.choices);
    study.analyses = memory_new(n, sizeof *study.analyses);
    study.properties = memory_new(n, sizeof *study.properties);
    study.loops = memory_new(n, sizeof *study.loops);
    const char **titles = memory_new(n, sizeof *titles);
    study.kept = memory_new(n, sizeof *study.kept);
    study.decks = memory_new(n, sizeof *study.decks);
    study.builds = memory_new(n, sizeof *study.builds);
    struct varied *varied = memory_new(n, sizeof *varied);
    for (size_t i = 0; i < n; i++) {
        struct input input = input_read(request->files[i], request->columns_of);
        struct deck *deck = find_deck(request, &input);
        study.choices[i] = study_choose(request, deck);
        if (!study.question) study.question = memory_text(study.choices[i].question);
        if (!study.license) study.license = memory_text(study.choices[i].license);
        study.curves[i] = curve_make(&input, &study.choices[i]);
        study.decks[i] = memory_text(attributes_text(&input.attributes, "deck"));
        study.builds[i] = memory_text(attributes_text(&input.attributes, "solver_program"));
        if (deck) varied[i] = varied_read(sections_read(deck).varied);
        deck_free(deck);
        if (request->crate) {
            study.kept[i] = (struct kept){input.content, input.bytes, input.is_history};
            input.content = NULL;
        }
        input_free(&input);
        study.analyses[i] = analysis_make(&study.curves[i], &study.choices[i], in_full);
        if (!request->accept) analysis_check_plausible(&study.curves[i], &study.analyses[i]);
        study.properties[i] =
            analysis_report(&study.curves[i], &study.analyses[i], &study.choices[i], in_full);
        titles[i] = study.curves[i].title;
        study.loops[i].loops = loops_find(&study.curves[i], &study.analyses[i],
                                          study.choices[i].loop_offset, &study.loops[i].count);
    }
    study.labels =
        labels_make(titles, request->files, (const char *const *)study.decks, varied, study.count);
    for (size_t i = 0; i < n; i++) study.loops[i].title = study.labels[i].curve;
    free(varied);
    free(titles);
    return study;
}

void study_free(struct study *study)
{
    for (int i = 0; i < study->count; i++) {
        curve_free(&study->curves[i]);
        properties_free(&study->properties[i]);
        analysis_free(&study->analyses[i]);
        free((void *)study->loops[i].loops);
        free(study->decks[i]);
        free(study->kept[i].bytes);
        free(study->builds[i]);
    }
    free(study->curves);
    free(study->choices);
    free(study->analyses);
    free(study->properties);
    labels_free(study->labels, study->count);
    free(study->loops);
    free(study->decks);
    free(study->question);
    free(study->license);
    free(study->kept);
    free(study->builds);
}
