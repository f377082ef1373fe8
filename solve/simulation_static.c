/* The quasi-static course: load steps, each from one equilibrium to the next. */
#include "memory.h"
#include "simulation_parts.h"

#include <math.h>
#include <string.h>

double simulation_load_step(const struct simulation *s, double step)
{
    return s->scene.end_strain > 0 ? step / boundary_full_strain_rate(&s->boundary) : step;
}

void simulation_start_static(struct simulation *s)
{
    const struct scene_static *statics = &s->scene.statics;
    s->equilibrium = equilibrium_new(statics->method, &s->integration, &s->body, &s->boundary,
                                     s->model, s->scene.solver, &s->materials);
    s->equilibrium->tolerance = statics->tolerance;
    s->equilibrium->most_evaluations = statics->most_evaluations;
    s->quasi_static =
        quasi_static_new(s->equilibrium, simulation_load_step(s, statics->largest_step),
                         simulation_load_step(s, statics->smallest_step));
}

/* Leaves the step in vain where there is no equilibrium. */
bool simulation_load(struct simulation *s)
{
    struct integration *integration = &s->integration;
    if (s->scene.end_time > 0)
        integration->dt = fmin(integration->dt, s->end_time - integration->time);
    const bool framing = simulation_frame_due(s);
    memset(s->axial, 0, (size_t)s->body.grid.n_sites * sizeof(double));
    if (!quasi_static_step(s->quasi_static, s->axial)) return false;
    s->drift = energy_drift(&integration->balance);
    simulation_record(s);
    if (framing || (s->fields && simulation_at_end(s))) simulation_write_frame(s);
    loads_raise(&s->boundary.loads, integration->step, true);
    return true;
}

static void static_advance(struct simulation *s)
{
    if (simulation_load(s)) return;
    s->failure =
        memory_print("no equilibrium with the smallest step, at t = %.4g s after %lld load "
                     "steps (residual %.2g, tolerance %g)",
                     s->integration.time, (long long)s->integration.step,
                     equilibrium_residual(s->equilibrium), s->equilibrium->tolerance);
}

const struct course course_static = {.advance = static_advance};
