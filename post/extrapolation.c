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
static const double same_spacing = 1e-6; /* relative: 25 um and 0.025 mm */
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

static bool has_spacing(const struct extrapolation *e, double spacing)
{
    for (int k = 0; k < e->count; k++)
        if (fabs(e->spacing[k] / spacing - 1) < same_spacing) return true;
    return false;
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

/* Strains that all have; false: there are none. */
static bool in_common(const struct group means[], int count, double *begin, double *end)
{
    *begin = 0;
    *end = INFINITY;
    for (int k = 0; k < count; k++) {
        if (means[k].n == 0) return false;
        *begin = fmax(*begin, means[k].strain[0]);
        *end = fmin(*end, means[k].strain[means[k].n - 1]);
    }
    return *begin < *end;
}

/* Means of the groups' curves that are paired. */
static bool fill_curve(struct extrapolation *e, const struct group means[], double order)
{
    double begin, end;
    if (!in_common(means, e->count, &begin, &end)) return false;
    const long n = means[0].n;
    struct group *curve = &e->curve;
    *curve = (struct group){.title = e->title, .count = e->count, .n = n};
    double **columns[] = {&curve->strain, &curve->mean, &curve->deviation, &curve->least};
    for (int j = 0; j < 4; j++) *columns[j] = memory_new((size_t)n, sizeof(double));
    for (long i = 0; i < n; i++)
        curve->strain[i] = begin + (end - begin) * (double)i / (double)(n - 1);
    double *values = memory_new((size_t)e->count, sizeof *values);
    for (int k = 0; k < e->count; k++) values[k] = mean_over(&means[k], curve->strain, n);
    e->all = limit_of(e->spacing, values, e->count, order);
    for (long i = 0; i < n; i++) {
        for (int k = 0; k < e->count; k++) values[k] = mean_at(&means[k], curve->strain[i]);
        const struct limit limit = with_order(e->spacing, values, e->all.order, e->all.observed);
        curve->mean[i] = limit.value;
        curve->deviation[i] = limit.band;
        curve->least[i] = values[0];
    }
    free(values);
    return true;
}

/* Titles of the groups at each spacing; the caller frees the list. */
static const char **titles_of(const struct extrapolation *e, const struct group groups[])
{
    const char **titles = memory_new((size_t)e->count, sizeof *titles);
    for (int k = 0; k < e->count; k++) titles[k] = groups[e->groups[k]].title;
    return titles;
}

/* false: no curve is paired, or they have no strain in common. */
static bool make_curve(struct extrapolation *e, const struct group groups[],
                       const struct analysis analyses[], const struct label labels[], int n_labels,
                       double order)
{
    const char **titles = titles_of(e, groups);
    struct pairing pairing = pairing_make(labels, n_labels, NULL, titles, e->count);
    struct group *means = memory_new((size_t)e->count, sizeof *means);
    e->curves = pairing.each[0];
    e->left_out = pairing.left_out;
    for (int k = 0; e->curves > 0 && k < e->count; k++)
        means[k] = group_of(analyses, titles[k], pairing.curves[k], pairing.each[k]);
    const bool made = e->curves > 0 && fill_curve(e, means, order);
    groups_free(means, e->count);
    pairing_free(&pairing);
    free(titles);
    return made;
}

static void free_one(struct extrapolation *e)
{
    free(e->title);
    free(e->groups);
    free(e->spacing);
    group_free(&e->curve);
}

/* Groups from this one on that differ from it in the spacing alone. */
static struct extrapolation gather(const struct group groups[], int n_groups, int g,
                                   const struct label labels[], bool done[])
{
    struct extrapolation e = {0};
    const struct label *label = &labels[groups[g].first];
    for (int k = g; k < n_groups; k++) {
        const struct label *other = &labels[groups[k].first];
        if (done[k] || !resolution_of(other) || !labels_differ_in(label, other, VARIED_RESOLUTION))
            continue;
        done[k] = true;
        if (has_spacing(&e, spacing_of(other)))
            warn("%s: left out of the extrapolation, another has this spacing", other->title);
        else
            insert(&e, k, spacing_of(other));
    }
    e.title = title_without(label);
    return e;
}

struct extrapolation *extrapolations_make(const struct group groups[], int n_groups,
                                          const struct analysis analyses[],
                                          const struct label labels[], int n_labels, double order,
                                          int *count)
{
    struct extrapolation *all = memory_new((size_t)n_groups, sizeof *all);
    bool *done = memory_new((size_t)n_groups, sizeof *done);
    *count = 0;
    for (int g = 0; g < n_groups; g++) {
        if (done[g] || !resolution_of(&labels[groups[g].first])) continue;
        struct extrapolation e = gather(groups, n_groups, g, labels, done);
        const bool several = e.count > 1;
        const bool made = several && make_curve(&e, groups, analyses, labels, n_labels, order);
        if (!several) warn("%s: one spacing alone, nothing to extrapolate", e.title);
        if (several && !made)
            warn("%s: no %s that all spacings have, nothing to extrapolate", e.title,
                 e.curves > 0 ? "strain" : "scatter (seed)");
        if (made && e.left_out > 0)
            warn("%s: %d of %d curves left out of the extrapolation, whose scatter (seed) not all "
                 "spacings have",
                 e.title, e.left_out, e.left_out + e.count * e.curves);
        if (made)
            all[(*count)++] = e;
        else
            free_one(&e);
    }
    free(done);
    return all;
}

void extrapolations_free(struct extrapolation extrapolations[], int count)
{
    for (int k = 0; k < count; k++) free_one(&extrapolations[k]);
    free(extrapolations);
}

/* --- tables ----------------------------------------------------------------------------------- */

/* group, what varied but the spacing and the scatter. */
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
    fputs(",curves,left_out,spacings,engineering_strain,finest_stress_MPa,extrapolated_stress_MPa,"
          "error_MPa,order,"
          "order_from\n",
          file);
    for (int k = 0; k < count; k++) {
        const struct extrapolation *e = &extrapolations[k];
        for (long i = 0; i < e->curve.n; i++) {
            const struct limit limit = {e->curve.mean[i], e->curve.deviation[i], e->all.order,
                                        e->all.observed};
            write_begin(file, e, &labels[groups[e->groups[0]].first], &columns);
            fprintf(file, ",%d,%d,%d,", e->curves, e->left_out, e->count);
            csv_number(file, e->curve.strain[i]);
            write_limit(file, e->curve.least[i], &limit, mega);
        }
    }
    varied_columns_free(&columns);
}

