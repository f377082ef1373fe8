#include "verlet.h"

#include "balance.h"
#include "damping.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* v += half_step f/rho at the strip's nodes. */
HS_SIMD static void kick(int count, const double *restrict f,
                         const double *restrict inverse_density, double half_step,
                         double *restrict v)
{
    for (int i = 0; i < count; i++) v[i] += half_step * f[i] * inverse_density[i];
}
/* The same with a force from outside. */
HS_SIMD static void kick_loaded(int count, const double *restrict f, const double *restrict b,
                                const double *restrict inverse_density, double half_step,
                                double *restrict v)
{
    for (int i = 0; i < count; i++) v[i] += half_step * (f[i] + b[i]) * inverse_density[i];
}
HS_SIMD static void drift(int count, const double *restrict v, double dt, double *restrict u)
{
    for (int i = 0; i < count; i++) u[i] += dt * v[i];
}

static void half_kick(const struct verlet *verlet, struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        const int64_t site = strip->site;
        double inverse_density[LANES];
        verlet_strip_density(verlet, body, strip, inverse_density);
        for (int a = 0; a < 3; a++)
            if (body->b[a])
                kick_loaded(strip->count, body->f[a] + site, body->b[a] + site, inverse_density,
                            0.5 * verlet->dt, body->v[a] + site);
            else
                kick(strip->count, body->f[a] + site, inverse_density, 0.5 * verlet->dt,
                     body->v[a] + site);
    }
}

static void move(const struct verlet *verlet, struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int a = 0; a < 3; a++)
            drift(body->owned.items[s].count, body->v[a] + body->owned.items[s].site, verlet->dt,
                  body->u[a] + body->owned.items[s].site);
}

struct verlet verlet_new(double dt, double damping, const struct materials *materials,
                         struct body *body, struct boundary *boundary, struct model *model)
{
    struct verlet verlet = {.dt = dt, .damping = damping};
    verlet.inverse_density = memory_new((size_t)materials->count, sizeof(double));
    for (int i = 0; i < materials->count; i++)
        verlet.inverse_density[i] = 1 / materials->items[i].density;
    /* No energy density of a metal exceeds its Young's modulus. */
    const double bound = (double)body->n_nodes * body->volume * materials_stiffest(materials);
    const struct exact_sum zero = exact_sum_new(4 * bound);
    verlet.zero = (struct force_energy){zero, zero, zero};
    verlet.kinetic_zero = zero;

    balance_masses(&verlet, body, boundary);
    boundary_set_displacements(boundary, body);
    boundary_set_velocities(boundary, body, 0, dt);
    loads_set(&boundary->loads, body, 0);
    struct force_energy energy = verlet.zero;
    model_force(model, body, (struct force_mode){.commit = true, .energy = true}, &energy);
    balance_start(&verlet, body, boundary, &energy);
    return verlet;
}

void verlet_free(struct verlet *verlet)
{
    free(verlet->inverse_density);
    *verlet = (struct verlet){0};
}

bool verlet_raise_loads(struct verlet *verlet, struct body *body, struct boundary *boundary,
                        bool equilibrium)
{
    if (!loads_raise(&boundary->loads, verlet->step, equilibrium)) return false;
    loads_set(&boundary->loads, body, verlet->time);
    balance_reactions(body, boundary);
    return true;
}

/* stored + plastic + stabilisation [J] */
static double held_energy(const struct force_energy *energy)
{
    double values[3];
    exact_sum_finish(
        (const struct exact_sum[]){energy->stored, energy->plastic, energy->stabilisation}, 3,
        values);
    return values[0] + values[1] + values[2];
}

/* dt/2 sum V v . f at owned nodes, v in the middle of the step [J]. */
static double half_step_power(const struct verlet *verlet, const struct body *body)
{
    struct exact_sum sum = verlet->kinetic_zero;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            double power = 0;
            for (int a = 0; a < 3; a++) power += body->v[a][site] * body->f[a][site];
            exact_sum_add(&sum, 0.5 * verlet->dt * body_volume(body, site) * power);
        }
    double value;
    exact_sum_finish(&sum, 1, &value);
    return value;
}

/* Bonds break at the configuration that the force has just been found for; force and energies become those of
 * the bonds left.  The kick before had the old force, the kick to come has the new one: the bonds broke in
 * the middle of the step, and the energy of fracture is the difference of the energies there, dt v/2 back.
 * known: energy has been found with the force. */
static void break_bonds(struct verlet *verlet, struct body *body, struct model *model,
                        double *axial, bool known, struct force_energy *energy)
{
    if (!verlet->damage || !damage_find(verlet->damage)) return;
    if (!known) {
        *energy = verlet->zero;
        model_force(model, body, (struct force_mode){.energy = true}, energy);
    }
    const double before = held_energy(energy) + half_step_power(verlet, body);
    damage_break(verlet->damage);
    if (axial) memset(axial, 0, (size_t)body->grid.n_sites * sizeof *axial);
    *energy = verlet->zero;
    model_force(model, body, (struct force_mode){.commit = true, .energy = true, .axial = axial},
                energy);
    verlet->balance.fracture += before - held_energy(energy) - half_step_power(verlet, body);
}

void verlet_step(struct verlet *verlet, struct body *body, struct boundary *boundary,
                 struct model *model, bool energies, double *axial)
{
    struct balance_sums sums = {verlet->kinetic_zero, verlet->kinetic_zero};
    struct force_energy energy = verlet->zero;

    half_kick(verlet, body);
    if (verlet->damping > 0) damping_apply(verlet, body, boundary, verlet->time, &sums.damped);
    boundary_set_ways(boundary, body, verlet->time, verlet->dt);
    boundary_add_work(boundary, body, 0.5 * verlet->dt, &sums.work);
    move(verlet, body);
    verlet->step++;
    verlet->time += verlet->dt;

    loads_set(&boundary->loads, body, verlet->time);
    model_force(model, body,
                (struct force_mode){.commit = true, .energy = energies, .axial = axial}, &energy);
    break_bonds(verlet, body, model, axial, energies, &energy);
    boundary_add_work(boundary, body, 0.5 * verlet->dt, &sums.work);
    half_kick(verlet, body);
    if (verlet->damping > 0) damping_apply(verlet, body, boundary, verlet->time, &sums.damped);
    boundary_set_velocities(boundary, body, verlet->time, verlet->dt);

    balance_step(verlet, body, boundary, energies ? &energy : NULL, &sums);
}
