/* The explicit course: steps of a length that the fastest wave sets. */
#include "explicit_steps.h"

#include "balance.h"
#include "simulation_parts.h"
#include "stable_step.h"
#include "verlet.h"

#include <math.h>

enum { LOOK_EVERY = 16 }; /* steps from one look at the energies to the next, at most */

double explicit_length(const struct simulation *s)
{
    const struct scene *scene = &s->scene;
    const double stable = scene->safety * s->explicit_steps.critical,
                 rate = fabs(boundary_full_strain_rate(&s->boundary));
    if (scene->end_steps > 0) return stable;
    return fmin(stable, fmin(scene->strain_step / rate, s->end_time / (double)scene->least_steps));
}

void explicit_find_step(struct simulation *s)
{
    const double critical = stable_step(s->model, &s->body, &s->materials);
    if (!isfinite(critical)) return; /* nothing pulls any more: fragments fly on */
    s->explicit_steps.critical = critical;
    s->explicit_steps.length = explicit_length(s);
    balance_set_step(&s->integration, &s->body, &s->boundary, s->explicit_steps.length);
}

void explicit_begin(struct simulation *s)
{
    s->explicit_steps.length = s->integration.dt;
    s->explicit_steps.strain = s->strain;
    s->explicit_steps.since = s->integration.time;
    s->explicit_steps.deformation = simulation_deformation(s);
    s->explicit_steps.broken = damage_broken_bonds(s->damage);
}

/* The step changes with the shape of the lattice, and where correspondence has lost bonds; it is
 * found again each 5 % of strain, and each hundredth of the bonds.  When that is looked at does not
 * depend on what the deck asks to see. */
static void check_step(struct simulation *s)
{
    const int64_t every = s->n_steps / 500 > LOOK_EVERY ? s->n_steps / 500 : LOOK_EVERY;
    if (s->integration.step % every != 0) return;
    const double broken = damage_broken_bonds(s->damage), deformation = simulation_deformation(s);
    if (fabs(deformation - s->explicit_steps.deformation) < 0.05 &&
        broken - s->explicit_steps.broken <= 0.01 * s->n_bonds)
        return;
    s->explicit_steps.deformation = deformation;
    s->explicit_steps.broken = broken;
    explicit_find_step(s);
}

/* Records lie denser at the start, t_n = t_end (n/N)^2, where the elastic slope is measured. */
static bool record_due(const struct simulation *s)
{
    const struct integration *integration = &s->integration;
    const double records = (double)s->scene.history, end = s->end_time;
    double before = floor(records * sqrt(integration->time / end));
    double after = floor(records * sqrt((integration->time + integration->dt) / end));
    return after > before;
}

/* Whether the next step is the last one that a given end leaves. */
static bool near_end(const struct simulation *s)
{
    return simulation_is_end(s, s->integration.step + 1, s->integration.time + s->integration.dt);
}

/* Stepped loads grow after what there is to see of the step has been seen.  At equilibrium the
 * kinetic energy has stayed below a thousandth of the internal one while a wave would have run
 * there and back. */
static void raise_loads(struct simulation *s, bool looking)
{
    const struct energy_balance *balance = &s->integration.balance;
    const double time = s->integration.time, speed = materials_wave_speed(&s->materials);
    double longest = 0;
    if (s->boundary.loads.count == 0) return;
    for (int a = 0; a < 3; a++) longest = fmax(longest, lattice_extent(&s->lattice, a));
    if (looking && balance->kinetic > 1e-3 * energy_internal(balance))
        s->explicit_steps.disturbed = time;
    const bool equilibrium = looking && time - s->explicit_steps.disturbed >= 2 * longest / speed;
    if (integration_raise_loads(&s->integration, &s->body, &s->boundary, equilibrium))
        s->explicit_steps.disturbed = time;
}

/* Whether the gauge may be at its end within two looks; from then on each step has one, whatever is
 * recorded. */
static bool close_to_end(const struct simulation *s)
{
    const struct explicit_steps *steps = &s->explicit_steps;
    const double ahead = 2 * LOOK_EVERY * steps->length;
    return s->scene.end_strain > 0 && (steps->strain > 0.95 * s->scene.end_strain ||
                                       steps->strain + steps->growth * ahead > s->scene.end_strain);
}

/* At the end of a step; what records show does not count, as the deck chooses where they are. */
static void look_at_gauge(struct simulation *s)
{
    struct explicit_steps *steps = &s->explicit_steps;
    const double strain = simulation_deformation(s), time = s->integration.time;
    steps->growth = (strain - steps->strain) / (time - steps->since);
    steps->strain = strain;
    steps->since = time;
}

/* What is left to the end that is given, where the next step would go beyond it: a little more, or
 * rounding would miss it.  Else infinite. */
static double time_left(const struct simulation *s)
{
    enum { A_LITTLE = 1000000 }; /* a part in so many */
    const struct explicit_steps *steps = &s->explicit_steps;
    const double missing = s->scene.end_strain - steps->strain, least = steps->length / A_LITTLE;
    if (s->scene.end_time > 0) return fmax(s->end_time - s->integration.time, least);
    if (!close_to_end(s)) return INFINITY;
    if (missing <= 0) return least;
    const double left = missing / steps->growth * (1 + 1.0 / A_LITTLE);
    return steps->growth > 0 && left < steps->length ? fmax(left, least) : INFINITY;
}

/* Cuts the step that leads to the end, or undoes that; true where it is one. */
static bool cut_step(struct simulation *s)
{
    const double length = s->explicit_steps.length, left = time_left(s);
    balance_set_step(&s->integration, &s->body, &s->boundary, fmin(length, left));
    return s->scene.end_strain > 0 && left < length;
}

/* The end of a strain is no end yet where it has turned out a little farther away. */
static void record_end(struct simulation *s, bool due)
{
    const double before = s->strain;
    simulation_record(s);
    if (due || s->strain >= s->scene.end_strain) return;
    recorder_forget(&s->recorder);
    s->strain = before;
}

/* One step, and what it leaves behind. */
void explicit_advance(struct simulation *s)
{
    const bool cut = cut_step(s), due = record_due(s) || near_end(s), recording = due || cut,
               framing = simulation_frame_due(s),
               turn = (s->integration.step + 1) % LOOK_EVERY == 0,
               looking = recording || framing || turn;
    verlet_step(&s->integration, &s->body, &s->boundary, s->model, looking, recording);
    s->explicit_steps.looked = looking;
    if (looking) {
        s->drift = energy_drift(&s->integration.balance);
        s->failure = simulation_find_failure(s);
        if (s->failure) return;
    }
    if (s->scene.end_strain > 0 && (turn || close_to_end(s))) look_at_gauge(s);
    if (cut)
        record_end(s, due);
    else if (recording)
        simulation_record(s);
    check_step(s);
    if (framing || (s->fields && simulation_at_end(s))) simulation_write_frame(s);
    raise_loads(s, looking);
}

const struct course course_explicit = {
    .moving = true, .begin = explicit_begin, .advance = explicit_advance};
