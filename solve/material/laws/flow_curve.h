/* flow_curve.h - hardening laws as cubic tables that a vector loop can read.
 *
 * The cells are graded like floating-point numbers: CELLS_PER_OCTAVE cells to each doubling of
 * p + p_ref, so their width is 4e-6 at p = 0 and 1.6 % of p at large p.  The cell of p is the top
 * of the bit pattern of p + p_ref: an add, a shift, a subtraction.  In each cell the law is a cubic
 * (Hermite, exact value and slope at both ends), beyond p = 4 it goes on along its tangent.
 * Relative error against the law: below 1e-9 for the smooth laws; at the kinks of Hollomon and of
 * tabulated laws an eighth of the cell width times the change of slope; for Ludwik's infinite slope
 * at p = 0 a fifth of the stress gained in the first cell.  The tables rise wherever the laws do.
 */
#ifndef HS_FLOW_CURVE_H
#define HS_FLOW_CURVE_H

#include "hardening.h"
#include "simd.h"

#include <stdint.h>
#include <string.h>

enum {
    CELLS_PER_OCTAVE_BITS = 6,
    OCTAVES = 14,
    FLOW_CELLS = (OCTAVES << CELLS_PER_OCTAVE_BITS) + 1,
    FLOW_COEFFICIENTS = 6 /* start of the cell, a0, a1, a2, a3, plastic work up to the start */
};
#define FLOW_REFERENCE_STRAIN 0x1p-12

/* A table of count curves, [count * FLOW_CELLS * FLOW_COEFFICIENTS], curve i being the mean of the
 * laws first[i] and second[i] (the same one twice for a phase's own law).  Freed with free(). */
double *flow_curves_new(int count, const struct hardening *const first[],
                        const struct hardening *const second[]);

/* Where curve's cell of p starts in the table. */
static inline int64_t flow_cell(int64_t curve, double p)
{
    const double reference = FLOW_REFERENCE_STRAIN;
    double shifted = p + reference;
    int64_t bits, base;
    memcpy(&bits, &shifted, sizeof bits);
    memcpy(&base, &reference, sizeof base);
    int64_t cell = (bits >> (52 - CELLS_PER_OCTAVE_BITS)) - (base >> (52 - CELLS_PER_OCTAVE_BITS));
    cell = cell < FLOW_CELLS - 1 ? cell : FLOW_CELLS - 1;
    cell = cell > 0 ? cell : 0; /* a negative NaN */
    return (curve * FLOW_CELLS + cell) * FLOW_COEFFICIENTS;
}

/* At p in the cell that starts at table[cell]: flow stress, its slope [Pa], and the plastic work
 * density, the integral of sigma_y from 0 to p [J/m^3]. */
static inline double flow_stress(const double *table, int64_t cell, double p)
{
    double d = p - table[cell];
    const double chord = fused(d, fused(d, table[cell + 4], table[cell + 3]), table[cell + 2]);
    return fused(d, chord, table[cell + 1]);
}
static inline double flow_slope(const double *table, int64_t cell, double p)
{
    double d = p - table[cell];
    return fused(d, fused(3 * d, table[cell + 4], 2 * table[cell + 3]), table[cell + 2]);
}
static inline double flow_work(const double *table, int64_t cell, double p)
{
    double d = p - table[cell];
    return table[cell + 5] +
           d * (table[cell + 1] +
                d * (table[cell + 2] / 2 + d * (table[cell + 3] / 3 + d * (table[cell + 4] / 4))));
}

#endif
