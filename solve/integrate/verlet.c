#include "verlet.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* v += half_step f/rho at the strip's nodes. */
HS_SIMD static void kick(int count, const double *restrict f,
                         const double *restrict inverse_density, double half_step,
                         double *restrict v)
{
    for (int i = 0; i < count; i++) v[i] += half_step * f[i] * inverse_density[i];
}
HS_SIMD static void drift(int count, const double *restrict v, double dt, double *restrict u)
{
    for (int i = 0; i < count; i++) u[i] += dt * v[i];
}

static void strip_density(const struct verlet *verlet, const struct body *body,
                          const struct strip *strip, double inverse_density[LANES])
{
    for (int i = 0; i < strip->count; i++)
        inverse_density[i] = verlet->inverse_density[body->grid.phase[strip->site + i]];
}

/* The affine motion between the grips at a node: what damping leaves alone. */
struct affine {
    double left_velocity, rate, left, right, contraction, centre[3];
};

static struct affine affine_motion(const struct boundary *boundary, const struct body *body,
                                   double time)
{
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const double factor = boundary_factor(boundary, time);
    struct affine affine = {.left_velocity = factor * left->velocity,
                            .rate = factor * boundary_strain_rate(boundary),
                            .left = left->inner,
                            .right = boundary->sets[boundary->right].inner,
                            .contraction = 0.5}; /* of plastic flow, which lasts longest */
    for (int a = 0; a < 3; a++) affine.centre[a] = lattice_middle(body->lattice, a);
    return affine;
}

/* The affine velocity of the node at a site. */
static void affine_velocity(const struct affine *affine, const struct body *body, int64_t site,
                            double velocity[3])
{
    double x[3];
    body_position(body, site, x);
    double along = fmin(fmax(x[0], affine->left), affine->right) - affine->left;
    velocity[0] = affine->left_velocity + affine->rate * along;
    for (int a = 1; a < 3; a++) {
        velocity[a] = -affine->contraction * affine->rate * (x[a] - affine->centre[a]);
    }
}

static double node_mass(const struct verlet *verlet, const struct body *body, int64_t site)
{
    return body_volume(body, site) / verlet->inverse_density[body->grid.phase[site]];
}

/* Velocity decays towards the affine motion over half a step; lost takes the energy. */
static void damp(struct verlet *verlet, struct body *body, const struct boundary *boundary,
                 double time, struct exact_sum *lost)
{
    const struct affine affine = affine_motion(boundary, body, time);
    const double keep = exp(-0.5 * verlet->damping * verlet->dt);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            double target[3];
            affine_velocity(&affine, body, site, target);
            for (int a = 0; a < 3; a++) {
                double before = body->v[a][site];
                double after = target[a] + keep * (before - target[a]);
                body->v[a][site] = after;
                exact_sum_add(lost, 0.5 * node_mass(verlet, body, site) *
                                        (before * before - after * after));
            }
        }
}

double verlet_unsteady_energy(const struct verlet *verlet, const struct body *body,
                              const struct boundary *boundary)
{
    const struct affine affine = affine_motion(boundary, body, verlet->time);
    struct exact_sum sum = verlet->kinetic_zero;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            double steady[3], square = 0;
            affine_velocity(&affine, body, site, steady);
            for (int a = 0; a < 3; a++) {
                double beyond = body->v[a][site] - steady[a];
                square += beyond * beyond;
            }
            exact_sum_add(&sum, 0.5 * node_mass(verlet, body, site) * square);
        }
    double energy;
    exact_sum_finish(&sum, 1, &energy);
    return energy;
}

static void half_kick(const struct verlet *verlet, struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        double inverse_density[LANES];
        strip_density(verlet, body, strip, inverse_density);
        for (int a = 0; a < 3; a++)
            kick(strip->count, body->f[a] + strip->site, inverse_density, 0.5 * verlet->dt,
                 body->v[a] + strip->site);
    }
}

static void move(const struct verlet *verlet, struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int a = 0; a < 3; a++)
            drift(body->owned.items[s].count, body->v[a] + body->owned.items[s].site, verlet->dt,
                  body->u[a] + body->owned.items[s].site);
}

HS_SIMD static void speed_squared(int count, const double *restrict x, const double *restrict y,
                                  const double *restrict z, const double *restrict inverse_density,
                                  double *restrict out)
{
    for (int i = 0; i < count; i++)
        out[i] = (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]) / inverse_density[i];
}

static void sum_kinetic(const struct verlet *verlet, const struct body *body,
                        struct exact_sum *kinetic)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        double inverse_density[LANES], terms[LANES];
        strip_density(verlet, body, strip, inverse_density);
        speed_squared(strip->count, body->v[0] + strip->site, body->v[1] + strip->site,
                      body->v[2] + strip->site, inverse_density, terms);
        body_times_volume(body, strip->site, strip->count, terms);
        exact_sum_add_strip(kinetic, strip->count, terms, 0.5);
    }
}

/* Mass of a set [kg] from its phases; the sets are small. */
static void sum_masses(const struct verlet *verlet, const struct body *body,
                       const struct boundary *boundary, double *masses)
{
    struct exact_sum *sums = memory_new((size_t)boundary->count, sizeof *sums);
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        sums[b] = verlet->kinetic_zero;
        for (int64_t i = 0; i < set->members.count; i++)
            exact_sum_add(&sums[b], node_mass(verlet, body, set->members.sites[i]));
    }
    exact_sum_finish(sums, boundary->count, masses);
    free(sums);
}

