#include "sensitivity.h"

#include "csv.h"

#include <math.h>
#include <string.h>

struct study_of {
    const struct extrapolation *extrapolations;
    int n_extrapolations;
    const struct group *groups;
    int n_groups;
    const struct properties *lists;
    const struct label *labels;
    int n_labels;
    double order;
};

static const struct label *label_of(const struct study_of *study, int group)
{
    return &study->labels[study->groups[group].first];
}

/* "none", "horizon 1.5"; NULL where no sensitivity is asked. */
static const char *change_of(const struct label *label)
{
    for (int i = 0; i < label->values.count; i++)
        if (label->values.items[i].role == VARIED_SENSITIVITY) return label->values.items[i].value;
    return NULL;
}

static bool is_changed(const struct label *label)
{
    return strcmp(change_of(label), varied_unchanged) != 0;
}

/* Of the body that the group is of, at several spacings; NULL: at one. */
static const struct extrapolation *body_of(const struct study_of *study, int group)
{
    for (int k = 0; k < study->n_extrapolations; k++)
        for (int i = 0; i < study->extrapolations[k].count; i++)
            if (study->extrapolations[k].groups[i] == group) return &study->extrapolations[k];
    return NULL;
}

/* NAN: at one spacing. */
static double error_of(const struct study_of *study, const struct extrapolation *body,
                       const char *name)
{
    if (!body) return NAN;
    return extrapolation_of(body, study->groups, study->lists, study->labels, study->n_labels, name,
                            study->order)
        .limit.band;
}

/* Empty where it is not known. */
static void write_number(FILE *file, double number)
{
    fputc(',', file);
    if (isfinite(number)) csv_number(file, number);
}

static void write_row(FILE *file, const struct study_of *study,
                      const struct varied_columns *columns, int base, int group,
                      const struct property *property)
{
    const char *const name = property->name;
    const bool same = group == base;
    const char *const titles[] = {study->groups[base].title, study->groups[group].title};
    struct pairing pairing =
        pairing_of(study->lists, study->labels, study->n_labels, name, titles, 2);
    const struct statistic before = group_statistic(study->lists, pairing.curves[0],
                                                    pairing.each[0], name),
                           value = group_statistic(study->lists, pairing.curves[1], pairing.each[1],
                                                   name),
                           change = pairing_change(&pairing, study->lists, study->labels, name, 1);
    const double numbers[] = {value.mean,
                              same ? NAN : change.mean,
                              same ? NAN : 100 * (value.mean / before.mean - 1),
                              same ? error_of(study, body_of(study, base), name) : NAN,
                              value.deviation,
                              same ? NAN : change.deviation};
    const char *const texts[] = {name, property->symbol, property->unit,
                                 change_of(label_of(study, group))};
    csv_text(file, study->groups[base].title);
    varied_columns_values(file, columns, label_of(study, base), VARIED_QUESTION);
    for (int i = 0; i < 4; i++) {
        fputc(',', file);
        csv_text(file, texts[i]);
    }
    for (int i = 0; i < 6; i++) write_number(file, numbers[i]);
    fprintf(file, ",%d,%d\n", value.count, same ? 0 : pairing.left_out);
    pairing_free(&pairing);
}

static bool has_value(const struct study_of *study, int group, const char *name)
{
    const char *const title = study->groups[group].title;
    struct pairing own = pairing_of(study->lists, study->labels, study->n_labels, name, &title, 1);
    const bool has = own.each[0] > 0;
    pairing_free(&own);
    return has;
}

/* All properties of the body as it is, each with what the changes make of it. */
static void write_body(FILE *file, const struct study_of *study,
                       const struct varied_columns *columns, int base)
{
    const struct properties *list = &study->lists[study->groups[base].first];
    for (int i = 0; i < list->count; i++) {
        const struct property *property = &list->items[i];
        if (!has_value(study, base, property->name)) continue;
        write_row(file, study, columns, base, base, property);
        for (int g = 0; g < study->n_groups; g++)
            if (g != base &&
                labels_differ_in(label_of(study, base), label_of(study, g), VARIED_SENSITIVITY))
                write_row(file, study, columns, base, g, property);
    }
}

void sensitivities_write(FILE *file, const struct extrapolation extrapolations[], int count,
                         const struct group groups[], int n_groups, const struct properties lists[],
                         const struct label labels[], int n_labels, double order)
{
    const struct study_of study = {extrapolations, count,  groups,   n_groups,
                                   lists,          labels, n_labels, order};
    struct varied_columns columns = varied_columns_questions(labels, n_labels);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    fputs(",property,symbol,unit,changed,value,change,change_percent,error_of_spacing,"
          "standard_deviation,deviation_of_change,curves,left_out\n",
          file);
    for (int g = 0; g < n_groups; g++) {
        const struct extrapolation *body = body_of(&study, g);
        if (!change_of(label_of(&study, g)) || is_changed(label_of(&study, g))) continue;
        if (body && body->groups[0] != g) continue;
        write_body(file, &study, &columns, g);
    }
    varied_columns_free(&columns);
}
