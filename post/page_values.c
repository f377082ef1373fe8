#include "page_values.h"

#include "figure.h"
#include "html.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a run or a record is judged by. */
static const char *const quality[] = {"force_imbalance",
                                      "kinetic_to_internal",
                                      "unsteady_to_internal",
                                      "residual",
                                      "energy_drift",
                                      "modulus_deviation",
                                      "noise",
                                      "strain_noise",
                                      "loops",
                                      "holds",
                                      "serrations",
                                      "spikes",
                                      NULL};

enum { MOST_FULL_LISTS = 20 };

static const struct property *find(const struct properties *list, const char *name)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->items[i].name, name) == 0) return &list->items[i];
    return NULL;
}

static bool is_quality(const char *name)
{
    for (int i = 0; quality[i]; i++)
        if (strcmp(quality[i], name) == 0) return true;
    return false;
}

static bool says_something(const struct property *property)
{
    return property && (!isnan(property->value) || property->flag);
}

int page_groups(const struct study *study)
{
    int *numbers = memory_new((size_t)study->count, sizeof *numbers), groups = 0;
    for (int k = 0; k < study->count; k++) {
        group_members(study->labels, study->count, study->labels[k].title, numbers);
        groups += numbers[0] == k;
    }
    free(numbers);
    return groups;
}

/* What tells a curve from the others: the page's title says what they share. */
static void write_label(FILE *page, const struct study *study, const char *label)
{
    html_text(page, label + labels_shared(study->labels, study->count));
}

static void write_flag(FILE *page, const char *flag)
{
    if (!flag) return;
    fputs("<span class=\"flag\">", page);
    html_words(page, flag);
    fputs("</span>", page);
}

static void write_name(FILE *page, const struct property *property)
{
    if (*property->symbol)
        html_text(page, property->symbol);
    else
        html_words(page, property->name);
    fputs("<small>", page);
    if (*property->symbol) {
        html_words(page, property->name);
        fputs(": ", page);
    }
    html_text(page, property->definition);
    fputs("</small>", page);
}

static void write_value(FILE *page, const struct property *property)
{
    fputs("<td class=\"value\">", page);
    html_quantity(page, property->value, property->uncertainty, property->unit);
    write_flag(page, property->flag);
    fputs("</td></tr>\n", page);
}

static void write_row(FILE *page, const struct property *property)
{
    fputs("<tr class=\"property\"><th scope=\"row\">", page);
    write_name(page, property);
    fputs("</th>", page);
    write_value(page, property);
}

/* --- many curves ------------------------------------------------------------------------------ */

static void write_heading(FILE *page, const struct property *property)
{
    fputs("<tr class=\"property\"><th scope=\"rowgroup\" colspan=\"2\">", page);
    write_name(page, property);
    fputs("</th></tr>\n", page);
}

static void write_curve(FILE *page, const struct study *study, int k, const char *name)
{
    const struct property *property = find(&study->properties[k], name);
    if (!says_something(property)) return;
    fputs("<tr class=\"curve\"><th scope=\"row\">", page);
    write_label(page, study, study->labels[k].curve);
    fputs("</th>", page);
    write_value(page, property);
}

/* The first flag among some curves, and how many have one. */
static void write_flags(FILE *page, const struct study *study, const int numbers[], int n,
                        const char *name)
{
    const char *first = NULL;
    int count = 0;
    for (int k = 0; k < n; k++) {
        const struct property *property = find(&study->properties[numbers[k]], name);
        if (!property || !property->flag) continue;
        if (count++ == 0) first = property->flag;
    }
    if (count == 0) return;
    char *words = memory_print("%s: %d of %d", first, count, n);
    write_flag(page, words);
    free(words);
}

static void write_group(FILE *page, const struct study *study, const int numbers[], int n,
                        const struct property *property)
{
    const struct statistic s = group_statistic(study->properties, numbers, n, property->name);
    fputs("<tr class=\"curve\"><th scope=\"row\">", page);
    write_label(page, study, study->labels[numbers[0]].title);
    fprintf(page, "<small>%d of %d</small></th><td class=\"value\">", s.count, n);
    html_quantity(page, s.mean, s.deviation, property->unit);
    if (s.count > 1) {
        fputs("<small>", page);
        html_number(page, s.least, s.deviation);
        fputs(" to ", page);
        html_number(page, s.largest, s.deviation);
        fputs("</small>", page);
    }
    write_flags(page, study, numbers, n, property->name);
    fputs("</td></tr>\n", page);
}

static void write_groups(FILE *page, const struct study *study, const struct property *property)
{
    int *numbers = memory_new((size_t)study->count, sizeof *numbers);
    for (int k = 0; k < study->count; k++) {
        const int n = group_members(study->labels, study->count, study->labels[k].title, numbers);
        if (numbers[0] == k && n == 1)
            write_curve(page, study, k, property->name);
        else if (numbers[0] == k)
            write_group(page, study, numbers, n, property);
    }
    free(numbers);
}

