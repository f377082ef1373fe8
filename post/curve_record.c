#include "curve_record.h"

#include "die.h"
#include "memory.h"
#include "noise.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_STANDING = 5, FEWEST_UNLOADING = 4, MOST_OF_SPIKE = 3 };

static const double least_fall = 0.005; /* of the stress before it: ISO 6892-1, ReH */
static const double noise_widths =
    10; /* standard deviations that no two of many thousand rows are apart */
static const double regained = 0.75;   /* of a fall, by which the reloading has come back */
static const double elastic_spans = 3; /* strain of an excursion over that of its fall, elastic */
static const double reversal =
    0.3; /* of the elastic strain, by which the strain of a loop goes back */
static const double steepest = 2;       /* elastic slopes, by which no stress of a body rises */
static const double rounded_widths = 4; /* standard deviations: a step of rounding is 3.5 of them */
static const double least_spike = 0.02; /* of the highest stress */
static const double least_leap = 5e-4;  /* of the strain */
static const double flowing = 0.005;    /* plastic strain */
static const double turned_share = 0.9; /* of steps that fall, where rows run backwards */

/* --- direction
 * --------------------------------------------------------------------------------- */

static void turn_rows(struct table *table)
{
    for (int j = 0; j < table->n_columns; j++) {
        double *values = table->columns[j].values;
        for (long i = 0, k = table->n_rows - 1; i < k; i++, k--) {
            const double first = values[i];
            values[i] = values[k];
            values[k] = first;
        }
    }
}

/* Rows in which no test has been: of a test the strain goes a small part of its range from one
 * row to the next. */
static void refuse_disorder(const struct curve *curve)
{
    enum { FEWEST_ROWS = 20 };
    const double most_of_range = 0.1, *e = curve->strain;
    double way = 0, range = 0;
    gsl_stats_minmax(&way, &range, e, 1, (size_t)curve->n);
    range -= way;
    way = 0;
    for (long i = 1; i < curve->n; i++) way += fabs(e[i] - e[i - 1]);
    if (curve->n < FEWEST_ROWS || way <= most_of_range * (double)curve->n * range) return;
    die_user("%s: the rows are in no order: the strain goes %.3g of its range from one row to the "
             "next, on average; sort them by time, or by strain",
             curve->title, way / range / (double)curve->n);
}

/* 1, -1 or 0: to which side of zero most of it lies. */
static int side(const double values[], long n)
{
    double low, high;
    gsl_stats_minmax(&low, &high, values, 1, (size_t)n);
    return high > 2 * fmax(-low, 0) ? 1 : -low > 2 * fmax(high, 0) ? -1 : 0;
}

static void refuse_signs(const struct curve *curve)
{
    const int strain = side(curve->strain, curve->n), stress = side(curve->stress, curve->n);
    if (strain < 0 && stress < 0)
        die_user("%s: the record is one of compression (stress down to %.4g MPa, strain to %.3g); "
                 "what is measured here is defined for tension: change the signs of both columns "
                 "to see it so",
                 curve->title, gsl_stats_min(curve->stress, 1, (size_t)curve->n) / 1e6,
                 gsl_stats_min(curve->strain, 1, (size_t)curve->n));
    if (strain * stress < 0)
        die_user("%s: the %s is negative where the %s is positive: change the sign of its column",
                 curve->title, strain < 0 ? "strain" : "stress", strain < 0 ? "stress" : "strain");
}

/* Virgin yield is then one of compression, and what follows in tension is not virgin. */
static void refuse_compression_first(const struct curve *curve)
{
    const double least_share = 0.1, *e = curve->strain, *s = curve->stress;
    double low, high;
    gsl_stats_minmax(&low, &high, s, 1, (size_t)curve->n);
    long i = 0;
    while (i < curve->n - 1 && fabs(s[i]) <= least_share * fmax(high, -low)) i++;
    if (s[i] < 0 && e[i] < 0)
        die_user(
            "%s: the record begins with compression (stress down to %.4g MPa): what is measured "
            "here is defined for a test that begins with tension; hspost --columns prints what "
            "there is",
            curve->title, low / 1e6);
}

