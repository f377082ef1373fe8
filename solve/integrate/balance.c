#include "balance.h"

#include "damping.h"
#include "memory.h"
#include "profile.h"
#include "simd.h"

#include <math.h>
#include <stdlib.h>

/* Sums in the message of a step; the reactions follow. */
enum { DAMPED, WORK, HELD, KINETIC, STAGGERED, STORED, PLASTIC, STABILISATION, LOADED, WISHED };
enum { SUMS = WISHED + WISHES };

HS_SIMD static void speed_squared(int count, const double *restrict x, const double *restrict y,
                                  const double *restrict z, const double *restrict inverse_density,
                                  double *restrict out)
{
    for (int i = 0; i < count; i++)
        out[i] = (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]) / inverse_density[i];
}

static void sum_kinetic(const struct integration *integration, const struct body *body,
                        const struct boundary *boundary, struct exact_sum *kinetic)
{
    if (body->ranks.rank == 0 && integration->moving && boundary->macroscopic)
        exact_sum_add(kinetic, macroscopic_kinetic(boundary->macroscopic, body));
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        double inverse_density[LANES], terms[LANES];
        integration_strip_density(integration, body, strip, inverse_density);
        speed_squared(strip->count, body->v[0] + strip->site, body->v[1] + strip->site,
                      body->v[2] + strip->site, inverse_density, terms);
        body_times_volume(body, strip->site, strip->count, terms);
        exact_sum_add_strip(kinetic, strip->count, terms, 0.5);
    }
}

/* Velocities half a step before and behind differ by dt a: the product of both is v^2 - (dt a/2)^2
 * (balance.1).  Of components that are free, as the others do not follow their force. */
static void sum_staggered(const struct integration *integration, const struct body *body,
                          const struct boundary *boundary, struct exact_sum *staggered)
{
    const double factor = -0.125 * integration->dt * integration->dt;
    if (!integration->moving) return;
    if (boundary->macroscopic && body->ranks.rank == 0)
        exact_sum_add(staggered,
                      macroscopic_staggered(boundary->macroscopic, body, integration->dt));
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        double inverse_density[LANES], terms[LANES] = {0};
        integration_strip_density(integration, body, strip, inverse_density);
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < strip->count; i++) {
                const int64_t site = strip->site + i;
                if (boundary->held && (boundary->held[site] >> a & 1)) continue;
                const double force = body->f[a][site] + (body->b[a] ? body->b[a][site] : 0);
                terms[i] += force * force * inverse_density[i];
            }
        body_times_volume(body, strip->site, strip->count, terms);
        exact_sum_add_strip(staggered, strip->count, terms, factor);
    }
}

double balance_staggered(const struct integration *integration, const struct body *body,
                         const struct boundary *boundary)
{
    struct exact_sum sum = integration->kinetic_zero;
    double value;
    sum_staggered(integration, body, boundary, &sum);
    exact_sum_finish(&sum, 1, &value);
    return value;
}

void balance_set_step(struct integration *integration, const struct body *body,
                      const struct boundary *boundary, double dt)
{
    const double before = integration->dt;
    if (dt == before) return;
    integration->dt = dt;
    if (!integration->moving) return;
    const double staggered = balance_staggered(integration, body, boundary);
    balance_shift(&integration->balance, staggered * (1 - (before / dt) * (before / dt)));
}

void balance_shift(struct energy_balance *balance, double change)
{
    balance->staggered += change;
    balance->initial += change;
}

/* Kinetic energy of the prescribed components of sets whose motion depends on place. */
static void sum_held(const struct integration *integration, const struct body *body,
                     const struct boundary *boundary, struct exact_sum *held)
{
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        const double *v = body->v[set->direction];
        for (int64_t i = 0; set->place[0] && i < set->members.count; i++) {
            const int64_t site = set->members.sites[i];
            exact_sum_add(held,
                          0.5 * integration_node_mass(integration, body, site) * v[site] * v[site]);
        }
    }
}

/* Kinetic energy that the loads would give to nodes at rest, if nothing else pulled, in so many
 * steps. */
