#include "noise.h"

#include "memory.h"

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_ROWS = 50, MOST_BESIDE = 25, FEWEST_CROSSINGS = 8, CUBIC = 4 };

static const double few_share = 0.05; /* of rows with fewer beside them, which do not count */
static const double normal_median = 0.67448975; /* of the absolute value of a normal variable */

/* Destroys the order of values. */
static double deviation(double values[], size_t n)
{
    for (size_t i = 0; i < n; i++) values[i] = fabs(values[i]);
    gsl_sort(values, 1, n);
    return gsl_stats_median_from_sorted_data(values, 1, n) / normal_median;
}

static double by_second_differences(const double y[], long n, double work[])
{
    for (long i = 0; i < n - 2; i++) work[i] = (y[i] - 2 * y[i + 1] + y[i + 2]) / sqrt(6);
    return deviation(work, (size_t)n - 2);
}

/* Of rows that far apart. */
static double by_fourth_differences(const double y[], long n, long apart, double work[])
{
    for (long i = 0; i < n - 4 * apart; i++)
        work[i] = (y[i] - 4 * y[i + apart] + 6 * y[i + 2 * apart] - 4 * y[i + 3 * apart] +
                   y[i + 4 * apart]) /
                  sqrt(70);
    return deviation(work, (size_t)(n - 4 * apart));
}

static double by_chords(const double x[], const double y[], long n, double work[])
{
    size_t count = 0;
    for (long i = 1; i < n - 1; i++) {
        const double share = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
        if (!(share > 0 && share < 1)) continue;
        const double off = y[i] - (1 - share) * y[i - 1] - share * y[i + 1];
        work[count++] = off / sqrt(1 + share * share + (1 - share) * (1 - share));
    }
    return count < FEWEST_ROWS / 2 ? INFINITY : deviation(work, count);
}

/* Of values that were rounded to steps; 0 where too few rows repeat the one before for that. */
static double by_rounding(const double y[], long n, double work[])
{
    const double repeated = 0.25, usual = 0.05; /* shares: of rows, and where the least change is */
    size_t count = 0;
    for (long i = 1; i < n; i++)
        if (y[i] != y[i - 1]) work[count++] = fabs(y[i] - y[i - 1]);
    if (count == 0 || (double)(n - 1) - (double)count < repeated * (double)(n - 1)) return 0;
    gsl_sort(work, 1, count);
    return gsl_stats_quantile_from_sorted_data(work, 1, count, usual) / sqrt(12);
}

/* Whether all changes are whole numbers of the step; *turns: how often that number is not the one
 * of the row before. */
static bool are_whole(const double y[], long n, double step, long *turns)
{
    const double off = 0.02;
    double before = NAN;
    *turns = -1;
    for (long i = 1; i < n; i++) {
        const double steps = (y[i] - y[i - 1]) / step, whole = round(steps);
        if (fabs(steps - whole) > off) return false;
        *turns += whole != before;
        before = whole;
    }
    return true;
}

/* Of values that were rounded to a step that is smaller than their changes, which then are whole
 * numbers of it, now more, now fewer; a ramp that is exact, or is one by parts, has one number
 * for long. 0: no such step. */
static double by_grid(const double y[], long n)
{
    enum { MOST_STEPS = 10 };
    const double least_turns = fmax(0.01 * (double)n, 8);
    double least = INFINITY;
    long turns;
    for (long i = 1; i < n; i++)
        if (y[i] != y[i - 1]) least = fmin(least, fabs(y[i] - y[i - 1]));
    for (int k = 1; isfinite(least) && k <= MOST_STEPS; k++)
        if (are_whole(y, n, least / k, &turns))
            return (double)turns < least_turns ? 0 : least / k / sqrt(12);
    return 0;
}

/* The mean where all three agree, of which the least would be too small; else the least, as a
 * bend adds to the others. */
