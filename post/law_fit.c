#include "law_fit.h"

#include "root.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>

enum { GRID = 24, MOST_ITERATIONS = 500 };

static const double least_apart = 1.5; /* shapes of two terms */
static const double pascals = 1e6;     /* MPa inside, so that all unknowns are of a size */

struct data {
    const struct hardening_law *law;
    const double *p, *stress; /* [n] */
    size_t n;
};

/* Unknowns of the polish: linear parameters in MPa, then logarithms of the shapes, which keeps them
 * positive. */
static void unpack(const gsl_vector *x, struct hardening *hardening)
{
    const struct hardening_law *law = hardening->law;
    int n = law->n_linear;
    for (int k = 0; k < n; k++) hardening->parameter[k] = gsl_vector_get(x, (size_t)k) * pascals;
    for (int k = n; k < n + law->n_shapes; k++)
        hardening->parameter[k] = exp(gsl_vector_get(x, (size_t)k));
}

static int residuals(const gsl_vector *x, void *context, gsl_vector *f)
{
    const struct data *data = context;
    struct hardening law = {.law = data->law};
    unpack(x, &law);
    for (size_t i = 0; i < data->n; i++) {
        double difference = (hardening_stress(&law, data->p[i]) - data->stress[i]) / pascals;
        if (!isfinite(difference)) return GSL_EDOM;
        gsl_vector_set(f, i, difference);
    }
    return GSL_SUCCESS;
}

/* sigma_y = sum a_k f_k(p): f_k is the law whose parameter k is 1 and whose other stresses are
 * 0. */
static void basis(const struct data *data, const double shape[], gsl_matrix *rows)
{
    const int n_linear = data->law->n_linear, n_shapes = data->law->n_shapes;
    for (int k = 0; k < n_linear; k++) {
        struct hardening term = {.law = data->law};
        term.parameter[k] = 1;
        for (int j = 0; j < n_shapes; j++) term.parameter[n_linear + j] = shape[j];
        for (size_t i = 0; i < data->n; i++)
            gsl_matrix_set(rows, i, (size_t)k, hardening_stress(&term, data->p[i]));
    }
}

/* The linear parameters that suit given shapes best; returns the sum of squares in MPa^2. */
static double fit_linear(const struct data *data, const double shape[], double linear[])
{
    size_t n = data->n, m = (size_t)data->law->n_linear;
    gsl_matrix *rows = gsl_matrix_alloc(n, m), *covariance = gsl_matrix_alloc(m, m);
    gsl_vector *stress = gsl_vector_alloc(n), *solution = gsl_vector_alloc(m);
    gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc(n, m);
    basis(data, shape, rows);
    for (size_t i = 0; i < n; i++) gsl_vector_set(stress, i, data->stress[i] / pascals);
    double squares = INFINITY;
    if (gsl_multifit_linear(rows, stress, solution, covariance, &squares, work) != GSL_SUCCESS)
        squares = INFINITY;
    for (size_t k = 0; k < m; k++) linear[k] = gsl_vector_get(solution, k);
    gsl_multifit_linear_free(work);
    gsl_vector_free(solution);
    gsl_vector_free(stress);
    gsl_matrix_free(covariance);
    gsl_matrix_free(rows);
    return squares;
}

static double grid_value(const struct hardening_law *law, int shape, int i)
{
    const double low = law->range[shape].low, high = law->range[shape].high;
    return low * pow(high / low, i / (GRID - 1.0));
}

/* Best point of the grid over the shapes, as a start for the polish. */
static void search(const struct data *data, gsl_vector *start)
{
    const struct hardening_law *law = data->law;
    int outer = law->n_shapes > 0 ? GRID : 1, inner = law->n_shapes > 1 ? GRID : 1;
    double best = INFINITY;
    for (int i = 0; i < outer; i++)
        for (int j = 0; j < inner; j++) {
            double shape[HARDENING_SHAPES] = {1, 1}, linear[HARDENING_PARAMETERS] = {0};
            if (law->n_shapes > 0) shape[0] = grid_value(law, 0, i);
            if (law->n_shapes > 1) shape[1] = grid_value(law, 1, j);
            if (law->interchangeable && j >= i) continue;
            double squares = fit_linear(data, shape, linear);
            if (!(squares < best)) continue;
            best = squares;
            for (int k = 0; k < law->n_linear; k++) gsl_vector_set(start, (size_t)k, linear[k]);
            for (int k = 0; k < law->n_shapes; k++)
                gsl_vector_set(start, (size_t)(law->n_linear + k), log(shape[k]));
        }
}

