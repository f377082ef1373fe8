#include "quasi_static.h"

#include "balance.h"
#include "checkpoint.h"
#include "integrity.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Share of the most evaluations up to which the next step grows. */
static const double EASY = 0.25;

/* Change of a node's integrity that needs no new equilibrium. */
static const double SETTLED = 1e-3;

static bool work_depends_on_place(const struct boundary *boundary)
{
    bool depends = boundary->loads.count > 0;
    for (int b = 0; b < boundary->count; b++) depends |= boundary->sets[b].place[0] != NULL;
    return depends;
}

struct quasi_static *quasi_static_new(struct equilibrium *equilibrium, double largest,
                                      double smallest, double accuracy, double breaking)
{
    struct quasi_static *q = memory_new(1, sizeof *q);
    struct body *body = equilibrium->body;
    q->equilibrium = equilibrium;
    q->largest = largest;
    q->smallest = smallest;
    q->error = step_error_new(accuracy, breaking, equilibrium->boundary);
    q->rate = vector_new(&equilibrium->unknowns);
    q->before = vector_new(&equilibrium->unknowns);
    q->held_before = memory_new(3 * (size_t)equilibrium->held.count, sizeof(double));
    for (int k = 0; k < 2 && body->integrity; k++) {
        const size_t bytes = (size_t)body->grid.n_sites * sizeof(double);
        q->sound[k] = memory_new(1, bytes);
        memcpy(q->sound[k], body->integrity->node, bytes);
    }
    for (int a = 0; a < 3 && work_depends_on_place(equilibrium->boundary); a++) {
        q->force_before[a] = memory_new((size_t)body->grid.n_sites, sizeof(double));
        q->load_before[a] = memory_new((size_t)body->grid.n_sites, sizeof(double));
    }
    vector_take(&equilibrium->unknowns, body->v, 1, q->rate);
    vector_take_mean(&equilibrium->unknowns, body->mean_rate, q->rate);
    body_clear(body, body->v, 3);
    return q;
}

void quasi_static_free(struct quasi_static *q)
{
    if (!q) return;
    step_error_free(&q->error);
    free(q->rate);
    free(q->before);
    free(q->held_before);
    free(q->sound[0]);
    free(q->sound[1]);
    for (int a = 0; a < 3; a++) {
        free(q->force_before[a]);
        free(q->load_before[a]);
    }
    free(q);
}

static void keep_held(struct quasi_static *q, bool restore)
{
    const struct members *held = &q->equilibrium->held;
    for (int64_t i = 0; i < held->count; i++)
        for (int a = 0; a < 3; a++) {
            double *u = &q->equilibrium->body->u[a][held->sites[i]],
                   *kept = &q->held_before[3 * i + a];
            if (restore)
                *u = *kept;
            else
                *kept = *u;
        }
    double *mean = q->equilibrium->body->mean_gradient;
    memcpy(restore ? mean : q->mean_before, restore ? q->mean_before : mean, sizeof q->mean_before);
}

static void keep_forces(const struct quasi_static *q)
{
    const struct body *body = q->equilibrium->body;
    const size_t bytes = (size_t)body->grid.n_sites * sizeof(double);
    for (int a = 0; a < 3 && q->force_before[a]; a++) {
        memcpy(q->force_before[a], body->f[a], bytes);
        if (body->b[a]) memcpy(q->load_before[a], body->b[a], bytes);
    }
}

static void keep_integrity(struct quasi_static *q)
{
    const struct body *body = q->equilibrium->body;
    double *oldest = q->sound[1];
    if (!oldest) return;
    q->sound[1] = q->sound[0];
    q->sound[0] =
        memcpy(oldest, body->integrity->node, (size_t)body->grid.n_sites * sizeof(double));
}

/* (quasi_static.1); times: dt'/dt. */
static void predict_integrity(const struct quasi_static *q, double times)
{
    static const double share = 0.8, least = 0.1;
    const struct body *body = q->equilibrium->body;
    const double *c = q->sound[0], *before = q->sound[1];
    for (int64_t i = 0; c && i < body->grid.n_sites; i++)
        body->integrity->node[i] =
            fmax(c[i] + share * times * fmin(c[i] - before[i], 0), least * c[i]);
}

static void exchange(double *fields[3], double *other[3])
{
    for (int a = 0; a < 3; a++) {
        double *field = fields[a];
        if (!field || !other[a]) continue;
        fields[a] = other[a];
        other[a] = field;
    }
}

