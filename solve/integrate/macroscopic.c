#include "macroscopic.h"

#include "checkpoint.h"
#include "memory.h"

#include <math.h>
#include <string.h>

/* Whether a component of H is one that the body answers to, and no mere turn. */
static bool strains(const struct macroscopic *m, int row, int column)
{
    return m->axis[column] && (row == column || (row < column && m->axis[row]));
}

static void find_periods(struct macroscopic *m, const struct lattice *lattice)
{
    for (int a = 0; a < 3; a++) {
        m->axis[a] = lattice->periodic[a];
        m->period[a] = lattice_period(lattice, a);
    }
}

struct macroscopic *macroscopic_new(const struct scene *scene, const struct body *body)
{
    if (!lattice_is_periodic(body->lattice)) return NULL;
    struct macroscopic *m = memory_new(1, sizeof *m);
    find_periods(m, body->lattice);
    m->volume = body->whole_volume;
    m->sense = 1;
    for (int k = 0; k < COMPONENTS; k++) {
        m->component[k].given = !strains(m, k / 3, k % 3);
        m->component[k].kind = m->component[k].given ? MACROSCOPIC_STRAIN : MACROSCOPIC_STRESS;
    }
    for (int i = 0; i < scene->n_components; i++) {
        const struct scene_component *wanted = &scene->components[i];
        const int k = wanted->component;
        if (!m->axis[k % 3])
            deck_error(wanted->where,
                       "%s: the body is not periodic along %c, so that nothing is given there",
                       scene_components[k], 'x' + k % 3);
        if (wanted->kind == MACROSCOPIC_STRESS && !strains(m, k / 3, k % 3))
            deck_error(wanted->where,
                       "%s: this component only turns the body; give the stress %s in its place",
                       scene_components[k], scene_components[3 * (k % 3) + k / 3]);
        m->component[k].given = wanted->kind != MACROSCOPIC_STRESS;
        m->component[k].kind = wanted->kind;
        m->component[k].value = &wanted->value;
    }
    return m;
}

static double value_of(const struct macroscopic *m, int k, double time)
{
    const struct value *value = m->component[k].value;
    if (!value) return 0;
    const bool turns = m->component[k].kind == MACROSCOPIC_RATE && value->kind == VALUE_CONSTANT;
    return (turns ? m->sense : 1) * value_at(value, (const double[]){0, 0, 0}, time);
}

void macroscopic_turn(struct macroscopic *m, double sense)
{
    m->sense = sense;
}

void macroscopic_start(const struct macroscopic *m, struct body *body, double poissons_ratio,
                       double dt)
{
    double stretch = 0;
    for (int k = 0; k < COMPONENTS; k++) {
        body->mean_rate[k] = 0;
        if (m->component[k].kind == MACROSCOPIC_RATE)
            body->mean_rate[k] = value_of(m, k, 0.5 * dt);
        else if (m->component[k].kind == MACROSCOPIC_STRAIN)
            body->mean_rate[k] = (value_of(m, k, dt) - value_of(m, k, 0)) / dt;
        if (k / 3 == k % 3) stretch += body->mean_rate[k];
    }
    for (int k = 0; k < COMPONENTS; k += 4)
        if (!m->component[k].given) body->mean_rate[k] = -poissons_ratio * stretch;
}

void macroscopic_set_ways(struct macroscopic *m, const struct body *body, double time, double dt)
{
    for (int k = 0; k < COMPONENTS; k++) {
        m->way[k] = m->target[k] = 0;
        if (m->component[k].kind == MACROSCOPIC_STRESS)
            m->target[k] = value_of(m, k, time + dt);
        else if (m->component[k].kind == MACROSCOPIC_RATE)
            m->way[k] = dt * value_of(m, k, time + 0.5 * dt);
        else
            m->way[k] = value_of(m, k, time + dt) - body->mean_gradient[k];
    }
}

void macroscopic_move(const struct macroscopic *m, struct body *body)
{
    for (int k = 0; k < COMPONENTS; k++)
        if (m->component[k].given) body->mean_gradient[k] += m->way[k];
}

void macroscopic_weigh(struct macroscopic *m, const struct body *body,
                       const double inverse_density[])
{
    const struct lattice *lattice = body->lattice;
    m->mass = 0;
    for (int64_t site = 0; site < lattice->n_sites; site++)
        if (lattice->phase[site] != ABSENT)
            m->mass += lattice_volume(lattice, site) / inverse_density[lattice->phase[site]];
}

static double inertia(const struct macroscopic *m, int k)
{
    return m->mass * m->period[k % 3] * m->period[k % 3] / (M_PI * M_PI);
}

/* What moves component k [J]. */
static double pull(const struct macroscopic *m, const struct body *body, int k)
{
    return m->volume * (m->target[k] - body->mean_stress[k]);
}

