#include "waves.h"

#include "memory.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>

enum { WIDTH = WAVES_WIDTH };

/* Longest axis whose matrix is looked at, and multiplications a number beyond which FFTW is faster
 * (measured: 0.011 ns each against 4 ns). */
enum { SHORT = 2048, CHEAP = 400 };

struct waves {
    int n;
    bool corners, low, high, periodic, exchanged;
    double shift, period;       /* wave number k is pi (k + shift)/period */
    double offset;              /* of the first node from the low end, sites */
    float *norm;                /* [n] 1 over the root of the sum of squares of wave k */
    struct folding *folding[2]; /* to amplitudes and back; NULL: by FFTW */
    fftwf_plan plan[2];         /* else of [n][WIDTH] */
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
    if (waves->periodic) return 2 * M_PI * (2 * k < waves->n ? k : waves->n - k) / waves->n;
    return M_PI * (k + waves->shift) / waves->period;
}

bool waves_is_sine(const struct waves *waves, int k)
{
    if (waves->periodic && waves->exchanged) return k > 0 && 2 * k <= waves->n;
    return waves->periodic ? 2 * k >= waves->n : waves->low;
}

static double wave(const struct waves *waves, int k, int j)
{
    const double phase = waves_number(waves, k) * (j + waves->offset);
    return waves_is_sine(waves, k) ? sin(phase) : cos(phase);
}

static void fold_matrices(struct waves *waves)
{
    const size_t n = (size_t)waves->n;
    double *matrix = memory_new(n * n, sizeof *matrix);
    for (int back = 0; back < 2; back++) {
        for (size_t k = 0; k < n; k++)
            for (size_t j = 0; j < n; j++)
                matrix[back ? j * n + k : k * n + j] = wave(waves, (int)k, (int)j) * waves->norm[k];
        waves->folding[back] = folding_new(waves->n, waves->n, matrix);
    }
    free(matrix);
}

static void forget_matrices(struct waves *waves)
{
    for (int back = 0; back < 2; back++) {
        folding_free(waves->folding[back]);
        waves->folding[back] = NULL;
    }
}

/* FFTW's names by corners, and what is held below and above, to amplitudes and back.  Estimated
 * plans are the same each time, measured ones are not. */
static void make_plans(struct waves *waves)
{
    static const fftwf_r2r_kind kinds[2][2][2][2] = {
        {{{FFTW_REDFT10, FFTW_REDFT01}, {FFTW_REDFT11, FFTW_REDFT11}},
         {{FFTW_RODFT11, FFTW_RODFT11}, {FFTW_RODFT10, FFTW_RODFT01}}},
        {{{FFTW_REDFT00, FFTW_REDFT00}, {FFTW_REDFT01, FFTW_REDFT10}},
         {{FFTW_RODFT01, FFTW_RODFT10}, {FFTW_RODFT00, FFTW_RODFT00}}}};
    const int n = waves->n;
    float *from = fftwf_alloc_real((size_t)n * WIDTH), *to = fftwf_alloc_real((size_t)n * WIDTH);
    for (int back = 0; back < 2; back++)
        waves->plan[back] = fftwf_plan_many_r2r(
            1, &n, WIDTH, from, NULL, WIDTH, 1, to, NULL, WIDTH, 1,
            &kinds[waves->corners][waves->low][waves->high][back], FFTW_ESTIMATE);
    fftwf_free(from);
    fftwf_free(to);
}

static void find_norms(struct waves *waves)
{
    const int n = waves->n;
    waves->norm = memory_new((size_t)n, sizeof *waves->norm);
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int j = 0; j < n; j++) square += weight(waves, j) * pow(wave(waves, k, j), 2);
        waves->norm[k] = (float)(1 / sqrt(square));
    }
}

struct waves *waves_new_periodic(int n, bool exchanged)
{
    struct waves *waves = memory_new(1, sizeof *waves);
    *waves = (struct waves){.n = n, .periodic = true, .exchanged = exchanged, .offset = 0.5};
    find_norms(waves);
    fold_matrices(waves);
    return waves;
}

struct waves *waves_new(int n, bool corners, bool low, bool high)
{
    struct waves *waves = memory_new(1, sizeof *waves);
    *waves = (struct waves){.n = n, .corners = corners, .low = low, .high = high};
    waves->shift = low && high ? 1 : low || high ? 0.5 : 0;
    waves->period = !corners ? n : low && high ? n + 1 : low || high ? n : n - 1;
    waves->offset = !corners ? 0.5 : low ? 1 : 0;
    find_norms(waves);
    if (n <= SHORT) fold_matrices(waves);
    if (n <= SHORT && folding_cost(waves->folding[0]) <= (int64_t)CHEAP * n) return waves;
    forget_matrices(waves);
    make_plans(waves);
    return waves;
}

void waves_free(struct waves *waves)
{
    if (!waves) return;
    free(waves->norm);
    forget_matrices(waves);
    for (int back = 0; back < 2; back++)
        if (waves->plan[back]) fftwf_destroy_plan(waves->plan[back]);
    free(waves);
}

static void scale(float factor, float values[WIDTH])
{
    for (int i = 0; i < WIDTH; i++) values[i] *= factor;
}

/* Whether FFTW adds number k to what a transform back sums up once, not twice: waves without a
 * partner. */
static bool is_single(const struct waves *waves, int k)
{
    const bool cosines = !waves->low && !waves->high, sines = waves->low && waves->high;
    return (cosines && k == 0) || (k == waves->n - 1 && (waves->corners ? cosines : sines));
}

/* The same by FFTW, which sums up twice what does not lie at an end of the axis or of the spectrum.
 */
static void by_fftw(const struct waves *waves, bool back, float (*values)[WIDTH],
                    float (*out)[WIDTH])
{
    for (int k = 0; k < waves->n; k++)
        scale(back ? (is_single(waves, k) ? 1 : 0.5f) * waves->norm[k]
                   : (float)(1 / weight(waves, k)),
              values[k]);
    fftwf_execute_r2r(waves->plan[back], values[0], out[0]);
    for (int k = 0; k < waves->n && !back; k++) scale(0.5f * waves->norm[k], out[k]);
}

void waves_transform(const struct waves *waves, bool back, float (*values)[WIDTH],
                     float (*out)[WIDTH])
{
    if (waves->folding[0])
        folding_multiply(waves->folding[back], values, out);
    else
        by_fftw(waves, back, values, out);
}
