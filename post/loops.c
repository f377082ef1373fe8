#include "loops.h"

#include "csv.h"
#include "die.h"
#include "memory.h"
#include "noise.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum { FEWEST_POINTS = 3 };

static const double giga = 1e9, mega = 1e6;
static const double shares[2] = {0.1, 0.4}; /* of the change of stress of a branch */

/* A branch in true stress and strain, from its beginning on. */
struct branch {
    long n;
    double *strain, *stress;
};

static struct branch branch_of(const struct curve *curve, long from, long to)
{
    struct branch branch = {.n = to - from + 1};
    branch.strain = memory_new((size_t)branch.n, sizeof(double));
    branch.stress = memory_new((size_t)branch.n, sizeof(double));
    for (long i = 0; i < branch.n; i++) {
        const double e = curve->strain[from + i];
        branch.strain[i] = log1p(e);
        branch.stress[i] = curve->stress[from + i] * (1 + e);
    }
    return branch;
}

static void branch_free(struct branch *branch)
{
    free(branch->strain);
    free(branch->stress);
}

/* strain = at + (stress - from) / slope; slope NAN where there are too few points. */
struct line {
    double slope, strain, stress;
};

static struct line fit_branch(const struct branch *branch, double change)
{
    const double from = branch->stress[0];
    long first = 0;
    while (first < branch->n && (branch->stress[first] - from) / change < shares[0]) first++;
    long last = first;
    while (last < branch->n && (branch->stress[last] - from) / change <= shares[1]) last++;
    if (last - first < FEWEST_POINTS) return (struct line){NAN, NAN, NAN};
    double c0, c1, c00, c01, c11, squares;
    gsl_fit_linear(branch->stress + first, 1, branch->strain + first, 1, (size_t)(last - first),
                   &c0, &c1, &c00, &c01, &c11, &squares);
    return (struct line){1 / c1, c0 + c1 * from, from};
}

/* Stress where the strain goes off the line by offset for good, in the direction of the branch
 * (sign of change). */
static double yield_of(const struct branch *branch, struct line line, double offset, double change)
{
    const double sign = change > 0 ? 1 : -1;
    double before = -offset, found = NAN;
    for (long i = 0; i < branch->n; i++) {
        const double elastic = line.strain + (branch->stress[i] - line.stress) / line.slope;
        const double off = sign * (branch->strain[i] - elastic) - offset;
        if (off < 0) found = NAN;
        if (before < 0 && off >= 0 && i > 0)
            found = branch->stress[i - 1] +
                    before / (before - off) * (branch->stress[i] - branch->stress[i - 1]);
        before = off;
    }
    return found;
}

/* Strain of a branch at a stress, linear between its first rows around it; NAN outside. */
static double strain_at(const struct branch *branch, double stress)
{
    for (long i = 1; i < branch->n; i++) {
        const double a = branch->stress[i - 1], b = branch->stress[i];
        if (!((a <= stress && stress <= b) || (b <= stress && stress <= a)) || a == b) continue;
        return branch->strain[i - 1] +
               (stress - a) / (b - a) * (branch->strain[i] - branch->strain[i - 1]);
    }
    return NAN;
}

/* Width and area between the branches, over the stresses that both have. */
static void hysteresis(struct loop *loop, const struct branch *down, const struct branch *up)
{
    enum { STEPS = 400 };
    double reached = up->stress[0];
    for (long i = 0; i < up->n; i++) reached = fmax(reached, up->stress[i]);
    const double low = loop->lowest, high = fmin(loop->flow, reached);
    loop->width = loop->area = 0;
    for (int i = 0; i < STEPS; i++) {
        const double stress = low + (high - low) * (i + 0.5) / STEPS;
        const double apart = strain_at(down, stress) - strain_at(up, stress);
        if (isnan(apart)) continue;
        loop->width = fmax(loop->width, apart);
        loop->area += apart * (high - low) / STEPS;
    }
}

