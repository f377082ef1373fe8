#include "noise.h"

#include "memory.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_ROWS = 50, MOST_BESIDE = 25 };

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

static double by_fourth_differences(const double y[], long n, double work[])
{
    for (long i = 0; i < n - 4; i++)
        work[i] = (y[i] - 4 * y[i + 1] + 6 * y[i + 2] - 4 * y[i + 3] + y[i + 4]) / sqrt(70);
    return deviation(work, (size_t)n - 4);
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

double noise_of(const double x[], const double y[], long n)
{
    if (n < FEWEST_ROWS) return 0;
    double *work = memory_new((size_t)n, sizeof *work);
    const double noise =
        fmin(fmin(by_second_differences(y, n, work), by_fourth_differences(y, n, work)),
             by_chords(x, y, n, work));
    free(work);
    return noise;
}

double noise_of_strain(const double strain[], long n)
{
    const double least_share = 0.01;
    long falls = 0;
    for (long i = 1; i < n; i++) falls += strain[i] < strain[i - 1];
    if (n < FEWEST_ROWS || (double)falls < least_share * (double)n) return 0;
    double *work = memory_new((size_t)n, sizeof *work);
    const double noise =
        fmin(by_second_differences(strain, n, work), by_fourth_differences(strain, n, work));
    free(work);
    return noise;
}

void noise_smooth(const double x[], const double y[], long n, double width, double noise,
                  double smooth[], double *left)
{
    *left = noise;
    if (!(noise > 0)) {
        memcpy(smooth, y, (size_t)n * sizeof *y);
        return;
    }
    double *counts = memory_new((size_t)n, sizeof *counts);
    for (long i = 0; i < n; i++) {
        long k = 0;
        double sum = y[i];
        while (k < MOST_BESIDE && i - k - 1 >= 0 && i + k + 1 < n &&
               fabs(x[i] - x[i - k - 1]) <= width / 2 && fabs(x[i + k + 1] - x[i]) <= width / 2) {
            k++;
            sum += y[i - k] + y[i + k];
        }
        counts[i] = (double)(2 * k + 1);
        smooth[i] = sum / counts[i];
    }
    gsl_sort(counts, 1, (size_t)n);
    *left = noise / sqrt(gsl_stats_quantile_from_sorted_data(counts, 1, (size_t)n, few_share));
    free(counts);
}