/* The first curve's that has a value; NULL where none has. */
static const struct property *find_value(const struct study *study, const char *name)
{
    for (int k = 0; k < study->count; k++) {
        const struct property *property = find(&study->properties[k], name);
        if (property && !isnan(property->value)) return property;
    }
    return NULL;
}

/* A property of all curves. */
static void write_property(FILE *page, const struct study *study, const char *name)
{
    const struct property *first = find_value(study, name);
    if (!first) return;
    if (study->count == 1) {
        write_row(page, first);
        return;
    }
    fputs("<tbody>\n", page);
    write_heading(page, first);
    if (page_groups(study) < study->count)
        write_groups(page, study, first);
    else
        for (int k = 0; k < study->count; k++) write_curve(page, study, k, name);
    fputs("</tbody>\n", page);
}

/* Which properties no curve has, and why. */
static void write_missing(FILE *page, const struct study *study, const char *const names[])
{
    int count = 0;
    for (int i = 0; names[i]; i++) {
        const struct property *first = find(&study->properties[0], names[i]);
        if (!first || !first->flag || find_value(study, names[i])) continue;
        fputs(count++ ? ", " : "<p class=\"quiet\">Without a value: ", page);
        html_text(page, *first->symbol ? first->symbol : first->name);
        fputs(" (", page);
        html_words(page, first->flag);
        fputs(")", page);
    }
    if (count) fputs(".</p>\n", page);
}

static void write_properties(FILE *page, const struct study *study, const char *const names[])
{
    html_table(page);
    if (study->count == 1) fputs("<tbody>\n", page);
    for (int i = 0; names[i]; i++) write_property(page, study, names[i]);
    if (study->count == 1) fputs("</tbody>\n", page);
    fputs("</table>\n", page);
    write_missing(page, study, names);
}

/* --- sections --------------------------------------------------------------------------------- */

void page_cards(FILE *page, const struct properties *list)
{
    static const char *const names[] = {"modulus", "proof_strength_0.2", "tensile_strength",
                                        "extension_at_maximum_force"};
    fputs("<dl class=\"cards\">\n", page);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const struct property *property = find(list, names[i]);
        if (!property || isnan(property->value)) continue;
        fputs("<div><dt>", page);
        html_text(page, property->symbol);
        fputs("</dt><dd>", page);
        html_quantity(page, property->value, property->uncertainty, property->unit);
        write_flag(page, property->flag);
        fputs("</dd></div>\n", page);
    }
    fputs("</dl>\n", page);
}

/* All that is known of each curve, which opens when it is asked for. */
static void write_lists(FILE *page, const struct study *study)
{
    if (study->count > MOST_FULL_LISTS) {
        fputs("<p class=\"quiet\">The full lists of so many curves are in the CSV of "
              "<code>hspost --properties</code>.</p>\n",
              page);
        return;
    }
    for (int k = 0; k < study->count; k++) {
        fputs("<details><summary>All properties of ", page);
        html_text(page, study->labels[k].curve);
        fputs("</summary>\n", page);
        html_table(page);
        fputs("<tbody>\n", page);
        for (int i = 0; i < study->properties[k].count; i++)
            if (says_something(&study->properties[k].items[i]))
                write_row(page, &study->properties[k].items[i]);
        fputs("</tbody></table></details>\n", page);
    }
}

void page_properties(FILE *page, const struct study *study)
{
    html_section(page, "properties", "Properties");
    fputs("<p class=\"quiet\">Behind ± stands a standard error; a word below a value limits it.",
          page);
    if (page_groups(study) < study->count)
        fputs(" Values are means over the curves of one title, ± their standard deviation, and "
              "from the least to the largest.",
              page);
    fputs("</p>\n", page);
    const char **names = NULL, *name;
    int count = 0;
    for (int i = 0; (name = properties_main(i)); i++) {
        if (is_quality(name)) continue;
        names = memory_grow(names, count, sizeof *names);
        names[count++] = name;
    }
    names = memory_grow(names, count, sizeof *names);
    names[count] = NULL;
    write_properties(page, study, names);
    free(names);
    write_lists(page, study);
    html_end(page);
}

static void write_limit(FILE *page, const struct extrapolation *e, const struct property *property,
                        const struct extrapolated *found)
{
    fputs("<tr class=\"curve\"><th scope=\"row\">", page);
    html_text(page, e->title);
    fprintf(page, "<small>%d spacings, order ", found->spacings);
    html_number(page, found->limit.order, 0);
    fprintf(page, " %s, finest ", found->limit.observed ? "observed" : "assumed");
    html_number(page, found->finest, found->limit.band);
    if (found->left_out > 0) fprintf(page, ", %d curves left out", found->left_out);
    fputs("</small></th><td class=\"value\">", page);
    html_quantity(page, found->limit.value, found->limit.band, property->unit);
    fputs("</td></tr>\n", page);
}