static void sum_loaded(const struct integration *integration, const struct body *body,
                       struct exact_sum *loaded)
{
    enum { STEPS = 32 };
    const double time = STEPS * integration->dt;
    if (!body->b[0] && !body->b[1] && !body->b[2]) return;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            const double volume = body_volume(body, site),
                         mass = integration_node_mass(integration, body, site);
            for (int a = 0; a < 3; a++) {
                if (!body->b[a]) continue;
                const double impulse = body->b[a][site] * volume * time;
                exact_sum_add(loaded, 0.5 * impulse * impulse / mass);
            }
        }
}

void balance_masses(const struct integration *integration, const struct body *body,
                    struct boundary *boundary)
{
    if (boundary->macroscopic)
        macroscopic_weigh(boundary->macroscopic, body, integration->inverse_density);
    struct exact_sum *sums = memory_new((size_t)boundary->count, sizeof *sums);
    double *masses = memory_new((size_t)boundary->count, sizeof *masses);
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        sums[b] = integration->kinetic_zero;
        for (int64_t i = 0; i < set->members.count; i++)
            exact_sum_add(&sums[b],
                          integration_node_mass(integration, body, set->members.sites[i]));
    }
    exact_sum_finish(sums, boundary->count, masses);
    for (int b = 0; b < boundary->count; b++) boundary->sets[b].mass = masses[b];
    free(sums);
    free(masses);
}

static double body_mass(const struct integration *integration, const struct body *body)
{
    return body->volume * (double)body->n_nodes / integration->inverse_density[0];
}

/* m (v_right - v_left)^2/24: a bar stretched uniformly about its middle at the grips' full speed.
 */
static double affine_energy(const struct integration *integration, const struct body *body,
                            const struct boundary *boundary)
{
    if (!boundary_has_grips(boundary)) return 0;
    const double length =
        boundary->sets[boundary->right].inner - boundary->sets[boundary->left].inner;
    const double speed = boundary_full_strain_rate(boundary) * length;
    return body_mass(integration, body) * speed * speed / 24;
}

/* Kinetic energy of a body stretched uniformly about its middle, by held sets that move at their
 * speeds of now. */
static double set_energy(const struct integration *integration, const struct body *body,
                         const struct boundary *boundary)
{
    double kinetic = integration->held, mass = 0;
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        mass += set->mass;
        if (!set->place[0]) kinetic += 0.5 * set->mass * set->speed * set->speed;
    }
    return mass > 0 ? body_mass(integration, body) * 2 * kinetic / mass / 24 : 0;
}

static void finish(struct integration *integration, const struct body *body,
                   struct boundary *boundary, const struct force_energy *energy,
                   const struct balance_sums *known, double values[SUMS])
{
    const int count = SUMS + boundary->count;
    struct exact_sum *sums = memory_new((size_t)count, sizeof *sums);
    double *all = memory_new((size_t)count, sizeof *all);
    for (int k = 0; k < SUMS; k++) sums[k] = integration->kinetic_zero;
    sums[DAMPED] = known->damped;
    sums[WORK] = known->work;
    sum_held(integration, body, boundary, &sums[HELD]);
    if (energy) {
        sum_kinetic(integration, body, boundary, &sums[KINETIC]);
        sum_staggered(integration, body, boundary, &sums[STAGGERED]);
        sums[STORED] = energy->stored;
        sums[PLASTIC] = energy->plastic;
        sums[STABILISATION] = energy->stabilisation;
        sum_loaded(integration, body, &sums[LOADED]);
    }
    for (int k = 0; k < WISHES; k++)
        sums[WISHED + k] = (struct exact_sum){.top = integration->wish[k]};
    boundary_reactions(boundary, body, sums + SUMS);
    exact_sum_finish(sums, count, all);
    for (int k = 0; k < SUMS; k++) values[k] = all[k];
    for (int k = 0; k < WISHES; k++) integration->granted[k] = all[WISHED + k];
    for (int b = 0; b < boundary->count; b++) {
        boundary->sets[b].reaction_before = boundary->sets[b].reaction;
        boundary->sets[b].reaction = all[SUMS + b];
    }
    free(sums);
    free(all);
}

/* What the sums of the balance may have lost [J], each of its terms the same at most (exact_sum.h):
 * of the energies of nodes and particles, now and at the start, and of work and damping in both
 * halves of every step.  Loads that begin smoothly stay below that for a while. */