void record_turn(struct curve *curve)
{
    const double *e = curve->strain;
    const long n = curve->n;
    long falls = 0;
    if (curve->measured) refuse_signs(curve);
    if (curve->measured) refuse_disorder(curve);
    refuse_compression_first(curve);
    for (long i = 1; i < n; i++) falls += e[i] < e[i - 1];
    if (n < FEWEST_STANDING || (double)falls < turned_share * (double)(n - 1) || e[0] <= 0 ||
        gsl_stats_min(e, 1, (size_t)n) < 0)
        return;
    note("%s: the strain falls from row to row; taken from the last row to the first",
         curve->title);
    turn_rows(&curve->table);
}

/* --- leaps ---------------------------------------------------------------------------------- */

/* Fall of the stress from s that counts. */
static double threshold(const struct record *record, double s)
{
    return fmax(least_fall * fabs(s), noise_widths * record->noise);
}

/* What leaps are tried by. */
struct leap {
    double slope, toe;     /* Pa, -; of the elastic part */
    double strain, stress; /* changes that count */
    double rounded;        /* what the strain may lack, of what it has risen by */
};

/* How fast the stress may rise: where it is the highest so far and the body flows, hardly. */
static double steepest_at(const struct leap *leap, const struct curve *curve, long row, double top)
{
    const double plastic = curve->strain[row] - leap->toe - curve->stress[row] / leap->slope;
    return plastic > flowing && curve->stress[row] > top - leap->stress ? 0
                                                                        : steepest * leap->slope;
}

/* Whether row follows row from as a body's does: the stress rises no faster than it can, the
 * strain goes back by what is elastic, and neither goes back without the other. */
static bool follows(const struct leap *leap, const struct curve *curve, long from, long row,
                    double slope)
{
    const double strain = curve->strain[row] - curve->strain[from];
    const double stress = curve->stress[row] - curve->stress[from];
    return stress <= slope * fmax(strain + leap->rounded, 0) + leap->stress &&
           -strain <= steepest * fmax(-stress, 0) / leap->slope + leap->strain;
}

/* The row behind a leap that begins at row i and comes back to the level before; i where there
 * is none. */
static long leap_end(const struct leap *leap, const struct curve *curve, long i, double top)
{
    const double slope = steepest_at(leap, curve, i - 1, top), before = curve->stress[i - 1];
    bool odd = !follows(leap, curve, i - 1, i, slope);
    for (long next = i + 1; next < curve->n && next - i <= MOST_OF_SPIKE; next++) {
        odd = odd || !follows(leap, curve, next - 1, next, steepest * leap->slope);
        if (odd && follows(leap, curve, i - 1, next, slope) &&
            curve->stress[next] > before - leap->stress)
            return next;
    }
    return i;
}

/* Puts rows from i on, before row next, on the line between those beside them, in a quantity. */
static void bridge(double values[], long i, long next)
{
    for (long k = i; k < next; k++)
        values[k] = values[i - 1] + (values[next] - values[i - 1]) / (double)(next - k + 1);
}

/* A few rows where stress or strain leaps as no body's can, and comes back, are left out; curve:
 * without them. */
static void take_leaps_out(struct record *record, struct curve *curve,
                           const struct elastic_line *line)
{
    double top = gsl_stats_max(curve->stress, 1, (size_t)curve->n);
    const struct leap leap = {line->slope, line->toe,
                              fmax(least_leap, noise_widths * record->strain_noise),
                              fmax(least_spike * top, noise_widths * record->noise),
                              rounded_widths * record->strain_noise};
    top = curve->stress[0];
    for (long i = 1; curve->measured && i < curve->n - 1; i++) {
        const long next = leap_end(&leap, curve, i, top);
        bridge(curve->stress, i, next);
        bridge(curve->strain, i, next);
        for (long k = i; k < next; k++) record->loading[k] = false;
        record->spikes += next > i;
        top = fmax(top, curve->stress[i]);
    }
}

/* --- excursions
 * -------------------------------------------------------------------------------- */

static void exclude(struct record *record, long from, long to)
{
    for (long i = from; i <= to; i++) record->loading[i] = false;
}

static double least_between(const double values[], long first, long last)
{
    double least = values[first];
    for (long i = first; i <= last; i++) least = fmin(least, values[i]);
    return least;
}

