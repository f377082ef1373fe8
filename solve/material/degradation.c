/* degradation.c - stress and energies of degraded points (degradation.h).
 *
 * Wrapped around the answer of any law instead of written into one: laws go on with the sound
 * material's stress and state.  What a growing D releases is booked when a state is accepted, by
 * the trapezoidal rule, so that energy, plastic work and the work of the forces balance to second
 * order of the step; forces that are only tried read the books alone. */
#include "degradation.h"

#include "memory.h"

double *degradation_new(const struct strips *strips)
{
    double *record = memory_new((size_t)strips->points * DEGRADATION, sizeof *record);
    for (int64_t s = 0; s < strips->count; s++)
        for (int i = 0; i < strips->items[s].stride; i++)
            record[DEGRADATION * strips->items[s].store + i] = 1; /* LAST_INTEGRITY */
    return record;
}

/* (degradation.2) over a step.  The first loss is a small one, and nothing may depend on what was
 * noted of sound points. */
HS_SIMD static void book(int count, const double *restrict integrity,
                         const double *restrict dissipating, const double *restrict stored,
                         double *restrict last, double *restrict before, double *restrict withheld)
{
    for (int i = 0; i < count; i++) {
        const double mean = 0.5 * (before[i] + stored[i]);
        const double energy = last[i] < 1 ? mean : stored[i];
        withheld[i] += (1 - 0.5 * (last[i] + integrity[i])) * dissipating[i] +
                       energy * (integrity[i] - last[i]);
        last[i] = integrity[i];
        before[i] = stored[i];
    }
}

void degradation_book(int count, const double *integrity, const double *dissipating,
                      const double *stored, double *record, int64_t stride)
{
    book(count, integrity, dissipating, stored, record + LAST_INTEGRITY * stride,
         record + LAST_STORED * stride, record + WITHHELD * stride);
}

/* (degradation.1) */
HS_SIMD static void scale(int count, const double *restrict integrity,
                          const double *restrict withheld, struct points *restrict s)
{
    for (int k = 0; k < TENSOR; k++)
        for (int i = 0; i < count; i++) s->P[k][i] *= integrity[i];
    for (int i = 0; i < count; i++) {
        s->stored[i] *= integrity[i];
        s->dissipated[i] -= withheld[i];
    }
}

void degradation_apply(struct points *points, bool commit, const double *integrity, double *record,
                       int64_t stride)
{
    if (commit)
        degradation_book(points->count, integrity, points->dissipating, points->stored, record,
                         stride);
    scale(points->count, integrity, record + WITHHELD * stride, points);
}