struct loop loop_measure(const struct curve *curve, const struct excursion *x, long next,
                         double offset, double modulus)
{
    struct branch down = branch_of(curve, x->begin, x->bottom),
                  up = branch_of(curve, x->bottom, next);
    struct loop loop = {.strain = down.strain[0], .flow = down.stress[0], .lowest = up.stress[0]};
    const double fall = loop.lowest - loop.flow;
    const struct line unloading = fit_branch(&down, fall), reloading = fit_branch(&up, -fall);
    loop.plastic = loop.strain - loop.flow / modulus;
    loop.unloading = unloading.slope;
    loop.reloading = reloading.slope;
    loop.damage = 1 - loop.unloading / modulus;
    loop.reverse = yield_of(&down, unloading, offset, fall);
    loop.yield = yield_of(&up, reloading, offset, -fall);
    loop.back = (loop.yield + loop.reverse) / 2;
    loop.effective = (loop.yield - loop.reverse) / 2;
    loop.flag = isnan(loop.unloading) || isnan(loop.reloading) ? "few_points"
                : isnan(loop.reverse)                          ? "no_reverse_yield"
                : isnan(loop.yield)                            ? "no_yield"
                                                               : NULL;
    hysteresis(&loop, &down, &up);
    branch_free(&down);
    branch_free(&up);
    return loop;
}

/* What has an error of its own. */
static const struct {
    size_t value, error;
} uncertain[] = {
#define WITH_ERROR(member)                                                                         \
    {                                                                                              \
        offsetof(struct loop, member), offsetof(struct loop, error.member)                         \
    }
    WITH_ERROR(unloading), WITH_ERROR(reloading), WITH_ERROR(reverse),
    WITH_ERROR(yield),     WITH_ERROR(back),      WITH_ERROR(effective),
};
enum { UNCERTAIN = sizeof uncertain / sizeof *uncertain, RESAMPLES = 250 };

static double *member(struct loop *loop, size_t place)
{
    return (double *)((char *)loop + place);
}

/* Rows of a loop and of its reloading without most of their noise, as a curve of their own. */
static struct curve trend_of(const struct curve *curve, const struct excursion *x, long next,
                             const struct analysis *analysis)
{
    const long n = next - x->begin + 1, fall = x->bottom - x->begin + 1;
    long *rows = memory_new((size_t)n, sizeof *rows);
    for (long i = 0; i < n; i++) rows[i] = x->begin + i;
    struct curve trend = curve_rows(curve, n, rows);
    const struct noise strain = {analysis->strain_noise, 0};
    const long begins[] = {0, fall - 1}, counts[] = {fall, n - fall + 1};
    for (int k = 0; k < 2; k++) {
        noise_trend(curve->strain + x->begin + begins[k], trend.stress + begins[k], counts[k],
                    analysis->noise);
        noise_trend(curve->strain + x->begin + begins[k], trend.strain + begins[k], counts[k],
                    strain);
    }
    free(rows);
    return trend;
}

static void add_noise(struct curve *curve, const struct curve *trend,
                      const struct analysis *analysis, struct random_stream *stream)
{
    struct noise_sequence sequence = noise_begin(analysis->noise, stream);
    for (long i = 0; i < trend->n; i++) {
        curve->strain[i] = trend->strain[i] + analysis->strain_noise * random_gaussian(stream);
        curve->stress[i] = trend->stress[i] + noise_next(&sequence, stream);
    }
}

static void find_errors(struct loop *loop, const struct curve *curve, const struct excursion *x,
                        long next, double offset, const struct analysis *analysis)
{
    const double modulus = analysis->measures.line.slope;
    double squares[UNCERTAIN] = {0};
    int counts[UNCERTAIN] = {0};
    for (int k = 0; k < UNCERTAIN; k++) *member(loop, uncertain[k].error) = NAN;
    if (!(analysis->noise.deviation > 0 || analysis->strain_noise > 0)) return;
    struct curve trend = trend_of(curve, x, next, analysis),
                 drawn = trend_of(curve, x, next, analysis);
    const struct excursion own = {x->kind, 0, x->bottom - x->begin, x->end - x->begin};
    struct loop reference = loop_measure(&trend, &own, trend.n - 1, offset, modulus);
    struct random_stream *stream = random_new(1, "bootstrap");
    for (int i = 0; i < RESAMPLES; i++) {
        add_noise(&drawn, &trend, analysis, stream);
        struct loop again = loop_measure(&drawn, &own, trend.n - 1, offset, modulus);
        for (int k = 0; k < UNCERTAIN; k++) {
            const double change =
                *member(&again, uncertain[k].value) - *member(&reference, uncertain[k].value);
            if (!isfinite(change)) continue;
            squares[k] += change * change;
            counts[k]++;
        }
    }
    for (int k = 0; k < UNCERTAIN; k++)
        if (counts[k] > RESAMPLES / 2 && isfinite(*member(loop, uncertain[k].value)))
            *member(loop, uncertain[k].error) = sqrt(squares[k] / counts[k]);
    random_free(stream);
    curve_free(&trend);
    curve_free(&drawn);
}