static double together(const double seen[3])
{
    const double agree = 1.2;
    const double least = fmin(fmin(seen[0], seen[1]), seen[2]);
    const double most = fmax(fmax(seen[0], seen[1]), seen[2]);
    return most <= agree * least ? (seen[0] + seen[1] + seen[2]) / 3 : least;
}

double noise_of(const double x[], const double y[], long n)
{
    if (n < FEWEST_ROWS) return 0;
    double *work = memory_new((size_t)n, sizeof *work);
    const double seen[] = {by_second_differences(y, n, work), by_fourth_differences(y, n, 1, work),
                           by_chords(x, y, n, work)};
    const double rounding = by_rounding(y, n, work);
    free(work);
    return fmax(together(seen), rounding);
}

double noise_of_strain(const double strain[], long n, long first, long count)
{
    const double least_share = 0.01;
    long falls = 0;
    for (long i = 1; i < n; i++) falls += strain[i] < strain[i - 1];
    if (n < FEWEST_ROWS) return 0;
    double *work = memory_new((size_t)n, sizeof *work);
    double noise = by_grid(strain, n);
    if (noise == 0 && count > 1) noise = by_rounding(strain + first, count, work);
    if (noise == 0) noise = by_rounding(strain, n, work);
    if ((double)falls >= least_share * (double)n)
        noise = fmax(noise, fmin(by_second_differences(strain, n, work),
                                 by_fourth_differences(strain, n, 1, work)));
    free(work);
    return noise;
}

double noise_of_means(struct noise noise)
{
    return noise.deviation * sqrt((1 + noise.correlation) / (1 - noise.correlation));
}

/* Of fourth differences of an autoregressive sequence over their deviation where rows are
 * independent, squared. */
static double seen_share(double correlation)
{
    const double r = correlation;
    return (70 + r * (-112 + r * (56 + r * (-16 + 2 * r)))) / 70;
}

struct noise noise_filtered(const double y[], long n)
{
    /* The noise of rows that are farther and farther apart grows no more than a sum of
     * independent ones would, by the root of two; what grows faster is the bend of the curve,
     * what grows no more is all. */
    const double least_growth = 1.05, most_growth = 1.6;
    double *work = memory_new((size_t)n, sizeof *work);
    const double near = by_fourth_differences(y, n, 1, work);
    double whole = near, low = 0, high = 0.999;
    for (long apart = 2; 16 * apart <= n; apart *= 2) {
        const double now = by_fourth_differences(y, n, apart, work);
        if (now > most_growth * whole) break;
        const bool grows = now > least_growth * whole;
        whole = fmax(whole, now);
        if (!grows) break;
    }
    free(work);
    while (whole > near && high - low > 1e-6) {
        const double middle = (low + high) / 2;
        *(seen_share(middle) * whole * whole > near * near ? &low : &high) = middle;
    }
    return (struct noise){whole, low};
}

/* What is left of y [n] about the cubic in x of least squares; false where there is none. */
static bool take_residuals(const double x[], const double y[], size_t n, double left[])
{
    gsl_matrix *powers = gsl_matrix_alloc(n, CUBIC), *covariance = gsl_matrix_alloc(CUBIC, CUBIC);
    gsl_vector *values = gsl_vector_alloc(n), *solution = gsl_vector_alloc(CUBIC),
               *residuals = gsl_vector_calloc(n);
    gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc(n, CUBIC);
    const double middle = (x[0] + x[n - 1]) / 2, half = (x[n - 1] - x[0]) / 2;
    double squares = NAN;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < CUBIC; k++)
            gsl_matrix_set(powers, i, k, pow((x[i] - middle) / half, (double)k));
        gsl_vector_set(values, i, y[i]);
    }
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    const bool done = half > 0 && gsl_multifit_linear(powers, values, solution, covariance,
                                                      &squares, work) == GSL_SUCCESS;
    gsl_set_error_handler(handler);
    if (done) gsl_multifit_linear_residuals(powers, values, solution, residuals);
    for (size_t i = 0; i < n; i++) left[i] = gsl_vector_get(residuals, i);
    gsl_multifit_linear_free(work);
    gsl_vector_free(residuals);
    gsl_vector_free(solution);
    gsl_vector_free(values);
    gsl_matrix_free(covariance);
    gsl_matrix_free(powers);
    return done && isfinite(squares);
}

