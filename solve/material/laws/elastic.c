/* elastic.c - Hencky's elasticity: linear in the logarithmic strain.
 *
 *   e = (ln F F^T)/2,  tau = 2 mu dev e + K tr(e) 1,  P = tau F^-T                     (elastic.1)
 *
 * Hencky, Z. Techn. Phys. 9 (1928) 215.  It is what j2.c answers before the first yield, to the last bit, without a
 * state: an elastic phase remembers nothing.
 *
 * In the logarithm elastic and plastic strains add up, so that an elastic phase beside a plastic one has the same elastic
 * law; in small strains it is Hooke's.  Taken by a series (logarithmic.h), not by eigenvectors: nothing branches, and equal or close
 * principal strains need no care. */
#include "logarithmic.h"

#include <math.h>

HS_SIMD static void stress(int count, struct points *restrict s)
{
    for (int i = 0; i < count; i++) {
        struct tensor F = deformation_gradient(s, i);
        struct symmetric e = half_logarithm(left_cauchy_green(F));
        double trace = trace_of(e);
        write_stress(s, i, inverse_tensor(F), scaled(e, 1, -trace / 3), 2 * s->mu[i],
                     s->bulk[i] * trace);
    }
}

HS_SIMD static void energy(int count, struct points *restrict s)
{
    for (int i = 0; i < count; i++) {
        struct symmetric e = half_logarithm(left_cauchy_green(deformation_gradient(s, i)));
        double trace = trace_of(e);
        double q = 2 * s->mu[i] * sqrt(1.5 * square_of(scaled(e, 1, -trace / 3)));
        s->stored[i] = stored_energy(q, s->mu[i], s->bulk[i], trace);
        s->dissipated[i] = s->dissipating[i] = 0;
    }
}

static void update(const void *pairs, struct points *s, double *state, int64_t stride,
                   struct step step)
{
    (void)pairs, (void)state, (void)stride;
    s->flows = false;
    stress(s->count, s);
    if (step.energy) energy(s->count, s);
}

const struct law law_elastic = {
    .words = {.name = "elastic", .help = "linear in the logarithmic strain"},
    .flow_stress = -1,
    .update = update,
};
