/* flow_curve.c - hardening laws put into tables of cubics (flow_curve.h).
 *
 * The return asks for sigma_y and its slope several times a point; powers and exponentials would
 * set its pace, and those of a library differ by the width of vectors.  Filled once, with the law's
 * own functions, a table costs a few products a look, with the same bits at any width.  The work up
 * to each cell is the integral of the very cubics, so that stored energy, plastic work and stress
 * of a point belong to one potential.  Bonds between phases have the mean law of their ends. */
#include "flow_curve.h"

#include "memory.h"

#include <math.h>

/* Left end of a cell: the inverse of flow_cell. */
static double cell_start(int cell)
{
    int64_t base, bits;
    const double reference = FLOW_REFERENCE_STRAIN;
    memcpy(&base, &reference, sizeof base);
    bits = base + ((int64_t)cell << (52 - CELLS_PER_OCTAVE_BITS));
    double shifted;
    memcpy(&shifted, &bits, sizeof shifted);
    return shifted - reference;
}

/* The slope at the end of a cell, seen from inside it: differs from the law's own where the law has
 * a kink just there. */
static double slope_before(const struct hardening *law, double start, double end)
{
    return hardening_slope(law, end - 1e-6 * (end - start));
}

/* Scales the slopes at both ends of a cell so that its cubic does not overshoot: it rises
 * throughout where they lie within a circle of three times the chord (Fritsch & Carlson, SIAM J.
 * Numer. Anal. 17 (1980) 238).  Smooth cells are far inside it. */
static void keep_rising(double chord, double *first, double *last)
{
    double most = 3 * fmax(chord, 0), size = hypot(*first, *last);
    if (!(size > most)) return;
    *first *= most / size;
    *last *= most / size;
}

static void fill_curve(double *table, const struct hardening *first, const struct hardening *second)
{
    double work = 0;
    for (int i = 0; i < FLOW_CELLS; i++) {
        double *cell = table + (size_t)i * FLOW_COEFFICIENTS, p = cell_start(i);
        double value = 0.5 * (hardening_stress(first, p) + hardening_stress(second, p));
        double slope = 0.5 * (hardening_slope(first, p) + hardening_slope(second, p));
        cell[0] = p;
        cell[1] = value;
        cell[2] = slope;
        cell[5] = work;
        if (i == FLOW_CELLS - 1) break;
        double end = cell_start(i + 1), width = end - p;
        double next = 0.5 * (hardening_stress(first, end) + hardening_stress(second, end));
        double last = 0.5 * (slope_before(first, p, end) + slope_before(second, p, end));
        double chord = (next - value) / width;
        keep_rising(chord, &slope, &last);
        cell[2] = slope;
        cell[3] = (3 * chord - 2 * slope - last) / width;
        cell[4] = (slope + last - 2 * chord) / (width * width);
        work = flow_work(cell, 0, end);
    }
}

double *flow_curves_new(int count, const struct hardening *const first[],
                        const struct hardening *const second[])
{
    const size_t stride = (size_t)FLOW_CELLS * FLOW_COEFFICIENTS;
    double *table = memory_new((size_t)count * stride, sizeof *table);
    for (int i = 0; i < count; i++) fill_curve(table + (size_t)i * stride, first[i], second[i]);
    return table;
}
