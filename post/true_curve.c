#include "true_curve.h"

#include "memory.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

enum { FEWEST_SLOPE_POINTS = 5, FEWEST_POWER_POINTS = 3 };

static const double reach_share = 0.98;
static const double first_plastic_strain = 0.001; /* below, d sigma/d eps_p is dominated by E */

/* First row from which the curve counts as plastic; last + 1 where none does. */
static long plastic_begin(const struct curve *curve, long last)
{
    long i = 0;
    while (i <= last && !(curve->plastic_strain[i] >= first_plastic_strain)) i++;
    return i;
}

/* Derivative at x = 0 of the quadratic through n points by least squares. */
static double quadratic_slope(const double x[], const double y[], size_t n)
{
    gsl_matrix *powers = gsl_matrix_alloc(n, 3), *covariance = gsl_matrix_alloc(3, 3);
    gsl_vector *values = gsl_vector_alloc(n), *solution = gsl_vector_alloc(3);
    gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc(n, 3);
    for (size_t i = 0; i < n; i++) {
        gsl_matrix_set(powers, i, 0, 1);
        gsl_matrix_set(powers, i, 1, x[i]);
        gsl_matrix_set(powers, i, 2, x[i] * x[i]);
        gsl_vector_set(values, i, y[i]);
    }
    double squares, slope = NAN;
    size_t rank = 0;
    if (gsl_multifit_linear_tsvd(powers, values, 1e-10, solution, covariance, &squares, &rank,
                                 work) == GSL_SUCCESS &&
        rank == 3)
        slope = gsl_vector_get(solution, 1);
    gsl_multifit_linear_free(work);
    gsl_vector_free(solution);
    gsl_vector_free(values);
    gsl_matrix_free(covariance);
    gsl_matrix_free(powers);
    return slope;
}

/* d sigma / d eps at row i from the rows first ... last around it. */
static double local_slope(const struct curve *curve, long i, long first, long last, double window)
{
    const double *eps = curve->true_strain, *sigma = curve->true_stress;
    long from = i, to = i;
    while (from > first && eps[i] - eps[from - 1] <= window / 2) from--;
    while (to < last && eps[to + 1] - eps[i] <= window / 2) to++;
    while (to - from + 1 < FEWEST_SLOPE_POINTS && (from > first || to < last)) {
        bool take_lower =
            to == last || (from > first && eps[i] - eps[from - 1] <= eps[to + 1] - eps[i]);
        if (take_lower)
            from--;
        else
            to++;
    }
    size_t n = (size_t)(to - from + 1);
    if (n < FEWEST_SLOPE_POINTS) return NAN;
    double *x = memory_new(n, sizeof *x), *y = memory_new(n, sizeof *y);
    /* Of order one: strain in windows, stress in that of the row. */
    double scale = fmax(window, eps[to] - eps[from]);
    for (size_t k = 0; k < n; k++) {
        x[k] = (eps[from + (long)k] - eps[i]) / scale;
        y[k] = sigma[from + (long)k] / sigma[i];
    }
    double slope = quadratic_slope(x, y, n) * sigma[i] / scale;
    free(x);
    free(y);
    return slope;
}

/* theta at a row; d eps_p = d eps - d sigma / E. */
static double rate_at(const struct curve *curve, double modulus, long row, long first, long last,
                      double window)
{
    const double slope = local_slope(curve, row, first, last, window);
    return slope < modulus ? slope / (1 - slope / modulus) : NAN;
}

/* At rows a hundredth of the window apart at least, and linear between them: a slope over
 * thousands of rows does not change from one to the next. */
static void fill_rates(struct curve *curve, double modulus, long last, double window)
{
    const double apart = window / 100, *eps = curve->true_strain;
    double *rate = curve->hardening_rate;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    const long first = plastic_begin(curve, last);
    long before = -1;
    for (long i = first; i <= last; i++) {
        if (before >= 0 && i < last && eps[i] - eps[before] < apart) continue;
        rate[i] = rate_at(curve, modulus, i, first, last, window);
        for (long k = before + 1; before >= 0 && k < i; k++)
            rate[k] = rate[before] +
                      (eps[k] - eps[before]) / (eps[i] - eps[before]) * (rate[i] - rate[before]);
        before = i;
    }
    gsl_set_error_handler(handler);
}

