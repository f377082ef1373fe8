#include "strength.h"

#include "die.h"
#include "noise.h"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

const double strength_plateau_share = 1e-4;

enum { MOST_ITERATIONS = 50, FEWEST_POINTS = 3, FEWEST_OF_BEND = 10 };

const double straight_limit = 0.995;

static const double plateau_widths = 3;      /* standard deviations of the noise */
static const double proof_offset = 0.002;    /* of Rp0.2 */
static const double bend_share = 2;          /* of the squares that are left by a cubic */
static const double straight_share = 0.01;   /* of the stress, off the line */
static const double first_guess_share = 0.5; /* of Rm, for Rp0.2 */
static const double knee = 1.1;              /* of the slope behind: much steeper */
static const double still_share = 0.01;      /* kinetic energy over the internal one */
static const double default_shares[2] = {0.1, 0.4};

/* Least squares of s on e; where the strain is the noisier of the two, of e on s: what is noisy
 * would make the slope on it too small. */
static struct elastic_line fit_rows(const struct curve *curve, long first, long last)
{
    struct elastic_line line = {.first = first, .last = last, .count = last - first + 1};
    size_t n = (size_t)line.count;
    const double *e = curve->strain + first, *s = curve->stress + first;
    const double *x = curve->strain_is_noisier ? s : e, *y = curve->strain_is_noisier ? e : s;
    double intercept, c00, c01, c11, residual;
    gsl_fit_linear(x, 1, y, 1, n, &intercept, &line.slope, &c00, &c01, &c11, &residual);
    line.error = n > 2 ? sqrt(c11) : NAN;
    line.toe = -intercept / line.slope;
    line.r_squared = 1 - residual / gsl_stats_tss(y, 1, n);
    if (!curve->strain_is_noisier) return line;
    line.error /= line.slope * line.slope;
    line.slope = 1 / line.slope;
    line.toe = intercept;
    return line;
}

static double highest(const struct curve *curve)
{
    return gsl_stats_max(curve->stress, 1, (size_t)curve->n);
}

static bool usable(const struct elastic_line *line)
{
    return line->slope > 0 && isfinite(line->slope) && isfinite(line->toe);
}

/* Rows of the rising part between two stresses; *first > *last where there are none. */
static void rows_between(const struct curve *curve, double low, double high, long *first,
                         long *last)
{
    long end = 0;
    while (end < curve->n && curve->stress[end] <= high) end++;
    *last = end - 1;
    *first = 0;
    while (*first < end && curve->stress[*first] < low) (*first)++;
}

/* A line that is not fitted here. */
static struct elastic_line given_line(double slope, double toe, const char *flag)
{
    return (struct elastic_line){.slope = slope,
                                 .error = NAN,
                                 .toe = toe,
                                 .r_squared = NAN,
                                 .first = -1,
                                 .last = -1,
                                 .flag = isnan(slope) ? "no_elastic_part" : flag};
}

/* Fit between shares of Rp0.2, found by iteration; slope = NAN where there are too few points. */
static struct elastic_line iterate(const struct curve *curve, const double shares[2])
{
    double proof = first_guess_share * highest(curve);
    struct elastic_line line = {.slope = NAN, .first = -1};
    for (int i = 0; i < MOST_ITERATIONS; i++) {
        long first, last;
        rows_between(curve, shares[0] * proof, shares[1] * proof, &first, &last);
        if (last - first + 1 < FEWEST_POINTS) return given_line(NAN, NAN, NULL);
        struct elastic_line next = fit_rows(curve, first, last);
        if (!usable(&next)) return given_line(NAN, NAN, NULL);
        bool settled = next.first == line.first && next.last == line.last;
        line = next;
        proof = strength_proof(curve, &line, proof_offset);
        if (settled) break;
        /* A curve that ends before 0.2 % offset is elastic to its last point. */
        if (isnan(proof)) proof = highest(curve);
    }
    return line;
}

/* Whether rows lie off their line by a bend, not by noise: a cubic takes most of it. */
static bool is_bent(const struct curve *curve, const struct elastic_line *line)
{
    const double *e = curve->strain + line->first, *s = curve->stress + line->first;
    if (line->count < FEWEST_OF_BEND || line->r_squared >= straight_limit) return false;
    const double squares = (1 - line->r_squared) * gsl_stats_tss(s, 1, (size_t)line->count);
    return squares / (double)(line->count - 2) >
           bend_share * pow(noise_about_cubic(e, s, line->count), 2);
}

/* Behind a bent toe: of parts of the rise, three tenths of Rp0.2 each, the one that is surely
 * the steepest. */
