#include "legs.h"

#include "checkpoint.h"
#include "memory.h"
#include "simulation_parts.h"
#include "yield.h"

#include <math.h>

enum { ELASTIC_STEPS = 30 };

static const double reached_share = 1e-3; /* of the change of stress of a leg, from its end */

bool legs_are(const struct simulation *s)
{
    return s->scene.programme.count > 0;
}

bool legs_done(const struct simulation *s)
{
    return s->load_steps.legs.leg >= s->scene.programme.count;
}

static const struct leg *leg_of(const struct simulation *s)
{
    return &s->scene.programme.legs[s->load_steps.legs.leg];
}

static double stress_of(const struct simulation *s)
{
    return simulation_grip_load(s) / s->load_steps.legs.section;
}

static bool is_of_stress(const struct simulation *s)
{
    return leg_of(s)->kind == LEG_TO_STRESS;
}

/* What of a way to go is elastic: to a stress the change of it, reloading the change of the
 * unloading, to a strain until the stress is that of the other sign. */
static double elastic_strain(const struct simulation *s)
{
    const struct legs *legs = &s->load_steps.legs;
    const double change = is_of_stress(s)                 ? legs->target - legs->stress
                          : leg_of(s)->kind == LEG_RELOAD ? legs->unloaded_stress - legs->stress
                                                          : 2 * legs->stress;
    return fabs(change) / legs->modulus;
}

/* Whether this leg is to unload, from a strain, and would load on. */
static bool loads_on(const struct simulation *s, double sense)
{
    const struct legs *legs = &s->load_steps.legs;
    const struct leg *leg = leg_of(s);
    return leg->kind == LEG_TO_STRESS && legs->leg > 0 && leg[-1].kind != LEG_TO_STRESS &&
           legs->sense == sense;
}

/* The grips go to the end of the leg that begins here; a turn begins with a short step. */
static void begin_leg(struct simulation *s)
{
    struct legs *legs = &s->load_steps.legs;
    const double sense = legs->sense;
    const struct leg *leg = leg_of(s);
    legs->target = leg->kind == LEG_RELOAD ? legs->unloaded_from : leg->target;
    if (is_of_stress(s)) {
        legs->unloaded_from = legs->strain;
        legs->unloaded_stress = legs->stress;
    }
    const double ahead = legs->target - (is_of_stress(s) ? legs->stress : legs->strain);
    legs->sense = ahead < 0 ? -1 : 1;
    if (loads_on(s, sense) && !s->failure)
        s->failure = memory_print("leg %d of %d of the programme would unload from %.4g MPa to "
                                  "%.4g MPa, which is to load on: unload_to is on the other side",
                                  legs->leg + 1, s->scene.programme.count, 1e-6 * legs->stress,
                                  1e-6 * legs->target);
    if (legs->sense == sense) return;
    legs->turn = legs->strain;
    legs->elastic = elastic_strain(s);
    legs->strain_rate = legs->stress_rate = 0;
    boundary_turn(&s->boundary, legs->sense);
    if (s->integration.step > 0) quasi_static_turn(s->load_steps.quasi_static);
}

/* Whether nothing holds or loads the body but its ends along the test. */
static bool has_free_sides(const struct simulation *s)
{
    const struct macroscopic *m = s->boundary.macroscopic;
    bool sides = s->boundary.loads.count == 0;
    for (int b = 0; b < s->boundary.count; b++)
        sides &= s->boundary.sets[b].direction == s->lattice.axis;
    for (int a = 1; m && a < 3; a++)
        sides &= !m->component[4 * a].given && !m->component[4 * a].value;
    return sides;
}

/* Flow that is the same everywhere and keeps the volume is a way for a body with free sides to
 * yield: what its phases flow at bounds its stress from above. */
