/* The hybrid course: load steps as long as the test is slow, explicit steps through what is fast.
 *
 * Displacements, plastic states and broken bonds are the same for both; what changes is that nodes
 * have velocities.  They start with those of a short last load step, so that no wave is sent out:
 * the test goes on as it went, at the speed that the deck gives the grips. */
#include "balance.h"
#include "checkpoint.h"
#include "die.h"
#include "memory.h"
#include "simulation_parts.h"

#include <math.h>

/* Since when the motion is small [s], and the bonds broken by then. */
struct quiet {
    double since, broken;
};

static void hybrid_begin(struct simulation *s)
{
    s->own = memory_new(1, sizeof(struct quiet));
}

/* What calls for explicit steps, or NULL. */
static const char *event(struct simulation *s)
{
    const struct scene_hybrid *hybrid = &s->scene.hybrid;
    if (hybrid->at_damage && (damage_grow(s->damage) > 0 || damage_find(s->damage)))
        return "something breaks";
    if (hybrid->at_maximum && simulation_grip_load(s) < (1 - 1e-4) * s->highest_load)
        return "the load falls";
    if (s->strain >= hybrid->strain) return "the strain is reached";
    return NULL;
}

/* The rate of the last load step is its mean; that of a short one is the rate now.  It is the
 * second that counts: what flows at a stress of the step before (flowing.3) begins the first one
 * late. */
static void find_rate(struct simulation *s)
{
    const double dt = s->integration.dt,
                 shorter = fmin(dt, 0.02 * s->load_steps.quasi_static->largest);
    for (int k = 0; k < 2; k++) {
        s->integration.dt = shorter;
        if (static_load(s)) continue;
        s->integration.dt = dt;
        return;
    }
}

static void begin_explicit(struct simulation *s, const char *reason)
{
    struct integration *integration = &s->integration;
    quasi_static_velocities(s->load_steps.quasi_static);
    boundary_set_velocities(&s->boundary, &s->body, integration->time, integration->dt);
    explicit_find_step(s);
    integration->moving = true;
    integration->residual = 0;
    balance_motion(integration, &s->body, &s->boundary);
    explicit_begin(s);
    *(struct quiet *)s->own = (struct quiet){integration->time, s->explicit_steps.broken};
    if (s->ranks.rank == 0)
        note("explicit from strain %.4g, t = %.4g s, %.0f forces: %s", s->strain, integration->time,
             (double)integration->evaluations, reason);
}

/* Whether the motion has died down, and no bond broke for a while. */
static bool is_quiet(struct simulation *s)
{
    const struct energy_balance *balance = &s->integration.balance;
    const struct scene_hybrid *hybrid = &s->scene.hybrid;
    struct quiet *quiet = s->own;
    const double broken = damage_broken_bonds(s->damage);
    if (broken > quiet->broken ||
        balance->kinetic > hybrid->kinetic_share * energy_internal(balance)) {
        *quiet = (struct quiet){s->integration.time, broken};
    }
    return hybrid->kinetic_share > 0 && s->integration.time - quiet->since > hybrid->quiet;
}

/* What is left of the motion, and what the body loses until it is at rest, counts as damped. */
static void begin_static(struct simulation *s)
{
    struct integration *integration = &s->integration;
    integration->moving = false;
    s->load_steps.quasi_static->lasted = 0;
    body_clear(&s->body, s->body.v, 3);
    boundary_stop(&s->boundary);
    if (s->boundary.macroscopic) macroscopic_rest(s->boundary.macroscopic, &s->body);
    balance_motion(integration, &s->body, &s->boundary);
    const double lost = quasi_static_settle(s->load_steps.quasi_static);
    if (!isfinite(lost)) {
        s->failure =
            memory_print("no equilibrium at t = %.4g s after the explicit steps (residual "
                         "%.2g, tolerance %g)",
                         integration->time, equilibrium_residual(s->load_steps.equilibrium),
                         s->load_steps.equilibrium->tolerance);
        return;
    }
    integration->balance.damping += lost;
    const struct scene_static *statics = &s->scene.statics;
    integration->dt = static_step(s, fmax(statics->first_step, 0.02 * statics->largest_step));
    simulation_record(s);
    s->highest_load = simulation_grip_load(s);
    if (s->ranks.rank == 0)
        note("load steps from strain %.4g, t = %.4g s, %.0f forces", s->strain, integration->time,
             (double)integration->evaluations);
}

static void hybrid_advance(struct simulation *s)
{
    if (s->integration.moving) {
        explicit_advance(s);
        /* Only where the energies are known: what the body then loses until it is at rest is a
         * difference to them. */
        const bool quiet = !s->failure && is_quiet(s);
        if (quiet && s->explicit_steps.looked) begin_static(s);
        return;
    }
    if (!static_load(s)) {
        if (s->load_steps.equilibrium->cut) return;
        begin_explicit(s, "no equilibrium with the smallest step");
        return;
    }
    const char *reason = event(s);
    if (reason) {
        find_rate(s);
        begin_explicit(s, reason);
    } else {
        static_settle(s);
    }
}

static void hybrid_visit(struct simulation *s, struct checkpoint *checkpoint)
{
    struct quiet *quiet = s->own;
    double values[] = {quiet->since, quiet->broken};
    checkpoint_numbers(checkpoint, "hybrid: quiet since, bonds then", values, 2);
    *quiet = (struct quiet){values[0], values[1]};
}

const struct course course_hybrid = {
    .begin = hybrid_begin, .advance = hybrid_advance, .visit = hybrid_visit};