/* Adds the excursion where the strain between its ends is no more than an elastic fall and rise
 * would make. */
static bool add_excursion(struct record *record, const struct curve *curve, struct excursion x,
                          double slope)
{
    const double *e = curve->strain, *s = curve->stress;
    const double fall = s[x.begin] - s[x.bottom], elastic = fall / slope;
    const double level = s[x.begin] - (1 - regained) * fall;
    const double step = s[x.end] - s[x.end - 1];
    const double crossing =
        step > 0 ? e[x.end] - (s[x.end] - level) / step * (e[x.end] - e[x.end - 1]) : e[x.end];
    if (crossing - e[x.begin] > elastic_spans * elastic + noise_widths * record->strain_noise)
        return false;
    const bool back = e[x.begin] - least_between(e, x.begin, x.end) >
                      reversal * elastic + noise_widths * record->strain_noise;
    const bool stands =
        e[x.bottom] - e[x.begin] <= elastic / 2 + noise_widths * record->strain_noise;
    x.kind = back ? EXCURSION_LOOP : stands ? EXCURSION_HOLD : EXCURSION_SERRATION;
    /* On to where the strain, or the stress, of the beginning is reached again. */
    while (x.end < curve->n - 1 && e[x.end] < e[x.begin] + (back ? 0 : 2 * elastic) &&
           (back || s[x.end] < s[x.begin]))
        x.end++;
    exclude(record, x.begin + 1, x.end - 1);
    record->excursions = memory_grow(record->excursions, record->count, sizeof x);
    record->excursions[record->count++] = x;
    return true;
}

/* A record that ends in an unloading: several rows down a slope that is about elastic. */
static void cut_unloading(struct record *record, const struct curve *curve, long peak, double slope)
{
    const double *e = curve->strain, *s = curve->stress;
    const long last = curve->n - 1;
    const double elastic = (s[peak] - s[last]) / slope, back = e[peak] - e[last];
    if (last - peak < FEWEST_UNLOADING || !(back > elastic / 2 && back < 2 * elastic)) return;
    record->unloaded = true;
    exclude(record, peak + 1, last);
}

/* The row where the stress has fallen from its highest value since *peak, which goes there; -1:
 * none. */
static long next_fall(const struct record *record, const struct curve *curve, long *peak)
{
    const double *s = curve->stress;
    for (long i = *peak + 1; i < curve->n; i++) {
        if (s[i] > s[*peak]) *peak = i;
        if (s[i] < s[*peak] - threshold(record, s[*peak])) return i;
    }
    return -1;
}

/* The row where most of a fall has been regained, and the lowest one before it.  -1: it falls
 * again before, from *top, or ends (*top -1). */
static long next_rise(const struct record *record, const struct curve *curve, long peak, long fall,
                      long *bottom, long *top)
{
    const double *s = curve->stress;
    *bottom = fall;
    *top = -1;
    for (long i = fall; i < curve->n; i++) {
        if (s[i] < s[*bottom]) *bottom = i;
        if (s[i] >= s[peak] - (1 - regained) * (s[peak] - s[*bottom])) return i;
        if (*bottom == i) *top = -1;
        if (s[i] > s[*bottom] + threshold(record, s[*bottom]) && (*top < 0 || s[i] > s[*top]))
            *top = i;
        if (*top >= 0 && s[i] < s[*top] - threshold(record, s[*top])) return -1;
    }
    *top = -1;
    return -1;
}

/* Where the strain is greatest between two rows: an unloading begins there, also behind maximum
 * force. */
static long furthest(const double strain[], long first, long last)
{
    long far = first;
    for (long i = first; i <= last; i++)
        if (strain[i] > strain[far]) far = i;
    return far;
}

static void find_excursions(struct record *record, const struct curve *curve, double slope)
{
    long peak = 0, fall;
    while ((fall = next_fall(record, curve, &peak)) >= 0) {
        long bottom, top;
        const long rise = next_rise(record, curve, peak, fall, &bottom, &top);
        const long turn = furthest(curve->strain, peak, bottom);
        if (rise < 0 && top < 0) cut_unloading(record, curve, turn, slope);
        if (rise < 0 && top < 0) break;
        const bool found =
            rise >= 0 &&
            ((curve->stress[turn] - curve->stress[bottom] >
                  threshold(record, curve->stress[turn]) &&
              add_excursion(record, curve, (struct excursion){0, turn, bottom, rise}, slope)) ||
             add_excursion(record, curve, (struct excursion){0, peak, bottom, rise}, slope));
        peak = found ? record->excursions[record->count - 1].end : rise >= 0 ? rise : top;
    }
}

