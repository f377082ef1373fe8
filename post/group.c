#include "group.h"

#include "csv.h"
#include "die.h"
#include "memory.h"
#include "varied_columns.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 401 };

static const double mega = 1e6;

static double deviation_of(const double values[], int count)
{
    return count > 1 ? gsl_stats_sd(values, 1, (size_t)count) : 0;
}

static double toe_of(const struct analysis *analysis)
{
    return isnan(analysis->measures.line.toe) ? 0 : analysis->measures.line.toe;
}

/* Strain of the first row, without the toe. */
static double begin_of(const struct analysis *analysis)
{
    return fmax(analysis->envelope.strain[0] - toe_of(analysis), 0);
}

/* Strain of the last row, without the toe, whose strain was measured. */
static double end_of(const struct analysis *analysis)
{
    return analysis->envelope.strain[analysis->measures.fracture] - toe_of(analysis);
}

static double stress_at(const struct analysis *analysis, double strain)
{
    const struct curve *curve = &analysis->envelope;
    double first, last;
    gsl_stats_minmax(&first, &last, curve->strain, 1, (size_t)analysis->measures.fracture + 1);
    /* An end of the curve, less the toe and plus the toe, is rounded to either side of it. */
    const double wanted = fmin(fmax(strain + toe_of(analysis), first), last);
    for (long i = 1; i <= analysis->measures.fracture; i++) {
        const double *e = curve->strain + i, *s = curve->stress + i;
        if (e[-1] <= wanted && wanted <= e[0] && e[0] > e[-1])
            return s[-1] + (wanted - e[-1]) / (e[0] - e[-1]) * (s[0] - s[-1]);
    }
    return NAN;
}

int group_members(const struct label labels[], int count, const char *title, int numbers[])
{
    int n = 0;
    for (int i = 0; i < count; i++)
        if (strcmp(labels[i].title, title) == 0) numbers[n++] = i;
    return n;
}

struct group group_of(const struct analysis analyses[], const char *title, const int numbers[],
                      int count)
{
    struct group group = {.title = title, .first = numbers[0], .count = count, .n = POINTS};
    double **columns[] = {&group.strain, &group.mean, &group.deviation, &group.least,
                          &group.largest};
    for (int j = 0; j < 5; j++) *columns[j] = memory_new(POINTS, sizeof(double));
    double *stresses = memory_new((size_t)count, sizeof *stresses), begin = 0, end = INFINITY;
    for (int k = 0; k < count; k++) {
        begin = fmax(begin, begin_of(&analyses[numbers[k]]));
        end = fmin(end, end_of(&analyses[numbers[k]]));
    }
    if (!(begin < end)) group.n = 0;
    for (long i = 0; i < group.n; i++) {
        int there = 0;
        group.strain[i] = begin + (end - begin) * (double)i / (POINTS - 1);
        for (int k = 0; k < count; k++) {
            const double stress = stress_at(&analyses[numbers[k]], group.strain[i]);
            if (!isnan(stress)) stresses[there++] = stress;
        }
        const bool whole = there == count;
        group.mean[i] = whole ? gsl_stats_mean(stresses, 1, (size_t)there) : NAN;
        group.deviation[i] = whole ? deviation_of(stresses, there) : NAN;
        group.least[i] = whole ? gsl_stats_min(stresses, 1, (size_t)there) : NAN;
        group.largest[i] = whole ? gsl_stats_max(stresses, 1, (size_t)there) : NAN;
    }
    free(stresses);
    return group;
}

struct group *groups_make(const struct analysis analyses[], const struct label labels[], int count,
                          int *n_groups)
{
    struct group *groups = memory_new((size_t)count, sizeof *groups);
    int *numbers = memory_new((size_t)count, sizeof *numbers);
    *n_groups = 0;
    for (int i = 0; i < count; i++) {
        const int n = group_members(labels, count, labels[i].title, numbers);
        if (numbers[0] != i) continue;
        struct group *group = &groups[(*n_groups)++];
        *group = group_of(analyses, labels[i].title, numbers, n);
        if (group->n == 0) warn("%s: no strain that all its %d curves have", group->title, n);
    }
    free(numbers);
    return groups;
}