/* All sums over the body that a step needs, in one message: energies and reactions. */
static void finish_sums(struct verlet *verlet, const struct body *body, struct boundary *boundary,
                        struct force_energy *energy, const struct exact_sum *damped)
{
    enum { ENERGIES = 5 };
    const int count = ENERGIES + boundary->count;
    struct exact_sum *sums = memory_new((size_t)count, sizeof *sums);
    double *values = memory_new((size_t)count, sizeof *values);
    sums[0] = verlet->kinetic_zero;
    sum_kinetic(verlet, body, &sums[0]);
    sums[1] = energy->stored;
    sums[2] = energy->plastic;
    sums[3] = energy->stabilisation;
    sums[4] = *damped;
    boundary_reactions(boundary, body, sums + ENERGIES);
    exact_sum_finish(sums, count, values);
    verlet->balance.kinetic = values[0];
    verlet->balance.stored = values[1];
    verlet->balance.plastic = values[2];
    verlet->balance.stabilisation = values[3];
    verlet->balance.damping += values[4];
    for (int b = 0; b < boundary->count; b++) {
        boundary->sets[b].force_before = boundary->sets[b].total_force;
        boundary->sets[b].total_force = values[ENERGIES + b];
    }
    free(sums);
    free(values);
}

/* rho V (v_right - v_left)^2/24 summed: a bar stretched uniformly about its middle. */
static double affine_energy(const struct verlet *verlet, const struct body *body,
                            const struct boundary *boundary)
{
    const double density = 1 / verlet->inverse_density[0];
    double speed =
        boundary->sets[boundary->right].velocity - boundary->sets[boundary->left].velocity;
    return body->volume * (double)body->n_nodes * density * speed * speed / 24;
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

    double *masses = memory_new((size_t)boundary->count, sizeof *masses);
    sum_masses(&verlet, body, boundary, masses);
    for (int b = 0; b < boundary->count; b++) boundary->sets[b].mass = masses[b];
    free(masses);

    struct force_energy energy = verlet.zero;
    model_force(model, body, (struct force_mode){.commit = true, .energy = true}, &energy);
    finish_sums(&verlet, body, boundary, &energy, &verlet.kinetic_zero);
    verlet.balance.initial = verlet.balance.kinetic;
    verlet.balance.reference = affine_energy(&verlet, body, boundary);
    return verlet;
}

void verlet_free(struct verlet *verlet)
{
    free(verlet->inverse_density);
    *verlet = (struct verlet){0};
}

/* Work of the sets over a step: mean force times way, and what their own mass has gained. */
static void add_work(struct verlet *verlet, struct boundary *boundary)
{
    const double end = verlet->time, start = end - verlet->dt;
    const double before = boundary_factor(boundary, start), after = boundary_factor(boundary, end),
                 middle = boundary_factor(boundary, 0.5 * (start + end));
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *set = &boundary->sets[b];
        double way = middle * set->velocity * verlet->dt;
        set->moved += way;
        verlet->balance.work +=
            0.5 * (set->force_before + set->total_force) * way +
            0.5 * set->mass * set->velocity * set->velocity * (after * after - before * before);
    }
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
 * the middle of the step, and the energy of fracture is the difference of the energies there, dt v/2 back. */
static void break_bonds(struct verlet *verlet, struct body *body, struct model *model,
                        double *axial, struct force_energy *energy)
{
    if (!verlet->damage || !damage_update(verlet->damage)) return;
    const double before = held_energy(energy) + half_step_power(verlet, body);
    if (axial) memset(axial, 0, (size_t)body->grid.n_sites * sizeof *axial);
    *energy = verlet->zero;
    model_force(model, body, (struct force_mode){.commit = true, .energy = true, .axial = axial},
                energy);
    verlet->balance.fracture += before - held_energy(energy) - half_step_power(verlet, body);
}

void verlet_step(struct verlet *verlet, struct body *body, struct boundary *boundary,
                 struct model *model, double *axial)
{
    struct exact_sum damped = verlet->kinetic_zero;

    half_kick(verlet, body);
    if (verlet->damping > 0) {
        /* The kick has touched the grips, too; what it gave them is not there to be lost. */
        boundary_set_velocities(boundary, body, verlet->time);
        damp(verlet, body, boundary, verlet->time, &damped);
    }
    boundary_set_velocities(boundary, body, verlet->time + 0.5 * verlet->dt);
    move(verlet, body);
    verlet->step++;
    verlet->time += verlet->dt;

    struct force_energy energy = verlet->zero;
    model_force(model, body, (struct force_mode){.commit = true, .energy = true, .axial = axial},
                &energy);
    break_bonds(verlet, body, model, axial, &energy);
    half_kick(verlet, body);
    boundary_set_velocities(boundary, body, verlet->time);
    if (verlet->damping > 0) damp(verlet, body, boundary, verlet->time, &damped);
    boundary_set_velocities(boundary, body, verlet->time);

    finish_sums(verlet, body, boundary, &energy, &damped);
    add_work(verlet, boundary);
}