void true_curve_fill(struct curve *curve, const struct elastic_line *line, double modulus,
                     long last, double window)
{
    double toe = isnan(line->slope) ? 0 : line->toe;
    for (long i = 0; i <= last; i++) {
        double stretch = 1 + curve->strain[i] - toe;
        if (!(stretch > 0)) continue;
        curve->true_strain[i] = log(stretch);
        curve->true_stress[i] = curve->stress[i] * stretch;
        curve->plastic_strain[i] = curve->true_strain[i] - curve->true_stress[i] / modulus;
    }
    fill_rates(curve, modulus, last, window);
}

void true_curve_cut(struct curve *curve, long maximum)
{
    for (long i = maximum + 1; i < curve->n; i++)
        curve->true_strain[i] = curve->true_stress[i] = curve->plastic_strain[i] =
            curve->hardening_rate[i] = NAN;
}

long true_curve_reach(const struct curve *curve, long maximum)
{
    double level = reach_share * curve->stress[maximum];
    long row = maximum;
    while (row < curve->n - 1 && curve->stress[row + 1] >= level) row++;
    return row;
}

/* Standard error of the slope of n rows over a width. */
static double slope_error(double noise, double width, double n)
{
    return noise * sqrt(12 / fmax(n, 1)) / width;
}

double true_curve_window(const struct curve *curve, long last, double window, double noise)
{
    const double wider = 1.5, share = 0.02, most = 0.2;
    const double end = log1p(curve->strain[last]),
                 sigma = curve->stress[last] * (1 + curve->strain[last]);
    for (; noise > 0 && window < most * end; window *= wider) {
        long n = 0;
        while (n <= last && end - log1p(curve->strain[last - n]) <= window) n++;
        if (slope_error(noise, window, (double)n) <= share * sigma) break;
    }
    return window;
}

/* d sigma/d eps - sigma at a row. */
static double above_at(const struct curve *curve, double modulus, long row)
{
    const double theta = curve->hardening_rate[row];
    return theta / (1 + theta / modulus) - curve->true_stress[row];
}

/* Error of the noise at a row where slope and stress are equal: that of the slope over how fast
 * the two part. */
static double considere_error(const struct curve *curve, const struct slopes *slopes, long row)
{
    const double *eps = curve->true_strain;
    long from = row, to = row;
    while (from > slopes->first && eps[row] - eps[from] < slopes->window / 2) from--;
    while (to < slopes->last && eps[to] - eps[row] < slopes->window / 2) to++;
    const double parting =
        (above_at(curve, slopes->modulus, to) - above_at(curve, slopes->modulus, from)) /
        (eps[to] - eps[from]);
    /* the noise is that of engineering stress */
    const double noise = slopes->noise * exp(eps[row]);
    return slope_error(noise, slopes->window, (double)(to - from + 1)) / fabs(parting);
}

struct considere true_curve_considere(const struct curve *curve, const struct slopes *slopes)
{
    const double *eps = curve->true_strain, *sigma = curve->true_stress;
    long first = plastic_begin(curve, slopes->last);
    if (first < slopes->first) first = slopes->first;
    /* Of several crossings that which has most of the strain above on its left, and below on its
     * right. */
    long best = -1;
    double sum = 0, most = 0;
    for (long i = first + 1; i <= slopes->last; i++) {
        const double before = above_at(curve, slopes->modulus, i - 1);
        sum += (eps[i] - eps[i - 1]) * (before > 0 ? 1 : -1);
        if (!(before > 0 && above_at(curve, slopes->modulus, i) <= 0) || !(best < 0 || sum > most))
            continue;
        most = sum;
        best = i;
    }
    if (best >= 0) {
        const double before = above_at(curve, slopes->modulus, best - 1);
        const double share = before / (before - above_at(curve, slopes->modulus, best));
        return (struct considere){eps[best - 1] + share * (eps[best] - eps[best - 1]),
                                  sigma[best - 1] + share * (sigma[best] - sigma[best - 1]),
                                  slopes->noise > 0 ? considere_error(curve, slopes, best) : NAN};
    }
    return (struct considere){NAN, NAN, NAN};
}