void macroscopic_kick(const struct macroscopic *m, struct body *body, double time)
{
    for (int k = 0; k < COMPONENTS; k++)
        if (!m->component[k].given) body->mean_rate[k] += time * pull(m, body, k) / inertia(m, k);
}

void macroscopic_drift(const struct macroscopic *m, struct body *body, double time)
{
    for (int k = 0; k < COMPONENTS; k++)
        if (!m->component[k].given) body->mean_gradient[k] += time * body->mean_rate[k];
}

double macroscopic_kinetic(const struct macroscopic *m, const struct body *body)
{
    double energy = 0;
    for (int k = 0; k < COMPONENTS; k++)
        if (!m->component[k].given)
            energy += 0.5 * inertia(m, k) * body->mean_rate[k] * body->mean_rate[k];
    return energy;
}

double macroscopic_staggered(const struct macroscopic *m, const struct body *body, double dt)
{
    double energy = 0;
    for (int k = 0; k < COMPONENTS; k++)
        if (!m->component[k].given)
            energy -= 0.125 * dt * dt * pull(m, body, k) * pull(m, body, k) / inertia(m, k);
    return energy;
}

double macroscopic_force(const struct macroscopic *m, const struct body *body, int k)
{
    return body->mean_stress[k] * m->volume / m->period[k % 3];
}

double macroscopic_way(const struct macroscopic *m, int k)
{
    return m->way[k] * m->period[k % 3];
}

double macroscopic_reactions(const struct macroscopic *m, const struct body *body)
{
    const struct lattice *lattice = body->lattice;
    double square = 0;
    for (int k = 0; k < COMPONENTS; k++) {
        const int b = k % 3;
        if (!m->axis[b]) continue;
        const double density = macroscopic_force(m, body, k) / lattice->node_volume;
        square += 2 * density * density * lattice_places(lattice, b) / (double)lattice->n_sites;
    }
    return sqrt(square);
}

double macroscopic_take_work(struct macroscopic *m, const struct body *body, bool moving)
{
    double work = 0;
    for (int k = 0; k < COMPONENTS; k++) {
        const double stress = m->component[k].given || !moving
                                  ? 0.5 * (m->stress_before[k] + body->mean_stress[k])
                                  : 0.5 * (m->target_before[k] + m->target[k]);
        work += stress * (body->mean_gradient[k] - m->before[k]);
    }
    memcpy(m->target_before, m->target, sizeof m->target_before);
    memcpy(m->before, body->mean_gradient, sizeof m->before);
    memcpy(m->stress_before, body->mean_stress, sizeof m->stress_before);
    return work * m->volume;
}

double macroscopic_step_work(const struct macroscopic *m, const struct body *body, double dt)
{
    double work = 0;
    for (int k = 0; k < COMPONENTS; k++)
        work += body->mean_stress[k] *
                (m->component[k].given ? m->way[k] : dt * body->mean_rate[k]) * m->volume;
    return work;
}

void macroscopic_rest(struct macroscopic *m, struct body *body)
{
    for (int k = 0; k < COMPONENTS; k++) {
        if (m->component[k].given) continue;
        body->mean_rate[k] = 0;
        m->stress_before[k] = m->target[k];
    }
}

double macroscopic_full_rate(const struct macroscopic *m)
{
    const struct value *value = m->component[0].value;
    if (m->component[0].kind != MACROSCOPIC_RATE || !value) return 0;
    return value->kind == VALUE_CONSTANT || value->kind == VALUE_RAMP ? value->number : 0;
}

double macroscopic_largest_rate(const struct macroscopic *m, double time)
{
    double most = 0;
    for (int k = 0; k < COMPONENTS; k++)
        if (m->component[k].kind == MACROSCOPIC_RATE) most = fmax(most, fabs(value_of(m, k, time)));
    return most;
}

double macroscopic_ramp(const struct macroscopic *m)
{
    return m->component[0].value ? m->component[0].value->ramp : 0;
}

void macroscopic_visit(struct macroscopic *m, struct body *body, struct checkpoint *checkpoint)
{
    checkpoint_numbers(checkpoint, "mean gradient", body->mean_gradient, COMPONENTS);
    checkpoint_numbers(checkpoint, "mean stress", body->mean_stress, COMPONENTS);
    checkpoint_numbers(checkpoint, "sense of the mean gradient", &m->sense, 1);
    checkpoint_numbers(checkpoint, "mean rate", body->mean_rate, COMPONENTS);
    checkpoint_numbers(checkpoint, "given mean stress", m->target, COMPONENTS);
    checkpoint_numbers(checkpoint, "given mean stress before", m->target_before, COMPONENTS);
    checkpoint_numbers(checkpoint, "ways of the mean gradient", m->way, COMPONENTS);
    checkpoint_numbers(checkpoint, "mean gradient before", m->before, COMPONENTS);
    checkpoint_numbers(checkpoint, "mean stress before", m->stress_before, COMPONENTS);
}
