#include "root.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>

enum { MOST_ITERATIONS = 200 };

static const double digits = 1e-15;

double root_between(double (*function)(double x, void *context), void *context, double low,
                    double high)
{
    gsl_function f = {function, context};
    const double at_low = function(low, context), at_high = function(high, context);
    if (at_low == 0) return low;
    if (at_high == 0) return high;
    if (!((at_low < 0 && at_high > 0) || (at_low > 0 && at_high < 0))) return NAN;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    int status = gsl_root_fsolver_set(solver, &f, low, high);
    for (int i = 0; i < MOST_ITERATIONS && status == GSL_SUCCESS; i++) {
        status = gsl_root_fsolver_iterate(solver);
        low = gsl_root_fsolver_x_lower(solver);
        high = gsl_root_fsolver_x_upper(solver);
        if (gsl_root_test_interval(low, high, 0, digits) == GSL_SUCCESS) break;
    }
    const double root = status == GSL_SUCCESS ? gsl_root_fsolver_root(solver) : NAN;
    gsl_root_fsolver_free(solver);
    gsl_set_error_handler(handler);
    return root;
}
