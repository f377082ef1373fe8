/* The explicit course: steps of a length that the fastest wave sets. */
#include "explicit_steps.h"

#include "simulation_parts.h"
#include "stable_step.h"
#include "verlet.h"

#include <math.h>

enum { LOOK_EVERY = 16 }; /* steps from one look at the energies to the next, at most */

void explicit_find_step(struct simulation *s)
{
    const double critical = stable_step(s->model, &s->body, &s->materials);
    if (!isfinite(critical)) return; /* nothing pulls any more: fragments fly on */
    s->explicit_steps.critical = critical;
    s->integration.dt = s->scene.safety * s->explicit_steps.critical;
}

void explicit_begin(struct simulation *s)
{
    s->explicit_steps.deformation = simulation_deformation(s);
    s->explicit_steps.broken = damage_broken_bonds(s->damage);
}

/* The step changes with the shape of the lattice, and where correspondence has lost bonds; it is found again each 5 % of
 * strain, and each hundredth of the bonds.  When that is looked at does not depend on what the deck asks to see. */
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

/* Stepped loads grow after what there is to see of the step has been seen.  At equilibrium the kinetic energy
 * has stayed below a thousandth of the internal one while a wave would have run there and back. */
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

/* Whether the gauge has got to its end since the last record, which lie up to a hundredth of the run apart. */
static bool gauge_at_end(struct simulation *s)
{
    return s->scene.end_strain > 0 && s->strain > 0.9 * s->scene.end_strain &&
           simulation_deformation(s) >= s->scene.end_strain;
}

/* One step, and what it leaves behind. */
void explicit_advance(struct simulation *s)
{
    const bool recording = record_due(s) || near_end(s) || s->explicit_steps.ending,
               framing = simulation_frame_due(s),
               looking = recording || framing || (s->integration.step + 1) % LOOK_EVERY == 0;
    verlet_step(&s->integration, &s->body, &s->boundary, s->model, looking, recording);
    s->explicit_steps.looked = looking;
    if (looking) {
        s->drift = energy_drift(&s->integration.balance);
        s->failure = simulation_find_failure(s);
        if (s->failure) return;
    }
    if (recording)
        simulation_record(s);
    else if (looking)
        s->explicit_steps.ending = gauge_at_end(s);
    check_step(s);
    if (framing || (s->fields && simulation_at_end(s))) simulation_write_frame(s);
    raise_loads(s, looking);
}

const struct course course_explicit = {
    .moving = true, .begin = explicit_begin, .advance = explicit_advance};
