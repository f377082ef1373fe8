#include "waves.h"

#include "memory.h"
#include "simd.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHORT = 512 };

struct waves {
    int n;
    bool corners, low, high, periodic;
    double shift, period; /* wave number k is pi (k + shift)/period */
    double offset;        /* of the first node from the low end, sites */
    float *norm;          /* [n] 1 over the root of the sum of squares of wave k */
    int64_t inner;
    float *matrix[2];   /* [n n] [from][to], to amplitudes and back; NULL: by FFTW */
    fftwf_plan plan[2]; /* else of one [n][inner] */
};

/* What a node counts in the sums over a wave: corners at free ends a half. */
static double weight(const struct waves *waves, int j)
{
    if (waves->periodic) return 1;
    const bool end = (j == 0 && !waves->low) || (j == waves->n - 1 && !waves->high);
    return waves->corners && end ? 0.5 : 1;
}

double waves_number(const struct waves *waves, int k)
{
    if (waves->periodic) return 2 * M_PI * (2 * k <= waves->n ? k : waves->n - k) / waves->n;
    return M_PI * (k + waves->shift) / waves->period;
}

static double wave(const struct waves *waves, int k, int j)
{
    const double phase = waves_number(waves, k) * (j + waves->offset);
    if (waves->periodic) return 2 * k <= waves->n ? cos(phase) : sin(phase);
    return waves->low ? sin(phase) : cos(phase);
}

static void fill_matrices(struct waves *waves)
{
    const size_t n = (size_t)waves->n;
    for (int back = 0; back < 2; back++) waves->matrix[back] = memory_new(n * n, sizeof(float));
    for (size_t k = 0; k < n; k++)
        for (size_t j = 0; j < n; j++) {
            const double value = wave(waves, (int)k, (int)j) * waves->norm[k];
            waves->matrix[0][j * n + k] = waves->matrix[1][k * n + j] = (float)value;
        }
}

/* FFTW's names by corners, and what is held below and above, to amplitudes and back.  Estimated plans are the same each
 * time, measured ones are not. */
static void make_plans(struct waves *waves)
{
    static const fftwf_r2r_kind kinds[2][2][2][2] =
        {{{{FFTW_REDFT10, FFTW_REDFT01}, {FFTW_REDFT11, FFTW_REDFT11}},
          {{FFTW_RODFT11, FFTW_RODFT11}, {FFTW_RODFT10, FFTW_RODFT01}}},
         {{{FFTW_REDFT00, FFTW_REDFT00}, {FFTW_REDFT01, FFTW_REDFT10}},
          {{FFTW_RODFT01, FFTW_RODFT10}, {FFTW_RODFT00, FFTW_RODFT00}}}},
                                periodic[2] = {FFTW_R2HC, FFTW_HC2R};
    const int n = waves->n, inner = (int)waves->inner;
    float *values = fftwf_alloc_real((size_t)n * (size_t)inner);
    for (int back = 0; back < 2; back++)
        waves->plan[back] = fftwf_plan_many_r2r(
            1, &n, inner, values, NULL, inner, 1, values, NULL, inner, 1,
            waves->periodic ? &periodic[back]
                            : &kinds[waves->corners][waves->low][waves->high][back],
            FFTW_ESTIMATE | FFTW_UNALIGNED);
    fftwf_free(values);
}

static void finish(struct waves *waves)
{
    const int n = waves->n;
    waves->norm = memory_new((size_t)n, sizeof *waves->norm);
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int j = 0; j < n; j++) square += weight(waves, j) * pow(wave(waves, k, j), 2);
        waves->norm[k] = (float)(1 / sqrt(square));
    }
    if (n <= SHORT)
        fill_matrices(waves);
    else
        make_plans(waves);
}

struct waves *waves_new(int n, int64_t inner, bool corners, bool low, bool high)
{
    struct waves *waves = memory_new(1, sizeof *waves);
    *waves = (struct waves){.n = n, .inner = inner, .corners = corners, .low = low, .high = high};
    waves->shift = low && high ? 1 : low || high ? 0.5 : 0;
    waves->period = !corners ? n : low && high ? n + 1 : low || high ? n : n - 1;
    waves->offset = !corners ? 0.5 : low ? 1 : 0;
    finish(waves);
    return waves;
}

struct waves *waves_new_periodic(int n, int64_t inner)
{
    struct waves *waves = memory_new(1, sizeof *waves);
    *waves = (struct waves){.n = n, .inner = inner, .periodic = true};
    finish(waves);
    return waves;
}

