#include "yield_point.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdbool.h>

static const double least_span =
    0.0005; /* of strain, over which the upper yield point is not exceeded */
static const double noise_widths =
    10; /* standard deviations that no two of many thousand rows are apart */
static const double hardening_width =
    0.005; /* of strain, over which the slope of work hardening is taken */
static const double most_plastic =
    0.005; /* plastic strain behind which a fall is no end of the elastic part: a serration */

/* A change of stress that counts, at a level. */
static double swing(const struct yield_record *r, double drop, double level)
{
    return fmax(drop * level, noise_widths * r->left);
}

/* Whether a row still belongs to the end of the elastic part; where the slope is not known each
 * does. */
static bool begins_to_yield(const struct yield_record *r, long row)
{
    return !(r->strain[row] - r->toe - r->smooth[row] / r->slope > most_plastic);
}

/* The first row from which the stress is not exceeded over least_span after a fall; -1. */
static long find_upper(const struct yield_record *r, double drop)
{
    const double *s = r->smooth, *e = r->strain;
    long top = 0;
    bool fallen = false;
    for (long i = 1; i < r->n; i++) {
        if (s[i] > s[top]) {
            if (fallen && e[i] - e[top] >= least_span) return top;
            top = i;
            fallen = false;
            if (!begins_to_yield(r, top)) return -1;
        }
        fallen = fallen || (s[top] > 0 && s[i] < s[top] - swing(r, drop, s[top]));
    }
    return fallen ? top : -1;
}

/* The valleys between a row and the highest one behind them, found by swings of the stress. */
struct valleys {
    long first, second_peak; /* rows; -1 where there is none */
    long peak;               /* highest row behind the first valley */
};

static struct valleys find_valleys(const struct yield_record *r, long upper, double drop)
{
    const double *s = r->smooth;
    struct valleys v = {-1, -1, -1};
    long low = upper, high = -1; /* high < 0: going down */
    for (long i = upper; i < r->n; i++) {
        if (high < 0) {
            if (s[i] < s[low]) low = i;
            if (s[i] <= s[low] + swing(r, drop, s[low])) continue;
            if (v.first < 0) v.first = low;
            high = i;
        } else {
            if (s[i] > s[high]) high = i;
            if (s[i] >= s[high] - swing(r, drop, s[high])) continue;
            if (v.second_peak < 0) v.second_peak = high;
            low = i;
            if (v.peak < 0 || s[high] > s[v.peak]) v.peak = high;
            high = -1;
        }
    }
    if (high >= 0 && (v.peak < 0 || s[high] > s[v.peak])) v.peak = high;
    return v;
}

/* Last minimum before the stress rises to the highest row: behind the last valley of a plateau
 * of waves. */
static long last_valley(const struct yield_record *r, const struct valleys *v, double drop)
{
    const double *s = r->smooth;
    long low = v->peak, found = v->peak, high = v->peak;
    for (long i = v->peak; i >= v->first; i--) {
        if (s[i] < s[low]) low = high = i;
        if (s[i] > s[high]) high = i;
        found = low;
        if (s[high] > s[low] + swing(r, drop, s[low])) break;
    }
    return found;
}

/* Strain where the steepest line behind row low, over hardening_width, meets the stress of low. */
static double hardening_begin(const struct yield_record *r, long low, long peak)
{
    const double *e = r->strain, *s = r->smooth;
    double steepest = 0, begin = e[low];
    for (long i = low, k = low; i < peak; i++) {
        while (k < peak && (e[k] - e[i] < hardening_width || k - i < 2)) k++;
        double c0, c1, c00, c01, c11, squares;
        /* What is left before the peak is too short for a slope, but for a rise that is as
         * short. */
        const bool whole = e[k] - e[i] >= hardening_width && k - i >= 2;
        if (!(e[k] > e[i]) || (i > low && !whole)) continue;
        gsl_fit_linear(e + i, 1, s + i, 1, (size_t)(k - i + 1), &c0, &c1, &c00, &c01, &c11,
                       &squares);
        if (!(c1 > steepest)) continue;
        steepest = c1;
        begin = fmax(e[low], (s[low] - c0) / c1);
    }
    return begin;
}

static long argument(const double values[], long first, long last, double sign)
{
    long best = first;
    for (long i = first; i <= last; i++)
        if (sign * values[i] > sign * values[best]) best = i;
    return best;
}

struct yield_point yield_point_find(const struct yield_record *r, double drop)
{
    struct yield_point found = {NAN, NAN, NAN, -1, -1};
    const long top = find_upper(r, drop);
    if (top < 0) return found;
    const struct valleys v = find_valleys(r, top, drop);
    if (v.first < 0 || v.peak < 0) return found;
    long first = top, last = top;
    while (first > 0 && r->strain[top] - r->strain[first - 1] <= r->width / 2) first--;
    while (last < r->n - 1 && r->strain[last + 1] - r->strain[top] <= r->width / 2) last++;
    found.row = argument(r->stress, first, last, 1);
    found.upper = r->stress[found.row];
    found.end = last_valley(r, &v, drop);
    const bool waves = v.second_peak >= 0 && v.second_peak < found.end;
    found.lower = r->smooth[argument(r->smooth, waves ? v.second_peak : v.first, found.end, -1)];
    found.extension = hardening_begin(r, found.end, v.peak) - r->strain[found.row];
    return found;
}
