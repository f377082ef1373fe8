/* maxwell.c - a Maxwell fluid in shear, elastic in volume: the deviator of the elastic strain
 * fades.
 *
 *   tau = 2 mu e + K tr 1,  de/dt = (strain rate)' - e/T;  in a step e = e_trial exp(-dt/T)
 *
 * With K and G = mu exp(-t/T) constant strain along a bar leaves the stress E exp(-t/T'), T' = T (1
 * + mu/(3 K)). */
#include "logarithmic.h"
#include "memory.h"

#include <math.h>

struct maxwell {
    double time; /* T, s */
};

static const struct key keys[] = {
    {"relaxation_time", KEY_NUMBER, offsetof(struct maxwell, time), "s", 1e-15, 1e15,
     .required = true, .help = "T, in which the elastic shear falls to 1/e"},
};

enum { DISSIPATED = SYMMETRIC };
static const struct state states[] = {
    {"inverse_viscous_metric", "1", SYMMETRIC, 1, "what has flowed, without its rotation"},
    {"viscous_work", "J/m3", 1, 0, "dissipated so far"},
};

static void *pairs(int count, const void *const first[], const void *const second[])
{
    double *time = memory_new((size_t)count, sizeof *time);
    for (int k = 0; k < count; k++)
        if (first[k])
            time[k] = 0.5 * (((const struct maxwell *)first[k])->time +
                             ((const struct maxwell *)second[k])->time);
    return time;
}

static void update(const void *times, struct points *s, double *state, int64_t stride,
                   struct step step)
{
    const double *time = times;
    s->flows = false;
    for (int i = 0; i < s->count; i++) {
        double *c[SYMMETRIC];
        for (int k = 0; k < SYMMETRIC; k++) c[k] = state + k * stride + i;
        const struct tensor F = deformation_gradient(s, i), G = inverse_tensor(F);
        const struct symmetric C = {*c[0], *c[1], *c[2], *c[3], *c[4], *c[5]},
                               all = half_logarithm(push_forward(F, C));
        const double trace = trace_of(all),
                     fades = step.frozen ? 1 : exp(-step.dt / time[s->pair[i]]);
        const struct symmetric trial = scaled(all, 1, -trace / 3), e = scaled(trial, fades, 0);
        double *dissipated = state + DISSIPATED * stride + i;
        write_stress(s, i, G, e, 2 * s->mu[i], s->bulk[i] * trace);
        s->stored[i] =
            stored_energy(2 * s->mu[i] * sqrt(1.5 * square_of(e)), s->mu[i], s->bulk[i], trace);
        s->dissipating[i] = s->mu[i] * (1 - fades * fades) * square_of(trial);
        s->dissipated[i] = *dissipated + s->dissipating[i];
        if (!step.commit) continue;
        const struct symmetric now = push_forward(G, double_exponential(scaled(e, 1, trace / 3)));
        const double kept[] = {now.xx, now.yy, now.zz, now.xy, now.yz, now.zx};
        for (int k = 0; k < SYMMETRIC; k++) *c[k] = kept[k];
        *dissipated = s->dissipated[i];
    }
}

const struct law law_maxwell = {
    .words = {"maxwell", "a Maxwell fluid in shear, elastic in volume", KEYS(keys)},
    .parameters = sizeof(struct maxwell),
    .n_states = 2,
    .states = states,
    .flow_stress = -1,
    .pairs = pairs,
    .update = update,
};