static void regress(const double x[], const double y[], struct power_law *law)
{
    size_t n = (size_t)law->count;
    double intercept, c00, c01, c11, squares;
    gsl_fit_linear(x, 1, y, 1, n, &intercept, &law->exponent, &c00, &c01, &c11, &squares);
    law->error = sqrt(c11);
    law->strength = exp(intercept);
    law->strength_error = law->strength * sqrt(c00);
    law->r_squared = 1 - squares / gsl_stats_tss(y, 1, n);
}

struct power_law true_curve_power_law(const struct curve *curve, const struct elastic_line *line,
                                      double modulus, long last, double low, double high)
{
    struct power_law law = {NAN, NAN, NAN, NAN, NAN, low, high, 0};
    double *x = memory_new((size_t)last + 1, sizeof *x),
           *y = memory_new((size_t)last + 1, sizeof *y);
    for (long i = 0; i <= last; i++) {
        const double total = curve->strain[i] - line->toe, sigma = curve->stress[i] * (1 + total);
        const double plastic = total - curve->stress[i] / line->slope;
        const double eps = log1p(total) - sigma / modulus;
        if (!(plastic >= low && plastic <= high && eps > 0 && sigma > 0)) continue;
        x[law.count] = log(eps);
        y[law.count++] = log(sigma);
    }
    if (law.count >= FEWEST_POWER_POINTS) regress(x, y, &law);
    free(x);
    free(y);
    return law;
}

struct strain_ratio true_curve_ratio(const struct curve *curve, const struct elastic_line *line,
                                     double modulus, long last, double low, double high)
{
    const double *across = table_find(&curve->table, "transverse_strain");
    struct strain_ratio found = {NAN, NAN, 0};
    double c0, elastic, slope, c00, c01, c11, squares;
    if (!across || line->count < FEWEST_POWER_POINTS) return found;
    gsl_fit_linear(curve->stress + line->first, 1, across + line->first, 1, (size_t)line->count,
                   &c0, &elastic, &c00, &c01, &c11, &squares);
    double *x = memory_new((size_t)last + 1, sizeof *x),
           *y = memory_new((size_t)last + 1, sizeof *y);
    for (long i = 0; i <= last; i++) {
        const double total = curve->strain[i] - line->toe, sigma = curve->stress[i] * (1 + total);
        const double plastic = total - curve->stress[i] / line->slope;
        if (!(plastic >= low && plastic <= high) || isnan(across[i])) continue;
        x[found.count] = log1p(total) - sigma / modulus;
        y[found.count++] = log1p(across[i] - c0) - elastic * sigma;
    }
    if (found.count >= FEWEST_POWER_POINTS) {
        gsl_fit_linear(x, 1, y, 1, (size_t)found.count, &c0, &slope, &c00, &c01, &c11, &squares);
        found.ratio = -slope / (1 + slope);
        found.error = sqrt(c11) / ((1 + slope) * (1 + slope));
    }
    free(x);
    free(y);
    return found;
}

struct law_fit true_curve_fit(const struct curve *curve, const struct hardening_law *law, long last,
                              const double range[2])
{
    double *p = memory_new((size_t)last + 1, sizeof *p);
    double *stress = memory_new((size_t)last + 1, sizeof *stress);
    long n = 0;
    for (long i = 0; i <= last; i++) {
        double plastic = curve->plastic_strain[i];
        if (!(plastic > 0 && plastic >= range[0] && plastic <= range[1])) continue;
        p[n] = plastic;
        stress[n++] = curve->true_stress[i];
    }
    struct law_fit fit = law_fit(law, p, stress, n);
    free(p);
    free(stress);
    return fit;
}
