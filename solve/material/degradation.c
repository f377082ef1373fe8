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
static void flow_works(const struct j2_strip *s, const double *p, const double *table, double *work)
{
    for (int i = 0; i < s->count; i++)
        work[i] = flow_work(table, flow_cell(s->curve[i], p[i]), p[i]) + s->shift[i] * p[i];
}

/* (degradation.2) over a step. */
void degradation_book(int count, const double *left, const double *work, const double *plastic,
                      const double *stored, double *record, int64_t stride)
{
    for (int i = 0; i < count; i++) {
        double *last = record + i + LAST_INTEGRITY * stride,
               *before = record + i + LAST_STORED * stride;
        /* The first loss is a small one, and nothing may depend on what was noted of sound points. */
        const double energy = *last < 1 ? 0.5 * (*before + stored[i]) : stored[i];
        record[i + WITHHELD * stride] +=
            (1 - 0.5 * (*last + left[i])) * (plastic[i] - work[i]) + energy * (left[i] - *last);
        *last = left[i];
        *before = stored[i];
    }
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
    if (mode.commit) flow_works(s, state + (J2_STATE - 1) * stride, table, work);
    mode.energy = true;
    j2_update(s, state, stride, table, mode);
    if (mode.commit) degradation_book(s->count, left, work, s->plastic, s->stored, record, stride);
    scale(s->count, left, record + WITHHELD * stride, s);
}