struct extrapolated extrapolation_of(const struct extrapolation *e, const struct group groups[],
                                     const struct properties lists[], const struct label labels[],
                                     int n_labels, const char *name, double order)
{
    struct extrapolated found = {.finest = NAN, .limit = {NAN, NAN, NAN, false}};
    const char **titles = titles_of(e, groups);
    double *values = memory_new((size_t)e->count, sizeof *values);
    double *spacing = memory_new((size_t)e->count, sizeof *spacing);
    for (int g = 0; g < e->count; g++) {
        struct pairing alone = pairing_of(lists, labels, n_labels, name, &titles[g], 1);
        if (alone.each[0] > 0) {
            titles[found.spacings] = titles[g];
            spacing[found.spacings++] = e->spacing[g];
        }
        pairing_free(&alone);
    }
    if (found.spacings > 0 && spacing[0] > e->spacing[0]) found.spacings = 0;
    struct pairing pairing = pairing_of(lists, labels, n_labels, name, titles, found.spacings);
    for (int g = 0; g < found.spacings; g++)
        values[g] = group_statistic(lists, pairing.curves[g], pairing.each[g], name).mean;
    found.curves = found.spacings ? pairing.each[0] : 0;
    found.left_out = pairing.left_out;
    if (found.curves == 0) found.spacings = 0;
    if (found.spacings > 0) {
        found.finest = values[0];
        found.limit = limit_of(spacing, values, found.spacings, order);
    }
    pairing_free(&pairing);
    free(titles);
    free(values);
    free(spacing);
    return found;
}

void extrapolations_write_properties(FILE *file, const struct extrapolation extrapolations[],
                                     int count, const struct group groups[],
                                     const struct properties lists[], const struct label labels[],
                                     int n_labels, double order)
{
    struct varied_columns columns = varied_columns_questions(labels, n_labels);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    fputs(",property,symbol,unit,curves,left_out,spacings,finest,extrapolated,error,order,order_"
          "from\n",
          file);
    for (int k = 0; k < count; k++) {
        const struct extrapolation *e = &extrapolations[k];
        const int first = groups[e->groups[0]].first;
        for (int i = 0; i < lists[first].count; i++) {
            const struct property *property = &lists[first].items[i];
            const struct extrapolated found =
                extrapolation_of(e, groups, lists, labels, n_labels, property->name, order);
            if (found.spacings == 0) continue;
            write_begin(file, e, &labels[first], &columns);
            const char *const texts[] = {property->name, property->symbol, property->unit};
            for (int j = 0; j < 3; j++) {
                fputc(',', file);
                csv_text(file, texts[j]);
            }
            fprintf(file, ",%d,%d,%d", found.curves, found.left_out, found.spacings);
            write_limit(file, found.finest, &found.limit, 1);
        }
    }
    varied_columns_free(&columns);
}