static void polish(struct data *data, gsl_vector *x, struct law_fit *fit)
{
    size_t parameters = x->size;
    gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_workspace *work =
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, data->n, parameters);
    gsl_multifit_nlinear_fdf system = {
        .f = residuals, .n = data->n, .p = parameters, .params = data};
    int reason = 0;
    gsl_multifit_nlinear_init(x, &system, work);
    int status =
        gsl_multifit_nlinear_driver(MOST_ITERATIONS, 1e-12, 1e-10, 0, NULL, NULL, &reason, work);
    /* A start that is the solution, as for linear laws, ends where no step gets any further. */
    fit->converged = status == GSL_SUCCESS || reason == GSL_ENOPROG;
    unpack(work->x, &fit->hardening);

    gsl_matrix *covariance = gsl_matrix_alloc(parameters, parameters);
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work), 0, covariance);
    double squares;
    gsl_blas_ddot(work->f, work->f, &squares);
    for (size_t k = 0; k < parameters; k++) {
        double error =
            sqrt(gsl_matrix_get(covariance, k, k) * squares / (double)(data->n - parameters));
        bool is_linear = (int)k < data->law->n_linear;
        fit->error[k] = is_linear ? error * pascals : error * fit->hardening.parameter[k];
    }
    gsl_matrix_free(covariance);
    gsl_multifit_nlinear_free(work);
}

static void judge(const struct data *data, struct law_fit *fit)
{
    double squares = 0;
    for (size_t i = 0; i < data->n; i++) {
        double difference = hardening_stress(&fit->hardening, data->p[i]) - data->stress[i];
        squares += difference * difference;
        fit->largest = fmax(fit->largest, fabs(difference));
    }
    double n = (double)data->n, mean = squares / n;
    int parameters = data->law->n_linear + data->law->n_shapes;
    fit->root_mean_square = sqrt(mean);
    fit->akaike = n * log(mean / (pascals * pascals)) + 2 * (parameters + 1);
}

struct law_fit law_fit(const struct hardening_law *law, const double p[], const double stress[],
                       long n)
{
    struct law_fit fit = {.hardening.law = law};
    struct data data = {law, p, stress, (size_t)n};
    int parameters = law->n_linear + law->n_shapes;
    for (int k = 0; k < parameters; k++) fit.hardening.parameter[k] = fit.error[k] = NAN;
    fit.count = n;
    fit.first = n > 0 ? p[0] : NAN;
    fit.last = n > 0 ? p[n - 1] : NAN;
    if (n <= parameters) return fit;

    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_vector *start = gsl_vector_calloc((size_t)parameters);
    search(&data, start);
    polish(&data, start, &fit);
    gsl_vector_free(start);
    gsl_set_error_handler(handler);
    judge(&data, &fit);
    fit.done = isfinite(fit.root_mean_square);
    return fit;
}

/* The data do not fix a parameter that is smaller than its standard error, or a shape that has left
 * the range where such laws are found; nor two terms of almost one shape, which are one. */
static bool ill_determined(const struct law_fit *fit)
{
    const struct hardening_law *law = fit->hardening.law;
    const double *value = fit->hardening.parameter, *shape = value + law->n_linear;
    for (int k = 0; k < law->n_linear + law->n_shapes; k++)
        if (fit->error[k] > fabs(value[k])) return true;
    if (law->interchangeable && fabs(log(shape[0] / shape[1])) < log(least_apart)) return true;
    for (int k = 0; k < law->n_shapes; k++)
        if (shape[k] < law->range[k].low || shape[k] > law->range[k].high) return true;
    return false;
}

const char *law_fit_flag(const struct law_fit *fit)
{
    if (!fit->done) return "too_few_points";
    if (!fit->converged) return "not_converged";
    return ill_determined(fit) ? "ill_determined" : NULL;
}

static double instability(double p, void *law)
{
    return hardening_slope(law, p) - hardening_stress(law, p);
}

double law_uniform_strain(const struct hardening *law)
{
    const double first = 1e-12, most = 10; /* power laws have no slope at zero */
    struct hardening copy = *law;
    return instability(first, &copy) > 0 ? root_between(instability, &copy, first, most) : NAN;
}