void waves_free(struct waves *waves)
{
    if (!waves) return;
    free(waves->norm);
    for (int back = 0; back < 2; back++) {
        free(waves->matrix[back]);
        if (waves->plan[back]) fftwf_destroy_plan(waves->plan[back]);
    }
    free(waves);
}

/* out[i] = sum over j < n of factor[j factor_step] row[j row_step + i], i < m */
HS_SIMD static void combine(int64_t m, int n, const float *restrict factor, int64_t factor_step,
                            const float *restrict row, int64_t row_step, float *restrict out)
{
    int j = 0;
    for (int64_t i = 0; i < m; i++) out[i] = 0;
    for (; j + 4 <= n; j += 4) {
        const float a = factor[j * factor_step], b = factor[(j + 1) * factor_step],
                    c = factor[(j + 2) * factor_step], d = factor[(j + 3) * factor_step];
        const float *restrict p = row + j * row_step, *restrict q = p + row_step,
                              *restrict r = q + row_step, *restrict s = r + row_step;
        for (int64_t i = 0; i < m; i++) out[i] += (a * p[i] + b * q[i]) + (c * r[i] + d * s[i]);
    }
    for (; j < n; j++) {
        const float a = factor[j * factor_step], *restrict p = row + j * row_step;
        for (int64_t i = 0; i < m; i++) out[i] += a * p[i];
    }
}

static void by_matrix(const struct waves *waves, bool back, int64_t outer, const float *values,
                      float *out)
{
    const int n = waves->n;
    const int64_t inner = waves->inner;
    const float *matrix = waves->matrix[back];
    for (int64_t o = 0; o < outer; o++) {
        const float *from = values + o * n * inner;
        float *to = out + o * n * inner;
        if (inner == 1)
            combine(n, n, from, 1, matrix, n, to);
        else
            for (int k = 0; k < n; k++)
                combine(inner, n, matrix + k, n, from, inner, to + k * inner);
    }
}

static void scale(int64_t count, float factor, float *values)
{
    for (int64_t i = 0; i < count; i++) values[i] *= factor;
}

/* Whether FFTW adds number k to what a transform back sums up once, not twice: waves without a partner. */
static bool is_single(const struct waves *waves, int k)
{
    const bool cosines = !waves->low && !waves->high, sines = waves->low && waves->high;
    return (cosines && k == 0) || (k == waves->n - 1 && (waves->corners ? cosines : sines));
}

/* FFTW's sines are negative, and its transform back sums up twice what has a sine beside its cosine. */
static void by_fftw_periodic(const struct waves *waves, bool back, float *values)
{
    const int n = waves->n;
    const int64_t inner = waves->inner;
    float *factor = memory_new((size_t)n, sizeof *factor);
    for (int k = 0; k < n; k++) {
        const bool sine = 2 * k > n, single = k == 0 || 2 * k == n;
        factor[k] = (sine ? -1 : 1) * (back && !single ? 0.5f : 1) * waves->norm[k];
    }
    for (int k = 0; k < n && back; k++) scale(inner, factor[k], values + k * inner);
    fftwf_execute_r2r(waves->plan[back], values, values);
    for (int k = 0; k < n && !back; k++) scale(inner, factor[k], values + k * inner);
    free(factor);
}

/* The same by FFTW, which sums up twice what does not lie at an end of the axis or of the spectrum. */
static void by_fftw(const struct waves *waves, bool back, int64_t outer, float *values)
{
    const int n = waves->n;
    const int64_t inner = waves->inner;
    for (int64_t o = 0; waves->periodic && o < outer; o++)
        by_fftw_periodic(waves, back, values + o * n * inner);
    for (int64_t o = 0; !waves->periodic && o < outer; o++) {
        float *from = values + o * n * inner;
        for (int k = 0; k < n; k++)
            scale(inner,
                  back ? (is_single(waves, k) ? 1 : 0.5f) * waves->norm[k]
                       : (float)(1 / weight(waves, k)),
                  from + k * inner);
        fftwf_execute_r2r(waves->plan[back], from, from);
        for (int k = 0; k < n && !back; k++) scale(inner, 0.5f * waves->norm[k], from + k * inner);
    }
}

float *waves_transform(const struct waves *waves, bool back, int64_t outer, float *values,
                       float *room)
{
    if (!waves->matrix[0]) {
        by_fftw(waves, back, outer, values);
        return values;
    }
    by_matrix(waves, back, outer, values, room);
    return room;
}