/* Half of the step's work, of loads and of sets with a motion that depends on place. */
static void add_half_work(const struct quasi_static *q, double dt, struct exact_sum *work)
{
    const struct body *body = q->equilibrium->body;
    boundary_add_set_work(q->equilibrium->boundary, body, 0.5 * dt, work);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            for (int a = 0; a < 3; a++)
                if (body->b[a])
                    exact_sum_add(work, 0.5 * dt * body->b[a][site] * body->v[a][site] *
                                            body_volume(body, site));
        }
}

/* Moves the held components by the step and guesses the free ones; true where they come to rest. */
static bool try_step(struct quasi_static *q, double dt)
{
    struct equilibrium *e = q->equilibrium;
    struct body *body = e->body;
    const double time = e->integration->time;
    e->integration->force_time = time + dt;
    loads_set(&e->boundary->loads, body, time + dt);
    predict_integrity(q, q->lasted > 0 ? dt / q->lasted : 0);
    boundary_set_ways(e->boundary, body, time, dt);
    if (e->boundary->macroscopic) macroscopic_move(e->boundary->macroscopic, body);
    for (int64_t i = 0; i < e->held.count; i++)
        for (int a = 0; a < 3; a++)
            if (e->boundary->held[e->held.sites[i]] >> a & 1)
                body->u[a][e->held.sites[i]] += dt * body->v[a][e->held.sites[i]];
    memcpy(e->x, q->before, (size_t)e->unknowns.length * sizeof(double));
    vector_add(&e->unknowns, dt, q->rate, e->x);
    return equilibrium_solve(e);
}

/* The equilibrium becomes the state, which may be far from the last one. */
static struct force_energy commit(struct equilibrium *e)
{
    if (e->integration->damage) damage_moved(e->integration->damage, INFINITY);
    struct force_energy energy = e->integration->zero;
    integration_force(e->integration, e->model, e->body,
                      (struct force_mode){.commit = true, .energy = true, .record = true}, &energy);
    e->integration->residual = equilibrium_residual(e);
    return energy;
}

static void find_rate(struct quasi_static *q, double dt)
{
    const struct equilibrium *e = q->equilibrium;
    vector_rate(&e->unknowns, e->x, q->before, dt, q->rate);
}

static void accept(struct quasi_static *q, double dt)
{
    struct equilibrium *e = q->equilibrium;
    struct integration *integration = e->integration;
    struct balance_sums sums = {integration->kinetic_zero, integration->kinetic_zero};
    find_rate(q, dt);
    if (q->force_before[0]) {
        vector_put(&e->unknowns, q->rate, e->body->v);
        exchange(e->body->f, q->force_before);
        exchange(e->body->b, q->load_before);
        add_half_work(q, dt, &sums.work);
        exchange(e->body->f, q->force_before);
        exchange(e->body->b, q->load_before);
        add_half_work(q, dt, &sums.work);
    }
    body_clear(e->body, e->body->v, 3);
    integration->step++;
    integration->time += dt;
    struct force_energy energy = commit(e);
    balance_step(integration, e->body, e->boundary, &energy, &sums);
}

/* Below this length a step is not refused for its error. */
static double least_measured(const struct quasi_static *q)
{
    return fmax(q->smallest, 10 * q->error.accuracy * q->largest);
}

/* Whether bonds are going to break in the equilibrium that was found. */
static bool breaks(struct equilibrium *e)
{
    struct damage *damage = e->integration->damage;
    if (!damage) return false;
    damage_moved(damage, INFINITY);
    return damage_find(damage);
}

/* Share of the step's length to try in its place; 1: it is taken. */
static double solve_step(struct quasi_static *q, double dt)
{
    static const double shortest = 0.1, halved = 0.5, careful = 0.9;
    struct equilibrium *e = q->equilibrium;
    if (!try_step(q, dt)) return halved;
    const double room = careful * step_error_room(&q->error, e->boundary, e->body, e->tolerance);
    if (room < careful && dt > least_measured(q)) {
        find_rate(q, dt); /* a better guess than that of the step before */
        return fmax(fmin(fmax(room, shortest), halved), least_measured(q) / dt);
    }
    const double breaking = breaks(e) ? step_error_breaking_room(&q->error) : INFINITY;
    if (breaking >= 1 || dt <= q->smallest) return 1;
    find_rate(q, dt);
    return fmax(fmin(fmax(breaking, shortest), halved), q->smallest / dt);
}

/* Of the largest step, where the load falls: 0.3 at the usual accuracy. */
static double falling_share(const struct quasi_static *q)
{
    return fmin(10 * sqrt(q->error.accuracy), 1);
}

