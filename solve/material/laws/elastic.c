/* elastic.c - Hencky's elasticity: linear in the logarithmic strain.
 *
 *   e = (ln F F^T)/2,  tau = 2 mu dev e + K tr(e) 1,  P = tau F^-T                     (elastic.1)
 *
 * Hencky, Z. Techn. Phys. 9 (1928) 215.  It is what j2.c answers before the first yield, to the
 * last bit, without a state: an elastic phase remembers nothing.
 *
 * In the logarithm elastic and plastic strains add up, so that an elastic phase beside a plastic
 * one has the same elastic law; in small strains it is Hooke's.  Taken by a series (logarithmic.h),
 * not by eigenvectors: equal or close principal strains need no care.  Strips with strains beyond a
 * tenth take its roots first. */
#include "logarithmic.h"

#include <math.h>

/* Whether some b of the strip is beyond what the plain series takes: |b - 1|^2 of strains of a
 * tenth. */
HS_SIMD static int64_t any_large(int count, const struct points *restrict s)
{
    int64_t any = 0;
    for (int i = 0; i < count; i++)
        any |= square_of(scaled(left_cauchy_green(deformation_gradient(s, i)), 1, -1)) > 0.04;
    return any;
}

HS_INLINE void answer(struct points *restrict s, int i, struct tensor F, struct symmetric e)
{
    const double trace = trace_of(e);
    e = scaled(e, 1, -trace / 3);
    write_stress(s, i, inverse_tensor(F), e, 2 * s->mu[i], s->bulk[i] * trace);
    const double q = 2 * s->mu[i] * sqrt(1.5 * square_of(e));
    s->stored[i] = stored_energy(q, s->mu[i], s->bulk[i], trace);
    s->dissipated[i] = s->dissipating[i] = 0;
}

HS_SIMD static void answer_all(int count, struct points *restrict s)
{
    for (int i = 0; i < count; i++) {
        const struct tensor F = deformation_gradient(s, i);
        answer(s, i, F, half_logarithm(left_cauchy_green(F)));
    }
}

HS_SIMD static void answer_large(int count, struct points *restrict s)
{
    for (int i = 0; i < count; i++) {
        const struct tensor F = deformation_gradient(s, i);
        answer(s, i, F, half_logarithm_of_large(left_cauchy_green(F)));
    }
}

static void update(const void *pairs, struct points *s, double *state, int64_t stride,
                   struct step step)
{
    (void)pairs, (void)state, (void)stride, (void)step;
    s->flows = false;
    (any_large(s->count, s) ? answer_large : answer_all)(s->count, s);
}

const struct law law_elastic = {
    .words = {.name = "elastic", .help = "linear in the logarithmic strain"},
    .flow_stress = -1,
    .update = update,
};