void group_free(struct group *group)
{
    free(group->strain);
    free(group->mean);
    free(group->deviation);
    free(group->least);
    free(group->largest);
    *group = (struct group){0};
}

void groups_free(struct group groups[], int n_groups)
{
    for (int k = 0; k < n_groups; k++) group_free(&groups[k]);
    free(groups);
}

/* Numbers, each behind a comma. */
static void write_numbers(FILE *file, const double values[], int count)
{
    for (int i = 0; i < count; i++) {
        fputc(',', file);
        csv_number(file, values[i]);
    }
    fputc('\n', file);
}

void groups_write(FILE *file, const struct group groups[], int n_groups,
                  const struct label labels[], int count)
{
    struct varied_columns columns = varied_columns_of(labels, count);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_SCATTER);
    fputs(",curves,engineering_strain,mean_stress_MPa,standard_deviation_MPa,least_MPa,"
          "largest_MPa\n",
          file);
    for (int k = 0; k < n_groups; k++)
        for (long i = 0; i < groups[k].n; i++) {
            const struct group *g = &groups[k];
            const double values[] = {g->strain[i], g->mean[i] / mega, g->deviation[i] / mega,
                                     g->least[i] / mega, g->largest[i] / mega};
            csv_text(file, g->title);
            varied_columns_values(file, &columns, &labels[g->first], VARIED_SCATTER);
            fprintf(file, ",%d", g->count);
            write_numbers(file, values, 5);
        }
    varied_columns_free(&columns);
}

struct statistic statistic_of(const double values[], int n)
{
    struct statistic s = {n, NAN, NAN, NAN, NAN};
    if (n > 0) {
        s.mean = gsl_stats_mean(values, 1, (size_t)n);
        s.least = gsl_stats_min(values, 1, (size_t)n);
        s.largest = gsl_stats_max(values, 1, (size_t)n);
    }
    if (n > 1) s.deviation = deviation_of(values, n);
    return s;
}

struct statistic group_statistic(const struct properties lists[], const int numbers[], int n,
                                 const char *name)
{
    double *values = memory_new((size_t)n, sizeof *values);
    int there = 0;
    for (int k = 0; k < n; k++) {
        const double value = properties_value(&lists[numbers[k]], name);
        if (isfinite(value)) values[there++] = value;
    }
    const struct statistic s = statistic_of(values, there);
    free(values);
    return s;
}

static void write_group(FILE *file, const struct properties lists[], const struct label labels[],
                        const struct varied_columns *columns, const int numbers[], int count)
{
    const struct properties *first = &lists[numbers[0]];
    for (int i = 0; i < first->count; i++) {
        const struct property *property = &first->items[i];
        const struct statistic s = group_statistic(lists, numbers, count, property->name);
        csv_text(file, labels[numbers[0]].title);
        varied_columns_values(file, columns, &labels[numbers[0]], VARIED_SCATTER);
        const char *const texts[] = {property->name, property->symbol, property->unit};
        for (int j = 0; j < 3; j++) {
            fputc(',', file);
            csv_text(file, texts[j]);
        }
        fprintf(file, ",%d", s.count);
        write_numbers(file, (double[]){s.mean, s.deviation, s.least, s.largest}, 4);
    }
}

void groups_write_properties(FILE *file, const struct properties lists[],
                             const struct label labels[], int count)
{
    int *numbers = memory_new((size_t)count, sizeof *numbers);
    struct varied_columns columns = varied_columns_of(labels, count);
    fputs("group", file);
    varied_columns_heading(file, &columns, VARIED_SCATTER);
    fputs(",property,symbol,unit,count,mean,standard_deviation,least,largest\n", file);
    for (int i = 0; i < count; i++) {
        const int n = group_members(labels, count, labels[i].title, numbers);
        if (numbers[0] == i) write_group(file, lists, labels, &columns, numbers, n);
    }
    varied_columns_free(&columns);
    free(numbers);
}