/* --- fracture --------------------------------------------------------------------------------- */

/* Behind the fracture is no specimen: its rows, and excursions that begin there, are left out. */
static void cut_fracture(struct record *record, const struct curve *curve, double share)
{
    const double *s = curve->stress;
    long top = 0, row;
    for (long i = 0; i < curve->n; i++)
        if (record->loading[i] && s[i] > s[top]) top = i;
    for (row = top + 1; row < curve->n; row++)
        if (record->loading[row] && s[row] < share * s[top]) break;
    if (row >= curve->n) return;
    record->broken = true;
    exclude(record, row, curve->n - 1);
    while (record->count > 0 && record->excursions[record->count - 1].end >= row) record->count--;
}

/* --- extensometer
 * ------------------------------------------------------------------------------ */

/* The last rows in which the strain stands while the force rises or falls more than a relaxation
 * does, or in which it falls without an unloading. */
static void find_strained(struct record *record, const struct curve *curve, double slope)
{
    const double *e = curve->strain, *s = curve->stress;
    const long n = curve->n;
    const double tolerance = noise_widths * record->strain_noise + 1e-9;
    long stands = n - 1, top = 0;
    for (long i = 0; i < n; i++)
        if (record->loading[i] && e[i] > e[top]) top = i;
    while (stands > 0 && fabs(e[stands - 1] - e[n - 1]) <= tolerance) stands--;
    const double rise = gsl_stats_max(s + stands, 1, (size_t)(n - stands)) - s[stands];
    if (n - stands > FEWEST_STANDING && rise > threshold(record, s[stands]))
        record->strained = stands;
    long beyond = 0;
    for (long i = top + 1; i < n; i++)
        beyond += record->loading[i] &&
                  e[top] - e[i] > tolerance + 1e-5 + 2 * fmax(s[top] - s[i], 0) / slope;
    if (beyond > FEWEST_STANDING && top < record->strained) record->strained = top;
}

static double *copy_of(const double values[], long n)
{
    double *copy = memory_new((size_t)n, sizeof *copy);
    memcpy(copy, values, (size_t)n * sizeof *copy);
    return copy;
}

struct record record_judge(const struct curve *curve, const struct elastic_line *line,
                           double fracture_share)
{
    const long n = curve->n;
    struct record record = {.strained = n - 1};
    record.loading = memory_new((size_t)n, sizeof *record.loading);
    for (long i = 0; i < n; i++) record.loading[i] = true;
    record.noise = noise_of(curve->strain, curve->stress, n);
    record.strain_noise = noise_of_strain(curve->strain, n, line->first, line->count);
    if (!(line->slope > 0)) {
        cut_fracture(&record, curve, fracture_share);
        return record;
    }
    struct curve clean = *curve;
    clean.strain = copy_of(curve->strain, n);
    clean.stress = copy_of(curve->stress, n);
    take_leaps_out(&record, &clean, line);
    find_excursions(&record, &clean, line->slope);
    cut_fracture(&record, &clean, fracture_share);
    find_strained(&record, &clean, line->slope);
    free(clean.strain);
    free(clean.stress);
    return record;
}

void record_free(struct record *record)
{
    free(record->loading);
    free(record->excursions);
    *record = (struct record){0};
}

long record_count(const struct record *record, enum excursion_kind kind)
{
    long count = 0;
    for (long i = 0; i < record->count; i++) count += record->excursions[i].kind == kind;
    return count;
}

struct curve record_envelope(const struct record *record, const struct curve *curve, long **rows)
{
    long n = 0;
    *rows = memory_new((size_t)curve->n, sizeof **rows);
    for (long i = 0; i < curve->n; i++)
        if (record->loading[i]) (*rows)[n++] = i;
    return curve_rows(curve, n, *rows);
}