/* Of all bodies, under one heading; nothing where none has a limit. */
static void write_limits(FILE *page, const struct study *study, const struct study_figure *figure,
                         const struct property *property)
{
    bool any = false;
    for (int k = 0; k < figure->n_limits; k++) {
        const struct extrapolated found =
            extrapolation_of(&figure->limits[k], figure->groups, study->properties, study->labels,
                             study->count, property->name, study->choices[0].resolution_order);
        if (isnan(found.limit.value)) continue;
        if (!any) {
            fputs("<tbody>\n", page);
            write_heading(page, property);
        }
        any = true;
        write_limit(page, &figure->limits[k], property, &found);
    }
    if (any) fputs("</tbody>\n", page);
}

void page_resolution(FILE *page, const struct study *study, const struct study_figure *figure)
{
    fputs("<p class=\"quiet\">Values extrapolated to the spacing 0, ± the error of the finest "
          "spacing: an estimate, no bound.</p>\n",
          page);
    html_table(page);
    for (int i = 0; properties_main(i); i++) {
        const struct property *property = find(&study->properties[0], properties_main(i));
        if (property && !is_quality(property->name)) write_limits(page, study, figure, property);
    }
    fputs("</table>\n", page);
}

/* Up to the fracture: mean nominal axial stress of a phase against the strain of the gauge. */
static struct curve curve_of(const struct study *study, int k, const struct curve_phase *phase)
{
    const struct analysis *analysis = &study->analyses[k];
    const struct curve *from = &study->curves[k];
    char *title = study->count == 1 ? memory_text(phase->name)
                                    : memory_print("%s, %s", study->labels[k].title, phase->name);
    struct curve curve = curve_new(analysis->rows[analysis->measures.fracture] + 1, title);
    for (long i = 0; i < curve.n; i++) {
        curve.strain[i] = from->strain[i];
        curve.stress[i] = phase->stress[i];
    }
    free(title);
    return curve;
}

static bool is_first(const struct study *study, int k)
{
    for (int i = 0; i < k; i++)
        if (strcmp(study->labels[i].title, study->labels[k].title) == 0) return false;
    return true;
}

static void draw_phases(FILE *page, const struct study *study)
{
    static const struct figure_style style = {.x_range = {NAN, NAN}, .y_range = {NAN, NAN}};
    struct figure_series series[FIGURE_MOST_LINES];
    struct curve curves[FIGURE_MOST_LINES];
    int count = 0, wanted = 0;
    for (int k = 0; k < study->count; k++)
        wanted += is_first(study, k) ? study->curves[k].n_phases : 0;
    for (int k = 0; k < study->count && wanted <= FIGURE_MOST_LINES; k++)
        for (int i = 0; i < study->curves[k].n_phases; i++) {
            if (!is_first(study, k) || !study->curves[k].phases[i].stress) continue;
            curves[count] = curve_of(study, k, &study->curves[k].phases[i]);
            series[count] =
                (struct figure_series){.title = curves[count].title, .curve = &curves[count]};
            count++;
        }
    if (count == 0) return;
    fputs("<figure>\n", page);
    figure_inline(page, "partition", series, count, &style);
    fprintf(
        page,
        "<figcaption id=\"partition-words\">Mean nominal axial stress in each phase of the gauge "
        "against the engineering strain of the whole%s.</figcaption>\n</figure>\n",
        page_groups(study) < study->count ? ", of the first curve of each title" : "");
    for (int i = 0; i < count; i++) curve_free(&curves[i]);
}

void page_phases(FILE *page, const struct study *study)
{
    static const char *const quantities[] = {"fraction", "stress", "strain"};
    const struct curve *curve = &study->curves[0];
    char *names[3 * CURVE_PHASES + 3] = {0};
    int count = 0;
    for (int k = 0; k < study->count && curve->n_phases < 2; k++) curve = &study->curves[k];
    if (curve->n_phases < 2) return;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < curve->n_phases; k++)
            names[count++] = memory_print("%s_%s", curve->phases[k].name, quantities[i]);
    names[count++] = memory_text("partition_factor");
    names[count++] = memory_text("mixture_share");
    html_section(page, "phases", "Phases");
    draw_phases(page, study);
    write_properties(page, study, (const char *const *)names);
    html_end(page);
    for (int i = 0; i < count; i++) free(names[i]);
}

void page_quality(FILE *page, const struct study *study)
{
    html_section(page, "quality", "Energy and quality");
    write_properties(page, study, quality);
    html_end(page);
}