struct loop *loops_find(const struct curve *curve, const struct analysis *analysis, double offset,
                        long *count)
{
    const struct record *record = &analysis->record;
    struct loop *loops = NULL;
    *count = 0;
    for (long i = 0; i < record->count; i++) {
        const struct excursion *x = &record->excursions[i];
        if (x->kind != EXCURSION_LOOP) continue;
        /* The reloading goes on to twice the strain of the loop, to the next excursion or to the
         * end. */
        const double span = curve->strain[x->begin] - curve->strain[x->bottom];
        const long most = i + 1 < record->count ? x[1].begin : curve->n - 1;
        long next = x->end;
        while (next < most && curve->strain[next] < curve->strain[x->begin] + span) next++;
        loops = memory_grow(loops, *count, sizeof *loops);
        struct loop *loop = &loops[(*count)++];
        *loop = loop_measure(curve, x, next, offset, analysis->measures.line.slope);
        find_errors(loop, curve, x, next, offset, analysis);
    }
    return loops;
}

/* The columns: what each is called, and in which unit it is written. */
static const struct {
    const char *name;
    double unit;
    size_t place;
} columns[] = {
    {"true_strain", 1, offsetof(struct loop, strain)},
    {"plastic_strain", 1, offsetof(struct loop, plastic)},
    {"flow_stress_MPa", 1e6, offsetof(struct loop, flow)},
    {"lowest_stress_MPa", 1e6, offsetof(struct loop, lowest)},
    {"unloading_modulus_GPa", 1e9, offsetof(struct loop, unloading)},
    {"reloading_modulus_GPa", 1e9, offsetof(struct loop, reloading)},
    {"reverse_yield_MPa", 1e6, offsetof(struct loop, reverse)},
    {"reload_yield_MPa", 1e6, offsetof(struct loop, yield)},
    {"back_stress_MPa", 1e6, offsetof(struct loop, back)},
    {"effective_stress_MPa", 1e6, offsetof(struct loop, effective)},
    {"hysteresis_width", 1, offsetof(struct loop, width)},
    {"hysteresis_area_MJ_per_m3", 1e6, offsetof(struct loop, area)},
    {"damage", 1, offsetof(struct loop, damage)},
    {"unloading_modulus_error_GPa", 1e9, offsetof(struct loop, error.unloading)},
    {"reloading_modulus_error_GPa", 1e9, offsetof(struct loop, error.reloading)},
    {"reverse_yield_error_MPa", 1e6, offsetof(struct loop, error.reverse)},
    {"reload_yield_error_MPa", 1e6, offsetof(struct loop, error.yield)},
    {"back_stress_error_MPa", 1e6, offsetof(struct loop, error.back)},
    {"effective_stress_error_MPa", 1e6, offsetof(struct loop, error.effective)},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

void loops_write_header(FILE *file, bool labelled)
{
    fputs(labelled ? "curve,loop" : "loop", file);
    for (int j = 0; j < COLUMNS; j++) fprintf(file, ",%s", columns[j].name);
    fputs(",flag\n", file);
}

void loops_write(FILE *file, const struct loop loops[], long count, const char *label)
{
    for (long i = 0; i < count; i++) {
        if (label) csv_text(file, label);
        fprintf(file, "%s%ld", label ? "," : "", i + 1);
        for (int j = 0; j < COLUMNS; j++) {
            fputc(',', file);
            csv_number(file, *(const double *)((const char *)&loops[i] + columns[j].place) /
                                 columns[j].unit);
        }
        fprintf(file, ",%s\n", loops[i].flag ? loops[i].flag : "");
    }
}

void loops_print(const struct loop loops[], long count)
{
    for (long i = 0; i < count; i++) {
        const struct loop *l = &loops[i];
        if (l->flag)
            note("  loop %ld at %.2f %%: flow stress %.0f MPa, unloading %.1f GPa, %s", i + 1,
                 100 * l->strain, l->flow / mega, l->unloading / giga, l->flag);
        else
            note("  loop %ld at %.2f %%: flow stress %.0f MPa, back stress %.0f MPa (%.0f %%), "
                 "unloading %.1f GPa",
                 i + 1, 100 * l->strain, l->flow / mega, l->back / mega, 100 * l->back / l->flow,
                 l->unloading / giga);
    }
}
