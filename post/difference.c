#include "difference.h"

#include "csv.h"
#include "die.h"

#include <math.h>

static const double default_low = 0.002; /* engineering strain behind most yield points */

static double last_strain(const struct curve *curve)
{
    double last = -INFINITY;
    for (long i = 0; i < curve->n; i++) last = fmax(last, curve->strain[i]);
    return last;
}

/* Stress where the curve first passes the strain; NAN outside. */
static double stress_at(const struct curve *curve, double strain)
{
    const double *e = curve->strain, *s = curve->stress;
    if (e[0] == strain) return s[0];
    for (long i = 1; i < curve->n; i++)
        if (e[i - 1] < strain && e[i] >= strain)
            return s[i - 1] + (strain - e[i - 1]) / (e[i] - e[i - 1]) * (s[i] - s[i - 1]);
    return NAN;
}

struct difference difference_of(const struct curve *curve, const struct curve *reference,
                                const double range[2])
{
    struct difference d = {
        .low = isnan(range[0]) ? default_low : range[0],
        .high = isnan(range[1]) ? fmin(last_strain(curve), last_strain(reference)) : range[1]};
    for (long i = 0; i < reference->n; i++) {
        double strain = reference->strain[i], stress = reference->stress[i];
        if (strain < d.low || strain > d.high || !(stress > 0)) continue;
        double relative = stress_at(curve, strain) / stress - 1;
        if (isnan(relative)) continue;
        d.count++;
        d.mean += relative;
        d.root_mean_square += relative * relative;
        if (fabs(relative) < fabs(d.largest)) continue;
        d.largest = relative;
        d.at = strain;
    }
    if (d.count == 0)
        die_user("%s and %s have no strain in common between %g and %g", curve->title,
                 reference->title, d.low, d.high);
    d.mean /= (double)d.count;
    d.root_mean_square = sqrt(d.root_mean_square / (double)d.count);
    return d;
}

void difference_write(FILE *file, const struct difference *d)
{
    const struct {
        const char *name, *unit;
        double value;
    } rows[] = {{"largest_relative_difference", "1", d->largest},
                {"strain_of_the_largest", "1", d->at},
                {"mean_relative_difference", "1", d->mean},
                {"rms_relative_difference", "1", d->root_mean_square},
                {"first_strain", "1", d->low},
                {"last_strain", "1", d->high},
                {"points", "1", (double)d->count}};
    fputs("quantity,value,unit\n", file);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        fprintf(file, "%s,", rows[i].name);
        csv_number(file, rows[i].value);
        fprintf(file, ",%s\n", rows[i].unit);
    }
}
