#include "extrapolation.h"

#include "csv.h"
#include "die.h"
#include "memory.h"
#include "root.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double mega = 1e6;
static const double least_order = 0.5, largest_order = 3;
/* Roache's factors of safety, of an order that was observed and of one that is assumed. */
static const double safety_observed = 1.25, safety_assumed = 3;

/* --- Richardson ------------------------------------------------------------------------------- */

/* Of the three finest. */
struct triple {
    const double *spacing;
    double fine, coarse; /* f2 - f1, f3 - f2 */
};

static double misfit(double order, void *context)
{
    const struct triple *t = context;
    const double *h = t->spacing;
    return t->coarse * (pow(h[1] / h[0], order) - 1) -
           t->fine * (pow(h[2] / h[0], order) - pow(h[1] / h[0], order));
}

/* NAN where the values do not tell it. */
static double observed_order(const double spacing[], const double values[], int count)
{
    if (count < 3) return NAN;
    struct triple triple = {spacing, values[1] - values[0], values[2] - values[1]};
    if (!(triple.fine * triple.coarse > 0)) return NAN;
    return root_between(misfit, &triple, least_order, largest_order);
}

static struct limit with_order(const double spacing[], const double values[], double order,
                               bool observed)
{
    const double step = (values[1] - values[0]) / (pow(spacing[1] / spacing[0], order) - 1);
    const double factor = observed ? safety_observed : safety_assumed;
    return (struct limit){values[0] - step, factor * fabs(step), order, observed};
}

struct limit limit_of(const double spacing[], const double values[], int count, double order)
{
    if (count < 2) return (struct limit){NAN, NAN, NAN, false};
    const double observed = observed_order(spacing, values, count);
    const bool is_observed = !isnan(observed);
    return with_order(spacing, values, is_observed ? observed : order, is_observed);
}

/* --- groups that differ in the spacing alone
 * --------------------------------------------------- */

static const struct varied_item *resolution_of(const struct label *label)
{
    for (int i = 0; i < label->values.count; i++)
        if (label->values.items[i].role == VARIED_RESOLUTION) return &label->values.items[i];
    return NULL;
}

/* "25 um", or the first of "[25 um, 50 um, 50 um]". */
static double spacing_of(const struct label *label)
{
    static const char *const units[] = {"m", "1", "s", "Pa", "N", "m/s", "1/s"};
    const char *text = resolution_of(label)->value;
    const char *from = text + strspn(text, "[ ");
    char *first = memory_print("%.*s", (int)strcspn(from, ",]"), from);
    double value = NAN;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (!units_read(first, units[i], &value)) break;
    free(first);
    if (!(value > 0))
        die_user("%s: the resolution '%s' is no positive number, and nothing to extrapolate with",
                 label->file, text);
    return value;
}

/* Without ", spacing 25 um". */
static char *title_without(const struct label *label)
{
    const struct varied_item *item = resolution_of(label);
    char *words = memory_print(", %s %s", item->name, item->value);
    const char *found = strstr(label->title, words);
    char *title = found ? memory_print("%.*s%s", (int)(found - label->title), label->title,
                                       found + strlen(words))
                        : memory_text(label->title);
    free(words);
    return title;
}

/* Puts a group in its place, the finest first. */
static void insert(struct extrapolation *to, int group, double spacing)
{
    to->groups = memory_grow(to->groups, to->count, sizeof *to->groups);
    to->spacing = memory_grow(to->spacing, to->count, sizeof *to->spacing);
    int i = to->count++;
    for (; i > 0 && to->spacing[i - 1] > spacing; i--) {
        to->groups[i] = to->groups[i - 1];
        to->spacing[i] = to->spacing[i - 1];
    }
    to->groups[i] = group;
    to->spacing[i] = spacing;
}

/* --- curves ----------------------------------------------------------------------------------- */

static double mean_at(const struct group *group, double strain)
{
    const double first = group->strain[0], last = group->strain[group->n - 1];
    const double place = (strain - first) / (last - first) * (double)(group->n - 1);
    const long i = place <= 0 ? 0 : place >= (double)(group->n - 1) ? group->n - 2 : (long)place;
    const double share = place - (double)i;
    return group->mean[i] + share * (group->mean[i + 1] - group->mean[i]);
}

/* Area under a group's mean between two strains, per strain. */
static double mean_over(const struct group *group, const double strain[], long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++) {
        const double mean = mean_at(group, strain[i]);
        if (!isnan(mean)) sum += mean / (double)n;
    }
    return sum;
}

static void make_curve(struct extrapolation *e, const struct group groups[], double order)
{
    const long n = groups[e->groups[0]].n;
    struct group *curve = &e->curve;
    *curve = (struct group){.title = e->title, .count = e->count, .n = n};
    double **columns[] = {&curve->strain, &curve->mean, &curve->deviation, &curve->least};
    for (int j = 0; j < 4; j++) *columns[j] = memory_new((size_t)n, sizeof(double));
    double begin = 0, end = INFINITY;
    for (int k = 0; k < e->count; k++) {
        begin = fmax(begin, groups[e->groups[k]].strain[0]);
        end = fmin(end, groups[e->groups[k]].strain[n - 1]);
    }
    for (long i = 0; i < n; i++)
        curve->strain[i] = begin + (end - begin) * (double)i / (double)(n - 1);
    double *values = memory_new((size_t)e->count, sizeof *values);
    for (int k = 0; k < e->count; k++)
        values[k] = mean_over(&groups[e->groups[k]], curve->strain, n);
    e->all = limit_of(e->spacing, values, e->count, order);
    for (long i = 0; i < n; i++) {
        for (int k = 0; k < e->count; k++)
            values[k] = mean_at(&groups[e->groups[k]], curve->strain[i]);
        const struct limit limit = with_order(e->spacing, values, e->all.order, e->all.observed);
        curve->mean[i] = limit.value;
        curve->deviation[i] = limit.band;
        curve->least[i] = values[0];
    }
    free(values);
}