double noise_about_cubic(const double x[], const double y[], long n)
{
    double *left = memory_new((size_t)n, sizeof *left);
    const bool done = n > CUBIC && take_residuals(x, y, (size_t)n, left);
    const double squares = gsl_stats_tss_m(left, 1, (size_t)n, 0);
    free(left);
    return done ? sqrt(squares / (double)(n - CUBIC)) : INFINITY;
}

struct noise noise_about_line(const double x[], const double y[], long n)
{
    struct noise noise = {0, 0};
    if (n < FEWEST_ROWS) return noise;
    double *left = memory_new((size_t)n, sizeof *left), squares = 0, products = 0;
    const bool done = take_residuals(x, y, (size_t)n, left);
    long crossings = 0;
    for (long i = 0; done && i < n; i++) {
        squares += left[i] * left[i];
        if (i == 0) continue;
        products += left[i] * left[i - 1];
        crossings += left[i] * left[i - 1] < 0;
    }
    free(left);
    if (!done || crossings < FEWEST_CROSSINGS) return noise;
    noise.deviation = sqrt(squares / (double)(n - CUBIC));
    noise.correlation = fmax(products / squares, 0);
    return noise;
}

void noise_smooth(const double x[], const double y[], long n, double width, struct noise noise,
                  double smooth[], double *left)
{
    *left = noise.deviation;
    if (!(noise.deviation > 0)) {
        memcpy(smooth, y, (size_t)n * sizeof *y);
        return;
    }
    /* Rows that make one independent one. */
    const double alike = (1 + noise.correlation) / (1 - noise.correlation);
    const long most = lround(MOST_BESIDE * alike);
    double *counts = memory_new((size_t)n, sizeof *counts);
    for (long i = 0; i < n; i++) {
        long k = 0;
        double sum = y[i];
        while (k < most && i - k - 1 >= 0 && i + k + 1 < n &&
               fabs(x[i] - x[i - k - 1]) <= width / 2 && fabs(x[i + k + 1] - x[i]) <= width / 2) {
            k++;
            sum += y[i - k] + y[i + k];
        }
        counts[i] = (double)(2 * k + 1);
        smooth[i] = sum / counts[i];
    }
    gsl_sort(counts, 1, (size_t)n);
    const double few = gsl_stats_quantile_from_sorted_data(counts, 1, (size_t)n, few_share);
    *left = noise.deviation * sqrt(fmin(alike / few, 1));
    free(counts);
}

struct noise_sequence noise_begin(struct noise noise, struct random_stream *stream)
{
    return (struct noise_sequence){noise, noise.deviation * random_gaussian(stream)};
}

double noise_next(struct noise_sequence *sequence, struct random_stream *stream)
{
    const double correlation = sequence->noise.correlation, now = sequence->last;
    sequence->last = correlation * now + sqrt(1 - correlation * correlation) *
                                             sequence->noise.deviation * random_gaussian(stream);
    return now;
}

void noise_trend(const double x[], double values[], long n, struct noise noise)
{
    const double widths[] = {0.0005, 0.001, 0.002, 0.004, 0.008, 0.016}, differs = 4;
    double *mean = memory_new((size_t)n, sizeof *mean), *from = memory_new((size_t)n, sizeof *from);
    bool *settled = memory_new((size_t)n, sizeof *settled);
    double left = noise.deviation, next;
    memcpy(from, values, (size_t)n * sizeof *from);
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++, left = next) {
        noise_smooth(x, from, n, widths[k], noise, mean, &next);
        for (long i = 0; i < n; i++) {
            settled[i] = settled[i] || fabs(mean[i] - values[i]) > differs * left;
            if (!settled[i]) values[i] = mean[i];
        }
    }
    free(mean);
    free(from);
    free(settled);
}
