#include "degradation.h"

#include "flow_curve.h"
#include "memory.h"

double *degradation_new(const struct strips *strips)
{
    double *record = memory_new((size_t)strips->points * DEGRADATION, sizeof *record);
    for (int64_t s = 0; s < strips->count; s++)
        for (int i = 0; i < strips->items[s].stride; i++)
            record[DEGRADATION * strips->items[s].store + i] = 1; /* LAST_INTEGRITY */
    return record;
}

/* Plastic work of the sound material up to p, as in j2.c. */
HS_SIMD static void flow_works(int count, const struct j2_strip *restrict s,
                               const double *restrict p, const double *restrict table,
                               double *restrict work)
{
    for (int i = 0; i < count; i++)
        work[i] = flow_work(table, flow_cell(s->curve[i], p[i]), p[i]) + s->shift[i] * p[i];
}

/* (degradation.2) over a step.  The first loss is a small one, and nothing may depend on what was noted of sound
 * points. */
HS_SIMD static void book(int count, const double *restrict left, const double *restrict work,
                         const double *restrict plastic, const double *restrict stored,
                         double *restrict last, double *restrict before, double *restrict withheld)
{
    for (int i = 0; i < count; i++) {
        const double mean = 0.5 * (before[i] + stored[i]);
        const double energy = last[i] < 1 ? mean : stored[i];
        withheld[i] +=
            (1 - 0.5 * (last[i] + left[i])) * (plastic[i] - work[i]) + energy * (left[i] - last[i]);
        last[i] = left[i];
        before[i] = stored[i];
    }
}

void degradation_book(int count, const double *left, const double *work, const double *plastic,
                      const double *stored, double *record, int64_t stride)
{
    book(count, left, work, plastic, stored, record + LAST_INTEGRITY * stride,
         record + LAST_STORED * stride, record + WITHHELD * stride);
}

/* (degradation.1) */
HS_SIMD static void scale(int count, const double *restrict left, const double *restrict withheld,
                          struct j2_strip *restrict s)
{
    for (int k = 0; k < TENSOR; k++)
        for (int i = 0; i < count; i++) s->P[k][i] *= left[i];
    for (int i = 0; i < count; i++) {
        s->stored[i] *= left[i];
        s->plastic[i] -= withheld[i];
    }
}

void degradation_update(struct j2_strip *s, double *state, int64_t stride, const double *table,
                        struct j2_mode mode, const double *left, double *record)
{
    double work[LANES];
    if (!left) {
        j2_update(s, state, stride, table, mode);
        return;
    }
    if (mode.commit) flow_works(s->count, s, state + J2_PLASTIC * stride, table, work);
    mode.energy = true;
    j2_update(s, state, stride, table, mode);
    if (mode.commit) degradation_book(s->count, left, work, s->plastic, s->stored, record, stride);
    scale(s->count, left, record + WITHHELD * stride, s);
}