struct extrapolation *extrapolations_make(const struct group groups[], int n_groups,
                                          const struct label labels[], double order, int *count)
{
    struct extrapolation *all = memory_new((size_t)n_groups, sizeof *all);
    bool *done = memory_new((size_t)n_groups, sizeof *done);
    *count = 0;
    for (int g = 0; g < n_groups; g++) {
        const struct label *label = &labels[groups[g].first];
        if (done[g] || !resolution_of(label)) continue;
        struct extrapolation *e = &all[*count];
        for (int k = g; k < n_groups; k++) {
            const struct label *other = &labels[groups[k].first];
            if (done[k] || !resolution_of(other) ||
                !labels_differ_in(label, other, VARIED_RESOLUTION))
                continue;
            done[k] = true;
            insert(e, k, spacing_of(other));
        }
        e->title = title_without(label);
        if (e->count > 1)
            make_curve(&all[(*count)++], groups, order);
        else
            warn("%s: one spacing alone, nothing to extrapolate", e->title);
    }
    free(done);
    return all;
}

void extrapolations_free(struct extrapolation extrapolations[], int count)
{
    for (int k = 0; k < count; k++) {
        free(extrapolations[k].title);
        free(extrapolations[k].groups);
        free(extrapolations[k].spacing);
        free(extrapolations[k].curve.strain);
        free(extrapolations[k].curve.mean);
        free(extrapolations[k].curve.deviation);
        free(extrapolations[k].curve.least);
    }
    free(extrapolations);
}

/* --- tables ----------------------------------------------------------------------------------- */

/* group, what varied but the spacing and the scatter, number of spacings. */
static void write_begin(FILE *file, const struct extrapolation *e, const struct label *label,
                        const struct varied_columns *columns)
{
    csv_text(file, e->title);
    varied_columns_values(file, columns, label, VARIED_QUESTION);
}

static const char *source_of(const struct limit *limit)
{
    return limit->observed ? "observed" : "assumed";
}

static void write_limit(FILE *file, double finest, const struct limit *limit, double scale)
{
    const double numbers[] = {finest / scale, limit->value / scale, limit->band / scale,
                              limit->order};
    for (int i = 0; i < 4; i++) {
        fputc(',', file);
        csv_number(file, numbers[i]);
    }
    fprintf(file, ",%s\n", isnan(limit->order) ? "" : source_of(limit));
}

void extrapolations_write(FILE *file, const struct extrapolation extrapolations[], int count,
                          const struct group groups[], const struct label labels[], int n_labels)
{
    struct varied_columns columns = varied_columns_questions(labels, n_labels);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    fputs(",spacings,engineering_strain,finest_stress_MPa,extrapolated_stress_MPa,error_MPa,order,"
          "order_from\n",
          file);
    for (int k = 0; k < count; k++) {
        const struct extrapolation *e = &extrapolations[k];
        for (long i = 0; i < e->curve.n; i++) {
            const struct limit limit = {e->curve.mean[i], e->curve.deviation[i], e->all.order,
                                        e->all.observed};
            write_begin(file, e, &labels[groups[e->groups[0]].first], &columns);
            fprintf(file, ",%d,", e->count);
            csv_number(file, e->curve.strain[i]);
            write_limit(file, e->curve.least[i], &limit, mega);
        }
    }
    varied_columns_free(&columns);
}

int extrapolation_of(const struct extrapolation *e, const struct group groups[],
                     const struct properties lists[], const struct label labels[], int n_labels,
                     const char *name, double order, double *finest, struct limit *limit)
{
    double *values = memory_new((size_t)e->count, sizeof *values);
    double *spacing = memory_new((size_t)e->count, sizeof *spacing);
    int there = 0;
    for (int g = 0; g < e->count; g++) {
        const double value = group_mean(lists, labels, n_labels, groups[e->groups[g]].title, name);
        if (isnan(value)) continue;
        values[there] = value;
        spacing[there++] = e->spacing[g];
    }
    if (there > 0 && spacing[0] > e->spacing[0]) there = 0;
    if (there > 0) {
        *finest = values[0];
        *limit = limit_of(spacing, values, there, order);
    }
    free(values);
    free(spacing);
    return there;
}

void extrapolations_write_properties(FILE *file, const struct extrapolation extrapolations[],
                                     int count, const struct group groups[],
                                     const struct properties lists[], const struct label labels[],
                                     int n_labels, double order)
{
    struct varied_columns columns = varied_columns_questions(labels, n_labels);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    fputs(",property,symbol,unit,spacings,finest,extrapolated,error,order,order_from\n", file);
    for (int k = 0; k < count; k++) {
        const struct extrapolation *e = &extrapolations[k];
        const int first = groups[e->groups[0]].first;
        for (int i = 0; i < lists[first].count; i++) {
            const struct property *property = &lists[first].items[i];
            double finest;
            struct limit limit;
            const int there = extrapolation_of(e, groups, lists, labels, n_labels, property->name,
                                               order, &finest, &limit);
            if (there == 0) continue;
            write_begin(file, e, &labels[first], &columns);
            const char *const texts[] = {property->name, property->symbol, property->unit};
            for (int j = 0; j < 3; j++) {
                fputc(',', file);
                csv_text(file, texts[j]);
            }
            fprintf(file, ",%d", there);
            write_limit(file, finest, &limit, 1);
        }
    }
    varied_columns_free(&columns);
}