static void refuse_unreachable(const struct simulation *s)
{
    static const double sure = 2; /* for what a formulation is too strong by */
    const double strain = MOST_WAYS * programme_way(&s->scene.programme);
    int phase = 0;
    const double flow = yield_strongest(&s->materials, strain, &phase);
    if (!has_free_sides(s)) return;
    for (int i = 0; i < s->scene.programme.count; i++) {
        const struct leg *leg = &s->scene.programme.legs[i];
        if (leg->kind == LEG_TO_STRESS && fabs(leg->target) > sure * flow * exp(strain))
            deck_error(
                deck_get(leg->where, "unload_to"),
                "%g MPa is out of reach: '%s', the strongest phase, flows at %.4g MPa even "
                "at a plastic strain of %.3g, farther than this programme may go, and a body "
                "with free sides bears no more; unload_to less, or go to_strain",
                1e-6 * leg->target, s->materials.items[phase].name, 1e-6 * flow, strain);
    }
}

void legs_begin(struct simulation *s)
{
    struct legs *legs = &s->load_steps.legs;
    double section = attributes_number(&s->domain.attributes, "section_m2", 0);
    ranks_share(&section, sizeof section);
    *legs = (struct legs){.sense = 1, .turn = NAN, .section = section};
    for (int p = 0; p < s->materials.count; p++)
        legs->modulus += simulation_fraction(s, p) * s->materials.items[p].youngs_modulus;
    for (int i = 0; i < s->scene.programme.count; i++)
        if (s->scene.programme.legs[i].kind == LEG_TO_STRESS && !(section > 0))
            deck_error(deck_get(s->scene.solver, "programme"),
                       "the domain does not say its section, which unload_to needs for a stress");
    refuse_unreachable(s);
    begin_leg(s);
}

/* Whether the run is within what is elastic behind a turn. */
static bool is_elastic(const struct legs *legs)
{
    return fabs(legs->strain - legs->turn) < legs->elastic;
}

double legs_time_left(const struct simulation *s)
{
    const double a_little_more = 1 + 1e-6; /* or the end would be missed by rounding */
    const struct legs *legs = &s->load_steps.legs;
    const double missing = legs->target - (is_of_stress(s) ? legs->stress : legs->strain);
    const double rate = is_of_stress(s) ? legs->stress_rate : legs->strain_rate;
    const double smallest = s->load_steps.quasi_static->smallest;
    double left = INFINITY;
    if (rate * missing > 0) left = missing / rate * a_little_more;
    if (is_elastic(legs)) left = fmin(left, static_step(s, legs->elastic / ELASTIC_STEPS));
    return fmax(left, smallest);
}

static bool is_reached(const struct simulation *s)
{
    const struct legs *legs = &s->load_steps.legs;
    if (!is_of_stress(s)) return legs->sense * (legs->strain - legs->target) >= 0;
    return legs->sense * (legs->stress - legs->target) >=
           -reached_share * legs->elastic * legs->modulus;
}

void legs_look(struct simulation *s)
{
    struct legs *legs = &s->load_steps.legs;
    const double stress = stress_of(s);
    if (s->load_steps.lasted > 0) {
        legs->strain_rate = (s->strain - legs->strain) / s->load_steps.lasted;
        legs->stress_rate = (stress - legs->stress) / s->load_steps.lasted;
    }
    legs->strain = s->strain;
    legs->stress = stress;
    while (!legs_done(s) && is_reached(s)) {
        legs->leg++;
        if (!legs_done(s)) begin_leg(s);
    }
}

void legs_visit(struct legs *legs, struct checkpoint *checkpoint)
{
    double values[] = {legs->leg,     legs->sense,         legs->target,         legs->strain,
                       legs->stress,  legs->strain_rate,   legs->stress_rate,    legs->turn,
                       legs->elastic, legs->unloaded_from, legs->unloaded_stress};
    checkpoint_numbers(checkpoint, "programme", values, sizeof values / sizeof *values);
    legs->leg = (int)values[0];
    legs->sense = values[1];
    legs->target = values[2];
    legs->strain = values[3];
    legs->stress = values[4];
    legs->strain_rate = values[5];
    legs->stress_rate = values[6];
    legs->turn = values[7];
    legs->elastic = values[8];
    legs->unloaded_from = values[9];
    legs->unloaded_stress = values[10];
}
