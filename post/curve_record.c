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
static const double least_spike = 0.02; /* of the highest stress */
static const double turned_share = 0.9; /* of steps that fall, where rows run backwards */

/* --- direction --------------------------------------------------------------------------------- */

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

void record_turn(struct curve *curve)
{
    const double *e = curve->strain, *s = curve->stress;
    const long n = curve->n;
    long falls = 0, lowest = 0, highest = 0;
    for (long i = 1; i < n; i++) {
        falls += e[i] < e[i - 1];
        if (s[i] < s[lowest]) lowest = i;
        if (s[i] > s[highest]) highest = i;
    }
    if (curve->measured && -s[lowest] > 2 * fmax(s[highest], 0) && e[lowest] < 0)
        die_user(
            "%s: the record is one of compression (stress down to %.4g MPa at strain %.3g); what "
            "is "
            "measured here is defined for tension: change the signs of both columns to see it so",
            curve->title, s[lowest] / 1e6, e[lowest]);
    if (n < FEWEST_STANDING || (double)falls < turned_share * (double)(n - 1) || e[0] <= 0 ||
        e[lowest] < 0)
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

/* What a spike is tried by: how fast the stress of a body rises at most, and the change that counts. */
struct leap {
    double slope, strain, stress; /* Pa, -, Pa */
};

/* How far the stress rises beyond what a body could between two rows. */
static double beyond(const struct leap *leap, const struct curve *curve, long from, long to)
{
    const double strain = fmax(curve->strain[to] - curve->strain[from], 0) + leap->strain;
    return curve->stress[to] - curve->stress[from] - leap->slope * strain;
}

static bool is_level(const struct leap *leap, const struct curve *curve, long from, long to)
{
    return beyond(leap, curve, from, to) <= leap->stress &&
           curve->stress[to] - curve->stress[from] >= -leap->stress;
}

/* The row behind a spike that begins at row i; i where there is none. */
static long spike_end(const struct leap *leap, const struct curve *curve, long i)
{
    long next = i + 1;
    if (is_level(leap, curve, i - 1, i)) return i;
    while (next < curve->n - 1 && next - i < MOST_OF_SPIKE && !is_level(leap, curve, i - 1, next))
        next++;
    const double most = fmax(beyond(leap, curve, i - 1, i), beyond(leap, curve, next - 1, next));
    return most > leap->stress && is_level(leap, curve, i - 1, next) ? next : i;
}

/* The stress, in which rows where it leaps as no body's can and comes back to the level before lie on the line between
 * those beside them; they are left out. */
static double *without_spikes(struct record *record, const struct curve *curve, double slope)
{
    const double *s = curve->stress, highest = gsl_stats_max(s, 1, (size_t)curve->n);
    const struct leap leap = {steepest * slope, noise_widths * record->strain_noise,
                              fmax(least_spike * highest, noise_widths * record->noise)};
    double *clean = memory_new((size_t)curve->n, sizeof *clean);
    memcpy(clean, s, (size_t)curve->n * sizeof *clean);
    for (long i = 1; curve->measured && i < curve->n - 1; i++) {
        const long next = spike_end(&leap, curve, i);
        for (long k = i; k < next; k++) {
            const double share = (double)(k - i + 1) / (double)(next - i + 1);
            clean[k] = s[i - 1] + share * (s[next] - s[i - 1]);
            record->loading[k] = false;
        }
        record->spikes += next > i;
        if (next > i) i = next - 1;
    }
    return clean;
}

/* --- excursions -------------------------------------------------------------------------------- */

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

/* Adds the excursion where the strain between its ends is no more than an elastic fall and rise would make. */
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

/* The row where the stress has fallen from its highest value since *peak, which goes there; -1: none. */
static long next_fall(const struct record *record, const struct curve *curve, long *peak)
{
    const double *s = curve->stress;
    for (long i = *peak + 1; i < curve->n; i++) {
        if (s[i] > s[*peak]) *peak = i;
        if (s[i] < s[*peak] - threshold(record, s[*peak])) return i;
    }
    return -1;
}

/* The row where most of a fall has been regained, and the lowest one before it.  -1: it falls again before, from *top, or
 * ends (*top -1). */
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

/* Where the strain is greatest between two rows: an unloading begins there, also behind maximum force. */
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

/* --- extensometer ------------------------------------------------------------------------------ */

/* The last rows in which the strain stands while the force rises or falls more than a relaxation does, or in which it
 * falls without an unloading. */
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

struct record record_judge(const struct curve *curve, double slope)
{
    const long n = curve->n;
    struct record record = {.strained = n - 1};
    record.loading = memory_new((size_t)n, sizeof *record.loading);
    for (long i = 0; i < n; i++) record.loading[i] = true;
    record.noise = noise_of(curve->strain, curve->stress, n);
    record.strain_noise = noise_of_strain(curve->strain, n);
    if (!(slope > 0)) return record;
    struct curve clean = *curve;
    clean.stress = without_spikes(&record, curve, slope);
    find_excursions(&record, &clean, slope);
    find_strained(&record, &clean, slope);
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