static double lost_in_sums(const struct integration *integration, const struct body *body,
                           const struct boundary *boundary)
{
    enum { ENERGIES = STABILISATION - HELD + 1, TIMES = 2, HALVES = 2, AXES = 3 };
    const double nodes = (double)body->n_nodes;
    double terms = damping_acts(integration) ? AXES * nodes : 0;
    for (int k = 0; k < boundary->loads.count; k++)
        terms += (double)boundary->loads.items[k].members.n_all;
    for (int b = 0; b < boundary->count; b++) terms += (double)boundary->sets[b].members.n_all;
    return exact_sum_loss(&integration->kinetic_zero) *
           (TIMES * ENERGIES * nodes + HALVES * terms * (double)integration->step);
}

/* Where there are grips they set the scale alone, as long as nothing else moves or loads the body.
 */
static void take_energies(struct integration *integration, const struct body *body,
                          const struct boundary *boundary, const double values[SUMS])
{
    struct energy_balance *balance = &integration->balance;
    balance->kinetic = values[KINETIC];
    balance->staggered = values[STAGGERED];
    balance->stored = values[STORED];
    balance->plastic = values[PLASTIC];
    balance->stabilisation = values[STABILISATION];
    balance->reference = fmax(balance->reference, values[LOADED]);
    balance->rounding = lost_in_sums(integration, body, boundary);
    if (!boundary_has_grips(boundary) || affine_energy(integration, body, boundary) == 0)
        balance->reference = fmax(balance->reference, set_energy(integration, body, boundary));
}

void balance_start(struct integration *integration, const struct body *body,
                   struct boundary *boundary, const struct force_energy *energy)
{
    const struct balance_sums none = {integration->kinetic_zero, integration->kinetic_zero};
    double values[SUMS];
    finish(integration, body, boundary, energy, &none, values);
    integration->held = values[HELD];
    integration->balance.reference = affine_energy(integration, body, boundary);
    take_energies(integration, body, boundary, values);
    integration->balance.initial = energy_total(&integration->balance);
}

/* Work of the sets over a step (balance.2): mean force times way, and what their own mass has
 * gained. */
static void add_work_of_sets(struct boundary *boundary, double *work)
{
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *set = &boundary->sets[b];
        if (set->place[0]) continue;
        set->moved += set->way;
        *work +=
            0.5 * (set->reaction_before + set->reaction) * set->way +
            0.5 * set->mass * (set->speed * set->speed - set->speed_before * set->speed_before);
    }
}

void balance_step(struct integration *integration, const struct body *body,
                  struct boundary *boundary, const struct force_energy *energy,
                  const struct balance_sums *sums)
{
    const enum profile_part before = profile_enter(body->profile, PART_BALANCE);
    double values[SUMS];
    finish(integration, body, boundary, energy, sums, values);
    integration->balance.damping += values[DAMPED];
    add_work_of_sets(boundary, &integration->balance.work);
    if (boundary->macroscopic)
        integration->balance.work +=
            macroscopic_take_work(boundary->macroscopic, body, integration->moving);
    integration->balance.work += values[WORK] + (values[HELD] - integration->held);
    integration->held = values[HELD];
    if (energy) take_energies(integration, body, boundary, values);
    profile_enter(body->profile, before);
}

void balance_motion(struct integration *integration, const struct body *body,
                    struct boundary *boundary)
{
    struct energy_balance *balance = &integration->balance;
    struct exact_sum sums[] = {integration->kinetic_zero, integration->kinetic_zero,
                               integration->kinetic_zero};
    double values[3];
    sum_kinetic(integration, body, boundary, &sums[0]);
    sum_held(integration, body, boundary, &sums[1]);
    sum_staggered(integration, body, boundary, &sums[2]);
    exact_sum_finish(sums, 3, values);
    const double lost = balance->kinetic + balance->staggered - values[0] - values[2];
    const bool gained = lost < 0;
    if (!gained) balance->damping += lost;
    balance->kinetic = values[0];
    balance->staggered = values[2];
    integration->held = values[1];
    if (gained) balance->initial = energy_total(balance) - balance->work;
}

void balance_reactions(const struct body *body, struct boundary *boundary)
{
    struct exact_sum *sums = memory_new((size_t)boundary->count, sizeof *sums);
    double *values = memory_new((size_t)boundary->count, sizeof *values);
    boundary_reactions(boundary, body, sums);
    exact_sum_finish(sums, boundary->count, values);
    for (int b = 0; b < boundary->count; b++) boundary->sets[b].reaction = values[b];
    free(sums);
    free(values);
}
