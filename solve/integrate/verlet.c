/* verlet.c - one explicit step (verlet.h).
 *
 * Second order, one force a step, and symplectic: the error of the energy stays bounded instead of
 * adding up, which makes the balance of energies a check of the run.  Written with half kicks,
 * since velocities are known at full steps then, where energies, records and damping need them, and
 * since a bond that breaks in the middle of a step gives its first half the old force and its
 * second half the new one.  Motion is prescribed at half steps, the positions follow; so work is
 * force times the way actually gone.  The largest way goes to damage.h, which passes over bonds by
 * it. */
#include "verlet.h"

#include "balance.h"
#include "damping.h"

#include <math.h>

/* v += half_step f/rho at the strip's nodes. */
HS_SIMD static void kick(int count, const double *restrict f,
                         const double *restrict inverse_density, double half_step,
                         double *restrict v)
{
    for (int i = 0; i < count; i++) v[i] += half_step * f[i] * inverse_density[i];
}
/* v += half_step (f + b)/rho, b the force from outside. */
HS_SIMD static void kick_loaded(int count, const double *restrict f, const double *restrict b,
                                const double *restrict inverse_density, double half_step,
                                double *restrict v)
{
    for (int i = 0; i < count; i++) v[i] += half_step * (f[i] + b[i]) * inverse_density[i];
}
/* most[i] = the larger of itself and the way of node i, of which rounding hides nothing. */
HS_SIMD static void drift(int count, const double *restrict v, double dt, double *restrict u,
                          double *restrict most)
{
    for (int i = 0; i < count; i++) {
        u[i] += dt * v[i];
        double way = fabs(dt * v[i]) + 0x1p-52 * fabs(u[i]);
        most[i] = way > most[i] ? way : most[i];
    }
}

static void half_kick(const struct integration *integration, struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        const int64_t site = strip->site;
        double inverse_density[LANES];
        integration_strip_density(integration, body, strip, inverse_density);
        for (int a = 0; a < 3; a++)
            if (body->b[a])
                kick_loaded(strip->count, body->f[a] + site, body->b[a] + site, inverse_density,
                            0.5 * integration->dt, body->v[a] + site);
            else
                kick(strip->count, body->f[a] + site, inverse_density, 0.5 * integration->dt,
                     body->v[a] + site);
    }
}

/* Returns what no node has moved farther than [m]. */
static double move(const struct integration *integration, struct body *body)
{
    double most[3][LANES] = {{0}}, square = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int a = 0; a < 3; a++)
            drift(body->owned.items[s].count, body->v[a] + body->owned.items[s].site,
                  integration->dt, body->u[a] + body->owned.items[s].site, most[a]);
    for (int i = 1; i < LANES; i++)
        for (int a = 0; a < 3; a++) most[a][0] = fmax(most[a][0], most[a][i]);
    for (int a = 0; a < 3; a++) square += most[a][0] * most[a][0];
    return sqrt(square) * (1 + 0x1p-48);
}

/* dt/2 sum V v . f at owned nodes, v in the middle of the step [J]. */
static double half_step_power(const struct integration *integration, const struct body *body,
                              const struct macroscopic *macroscopic)
{
    struct exact_sum sum = integration->kinetic_zero;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            double power = 0;
            for (int a = 0; a < 3; a++) power += body->v[a][site] * body->f[a][site];
            exact_sum_add(&sum, 0.5 * integration->dt * body_volume(body, site) * power);
        }
    double value;
    exact_sum_finish(&sum, 1, &value);
    if (macroscopic) value -= 0.5 * macroscopic_step_work(macroscopic, body, integration->dt);
    return value;
}

/* Bonds break at the configuration that the force has just been found for; force and energies
 * become those of the bonds left.  The kick before had the old force, the kick to come has the new
 * one: the bonds broke in the middle of the step, and the energy of fracture is the difference of
 * the energies there, dt v/2 back. known: energy has been found with the force. */
static void break_bonds(struct integration *integration, struct body *body, struct model *model,
                        const struct macroscopic *macroscopic, bool record, bool known,
                        struct force_energy *energy)
{
    if (!integration->damage || !damage_find(integration->damage)) return;
    if (!known) {
        *energy = integration->zero;
        integration_force(integration, model, body, (struct force_mode){.energy = true}, energy);
    }
    const double before =
        integration_internal_energy(energy) + half_step_power(integration, body, macroscopic);
    damage_break(integration->damage);
    *energy = integration->zero;
    integration_force(integration, model, body,
                      (struct force_mode){.commit = true, .energy = true, .record = record},
                      energy);
    integration->balance.fracture += before - integration_internal_energy(energy) -
                                     half_step_power(integration, body, macroscopic);
}

void verlet_step(struct integration *integration, struct body *body, struct boundary *boundary,
                 struct model *model, bool energies, bool record)
{
    struct balance_sums sums = {integration->kinetic_zero, integration->kinetic_zero};
    struct force_energy energy = integration->zero;

    half_kick(integration, body);
    if (boundary->macroscopic) macroscopic_kick(boundary->macroscopic, body, 0.5 * integration->dt);
    if (damping_acts(integration))
        damping_apply(integration, body, boundary, integration->time, 0.5 * integration->dt,
                      &sums.damped);
    boundary_set_ways(boundary, body, integration->time, integration->dt);
    boundary_add_work(boundary, body, 0.5 * integration->dt, &sums.work);
    double most = move(integration, body);
    if (boundary->macroscopic) {
        macroscopic_move(boundary->macroscopic, body);
        macroscopic_drift(boundary->macroscopic, body, integration->dt);
        most = INFINITY; /* what it moves is not looked at node by node */
    }
    if (integration->damage) damage_moved(integration->damage, most);
    integration->step++;
    integration->time += integration->dt;
    integration->force_time = integration->time;

    loads_set(&boundary->loads, body, integration->time);
    integration_force(integration, model, body,
                      (struct force_mode){.commit = true, .energy = energies, .record = record},
                      &energy);
    break_bonds(integration, body, model, boundary->macroscopic, record, energies, &energy);
    if (integration->damage) damage_grow(integration->damage);
    boundary_add_work(boundary, body, 0.5 * integration->dt, &sums.work);
    half_kick(integration, body);
    if (boundary->macroscopic) macroscopic_kick(boundary->macroscopic, body, 0.5 * integration->dt);
    if (damping_acts(integration))
        damping_apply(integration, body, boundary, integration->time, 0, &sums.damped);
    boundary_set_velocities(boundary, body, integration->time, integration->dt);

    balance_step(integration, body, boundary, energies ? &energy : NULL, &sums);
}