static struct elastic_line behind_toe(const struct curve *curve, struct elastic_line bent)
{
    struct elastic_line best = bent;
    double most = bent.slope;
    for (int round = 0; round < 2; round++) {
        double proof = strength_proof(curve, &best, proof_offset);
        if (isnan(proof)) proof = highest(curve);
        for (double low = 0.1; low < 0.7; low += 0.05) {
            long first, last;
            rows_between(curve, low * proof, (low + 0.3) * proof, &first, &last);
            if (last - first + 1 < FEWEST_OF_BEND / 2) continue;
            const struct elastic_line part = fit_rows(curve, first, last);
            if (!usable(&part) || part.slope - 2 * part.error <= most) continue;
            most = part.slope - 2 * part.error;
            best = part;
            best.flag = "steepest_part";
        }
    }
    return best;
}

/* From the first row as far as the rows lie on a line, two at least. */
static struct elastic_line straight_start(const struct curve *curve)
{
    struct elastic_line line = {.slope = NAN};
    for (long last = 1; last < curve->n; last++) {
        struct elastic_line longer = fit_rows(curve, 0, last);
        const double off = curve->stress[last] - longer.slope * (curve->strain[last] - longer.toe);
        if (!usable(&longer) || fabs(off) > straight_share * curve->stress[last]) break;
        line = longer;
        line.flag = "few_points";
    }
    return usable(&line) ? line : given_line(NAN, NAN, NULL);
}

/* Where a phase yields long before the others the shares of Rp0.2 lie behind that.  Of what is
 * found to lie before it the end is left out, where the kink may be. */
static struct elastic_line but_for_its_end(const struct curve *curve, struct elastic_line line)
{
    const double share = 0.8; /* of its stress */
    const double low = curve->stress[line.first], high = curve->stress[line.last];
    long first, last;
    rows_between(curve, low, low + share * (high - low), &first, &last);
    if (last - first + 1 >= FEWEST_POINTS) line = fit_rows(curve, first, last);
    line.flag = "straight_start";
    return line;
}

/* Of a curve without noise, and without waves, the straight start, where that is much steeper. */
static struct elastic_line straight_before(const struct curve *curve, struct elastic_line line)
{
    const double *kinetic = table_find(&curve->table, "kinetic_to_internal");
    const struct elastic_line start = straight_start(curve);
    if (start.count < FEWEST_OF_BEND / 2 || start.slope - 3 * start.error < knee * line.slope)
        return line;
    for (long i = 1; kinetic && i <= start.last; i++)
        if (kinetic[i] > still_share) return line;
    return but_for_its_end(curve, start);
}

/* Of a measured one the lower half, as often as that is surely much steeper than the upper one. */
static struct elastic_line steeper_half(const struct curve *curve, struct elastic_line line)
{
    bool found = false;
    for (;; found = true) {
        const double low = curve->stress[line.first], high = curve->stress[line.last];
        long first, last;
        rows_between(curve, low, (low + high) / 2, &first, &last);
        if (last - first + 1 < FEWEST_OF_BEND / 2 || line.last - last < FEWEST_OF_BEND / 2) break;
        const struct elastic_line lower = fit_rows(curve, first, last),
                                  upper = fit_rows(curve, last + 1, line.last);
        if (!usable(&lower) ||
            !(lower.slope - 3 * lower.error > knee * (upper.slope + 3 * upper.error)))
            break;
        line = lower;
    }
    return found ? but_for_its_end(curve, line) : line;
}

/* By shares of Rp0.2; where records are too far apart for that, the modulus that is known, and
 * where none is, the points from the first one on. */
static struct elastic_line find_by_shares(const struct curve *curve, const struct choices *choices)
{
    const double *shares =
        isnan(choices->modulus_range[0]) ? default_shares : choices->modulus_range;
    double known = isnan(choices->modulus) ? curve->youngs_modulus : choices->modulus;
    struct elastic_line line = iterate(curve, shares);
    const bool chosen = !isnan(choices->modulus_range[0]);
    if (usable(&line) && !chosen) {
        line = curve->measured ? steeper_half(curve, line) : straight_before(curve, line);
        if (curve->measured && is_bent(curve, &line)) return behind_toe(curve, line);
    }
    if (usable(&line)) return line;
    if (known > 0) return given_line(known, 0, "slope_not_measured");
    return straight_start(curve);
}

static struct elastic_line fit_given_rows(const struct curve *curve, const double rows[2])
{
    if (rows[1] > (double)curve->n)
        die_user("modulus_rows: row %g of a curve of %ld", rows[1], curve->n);
    struct elastic_line line = fit_rows(curve, (long)rows[0] - 1, (long)rows[1] - 1);
    if (!usable(&line))
        die_user("modulus_rows: no rising line through rows %g to %g", rows[0], rows[1]);
    return line;
}