static double next_length(struct quasi_static *q, double dt)
{
    static const double shortest = 0.5, careful = 0.9;
    const struct equilibrium *e = q->equilibrium;
    const double room = careful * step_error_take(&q->error, e->boundary),
                 easy = (double)e->evaluations <= EASY * (double)e->most_evaluations
                            ? QUASI_STATIC_GROWTH
                            : 1;
    const double largest = (q->error.falls ? falling_share(q) : 1) * q->largest;
    return fmin(fmax(fmin(easy, fmax(room, shortest)) * dt, q->smallest), largest);
}

bool quasi_static_step(struct quasi_static *q)
{
    struct equilibrium *e = q->equilibrium;
    const double least = (1 - 1e-9) * q->smallest; /* a share may be rounded */
    double dt = e->integration->dt, share;
    step_error_start(&q->error, e->boundary, e->body);
    vector_take(&e->unknowns, e->body->u, 1, q->before);
    vector_take_mean(&e->unknowns, e->body->mean_gradient, q->before);
    keep_held(q, false);
    keep_forces(q);
    keep_integrity(q);
    while ((share = solve_step(q, dt)) < 1) {
        if (e->cut) return false;
        q->refused++;
        keep_held(q, true);
        dt *= share;
        if (dt < least) {
            vector_put(&e->unknowns, q->before, e->body->u);
            vector_put_mean(&e->unknowns, q->before, e->body->mean_gradient);
            body_clear(e->body, e->body->v, 3);
            e->integration->force_time = e->integration->time;
            loads_set(&e->boundary->loads, e->body, e->integration->time);
            predict_integrity(q, 0);
            integration_force(e->integration, e->model, e->body, (struct force_mode){0}, NULL);
            return false;
        }
    }
    accept(q, dt);
    q->lasted = dt;
    e->integration->dt = next_length(q, dt);
    return true;
}

void quasi_static_turn(struct quasi_static *q)
{
    for (int64_t i = 0; i < q->equilibrium->unknowns.length; i++) q->rate[i] = -q->rate[i];
    q->lasted = 0;
}

void quasi_static_velocities(const struct quasi_static *q)
{
    vector_put(&q->equilibrium->unknowns, q->rate, q->equilibrium->body->v);
    vector_put_mean(&q->equilibrium->unknowns, q->rate, q->equilibrium->body->mean_rate);
}

double quasi_static_settle(struct quasi_static *q)
{
    struct equilibrium *e = q->equilibrium;
    const double before = energy_internal(&e->integration->balance) - e->integration->balance.work;
    equilibrium_find_x(e);
    /* There is no smaller step to take: more evaluations are all that helps, as long as they do. */
    for (double residual = INFINITY; !equilibrium_solve(e); residual = equilibrium_residual(e))
        if (e->cut || !(equilibrium_residual(e) < 0.9 * residual)) return INFINITY;
    const struct balance_sums none = {e->integration->kinetic_zero, e->integration->kinetic_zero};
    struct force_energy energy = commit(e);
    for (int b = 0; b < e->boundary->count; b++) e->boundary->sets[b].way = 0;
    balance_step(e->integration, e->body, e->boundary, &energy, &none);
    step_error_forget(&q->error);
    return before + e->integration->balance.work - energy_internal(&e->integration->balance);
}

bool quasi_static_break(struct quasi_static *q, struct quasi_static_damage *record)
{
    struct integration *integration = q->equilibrium->integration;
    struct damage *damage = integration->damage;
    for (record->rounds = 0;; record->rounds++) {
        const double change = damage_grow(damage);
        const bool breaking = damage_find(damage);
        if (record->rounds == 0) record->degradation = change;
        if (!breaking && change < SETTLED) return true;
        if (breaking) {
            damage_choose(damage, record->most);
            damage_break(damage);
        }
        const double lost = quasi_static_settle(q);
        if (!isfinite(lost)) return false;
        if (breaking) integration->balance.fracture += lost;
    }
}

void quasi_static_visit(struct quasi_static *q, struct checkpoint *checkpoint)
{
    vector_visit(&q->equilibrium->unknowns, checkpoint, "rate of the last load step", q->rate);
    if (q->sound[0]) {
        checkpoint_fields(checkpoint, "integrity before the last load step", q->sound, 1);
        checkpoint_numbers(checkpoint, "length of the last load step", &q->lasted, 1);
    }
    checkpoint_integer(checkpoint, "load steps tried in vain", &q->refused);
    step_error_visit(&q->error, checkpoint);
    equilibrium_visit(q->equilibrium, checkpoint);
}