static struct elastic_line find_line(const struct curve *curve, const struct choices *choices)
{
    if (!isnan(choices->modulus_rows[0])) return fit_given_rows(curve, choices->modulus_rows);
    double slope = attributes_number(&curve->provenance, "slope_Pa", NAN);
    double toe = attributes_number(&curve->provenance, "toe_strain", 0);
    if (isnan(choices->modulus_range[0]) && slope > 0)
        return given_line(slope, toe, "slope_from_file");
    return find_by_shares(curve, choices);
}

struct elastic_line strength_line(const struct curve *curve, const struct choices *choices)
{
    struct elastic_line line = find_line(curve, choices);
    if (isnan(choices->toe)) return line;
    const double reach = curve->strain[gsl_stats_max_index(curve->stress, 1, (size_t)curve->n)];
    if (fabs(choices->toe) >= reach)
        die_user("%s: the strain %g of the toe, which is a pure number, is as large as that of the "
                 "highest stress, %.3g",
                 curve->title, choices->toe, reach);
    line.toe = choices->toe;
    return line;
}

/* Whether the curve passes a stress before row i because the specimen breaks, over several rows: it
 * falls faster than an elastic body unloads, and nothing behind carries that stress again. */
static bool breaks(const struct curve *curve, const struct elastic_line *line, long i,
                   double stress)
{
    const double *s = curve->stress + i, *e = curve->strain + i;
    if (!(s[-1] - s[0] > line->slope * fabs(e[0] - e[-1]))) return false;
    for (long k = i; k < curve->n; k++)
        if (curve->stress[k] > stress) return false;
    return true;
}

double strength_proof(const struct curve *curve, const struct elastic_line *line, double offset)
{
    double before = NAN;
    for (long i = 0; i < curve->n; i++) {
        double above = curve->stress[i] - line->slope * (curve->strain[i] - line->toe - offset);
        if (before > 0 && above <= 0) {
            double share = before / (before - above);
            const double stress =
                curve->stress[i - 1] + share * (curve->stress[i] - curve->stress[i - 1]);
            return breaks(curve, line, i, stress) ? NAN : stress;
        }
        before = above;
    }
    return NAN;
}

double strength_total(const struct curve *curve, const struct elastic_line *line, double extension)
{
    const double strain = extension + (isnan(line->toe) ? 0 : line->toe);
    for (long i = 1; i < curve->n; i++) {
        const double *e = curve->strain + i, *s = curve->stress + i;
        if (!(e[-1] < strain && e[0] >= strain)) continue;
        const double stress = s[-1] + (strain - e[-1]) / (e[0] - e[-1]) * (s[0] - s[-1]);
        return breaks(curve, line, i, stress) ? NAN : stress;
    }
    return NAN;
}

struct strength_maximum strength_maximum(const struct curve *curve, const double smooth[],
                                         double noise, long first, bool broken)
{
    const double *s = curve->stress, *e = curve->strain;
    long row = first, top = first;
    for (long i = first + 1; i < curve->n; i++) {
        if (s[i] > s[row]) row = i;
        if (smooth[i] > smooth[top]) top = i;
    }
    struct strength_maximum maximum = {row, s[row], e[row], 0, broken || row < curve->n - 1};
    if (!maximum.reached) return maximum;
    long from = top, to = top;
    const double level =
        smooth[top] - fmax(strength_plateau_share * smooth[top], plateau_widths * noise);
    while (from > first && smooth[from - 1] >= level) from--;
    while (to < curve->n - 1 && smooth[to + 1] >= level) to++;
    maximum.strain = (e[from] + e[to]) / 2;
    maximum.plateau = e[to] - e[from];
    return maximum;
}

double strength_energy(const struct curve *curve, const struct elastic_line *line, long last)
{
    const double *s = curve->stress, *e = curve->strain;
    double toe = isnan(line->slope) ? 0 : line->toe, energy = 0;
    long i = 0;
    while (i < last && e[i] < toe) i++;
    energy = s[i] * (e[i] - toe) / 2;
    for (i++; i <= last; i++) energy += (s[i] + s[i - 1]) / 2 * (e[i] - e[i - 1]);
    return energy;
}

void strength_correct(struct curve *curve, const struct elastic_line *line, double modulus)
{
    if (line->count == 0)
        die_user("%s: true_modulus needs a measured slope to replace; give --modulus-rows",
                 curve->title);
    for (long i = 0; i < curve->n; i++) {
        double plastic = curve->strain[i] - line->toe - curve->stress[i] / line->slope;
        curve->strain[i] = plastic + curve->stress[i] / modulus;
    }
}
