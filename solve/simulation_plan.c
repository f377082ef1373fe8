/* What a run is going to do, in words, before its first step. */
#include "simulation.h"

#include "die.h"
#include "memory.h"
#include "simulation_parts.h"

#include <math.h>
#include <stdlib.h>

/* force: time of one evaluation, s */
static char *explicit_plan(const struct simulation *s, double memory, double force)
{
    char *rate =
        boundary_has_grips(&s->boundary)
            ? memory_print("strain rate %.3g 1/s, ", boundary_full_strain_rate(&s->boundary))
            : memory_text("");
    char *scaled = s->scene.mass_scaling != 1
                       ? memory_print("inertia times %g, ", s->scene.mass_scaling)
                       : memory_text("");
    char *plan = memory_print(
        "step %.3g s (%.2f of the critical %.3g s), about %lld steps to %.3g s; "
        "%s%sfastest wave %.0f m/s; %.0f MB; about %.0f s",
        s->integration.dt, s->scene.safety, s->explicit_steps.critical, (long long)s->n_steps,
        s->end_time, rate, scaled, materials_wave_speed(&s->materials), memory * 1e-6,
        1.15 * force * (double)s->n_steps);
    free(scaled);
    free(rate);
    return plan;
}

static char *static_plan(const struct simulation *s, double memory, double force)
{
    const struct scene_static *statics = &s->scene.statics;
    const double evaluations = static_evaluations(s);
    return memory_print(
        "load steps from %g %sup to %g %s by %s, residual under %g, about %.0f; %.0f MB; about "
        "%.0f "
        "evaluations of the force of %.2g s each: %.2g s, and what breaks comes on top",
        statics->first_step, s->load_steps.stretched ? "s " : "",
        s->load_steps.stretched ? scene_strain_step : statics->largest_step,
        s->load_steps.stretched || s->scene.end_strain > 0 ? "of strain" : "s",
        equilibrium_methods[statics->method], statics->tolerance, static_count(s), memory * 1e-6,
        evaluations, force, evaluations * force);
}

static void tell_phases(const struct simulation *s)
{
    char *phases = memory_text("");
    for (int p = 0; p < s->domain.n_phases; p++)
        phases = memory_append(phases, "%s%s %.1f %%", p ? ", " : "", s->domain.phase_names[p],
                               100 * simulation_fraction(s, p));
    note("%s: %s within a horizon of %g spacings; %s%s", deck_name(s->deck),
         s->materials.formulation->name, s->scene.horizon, phases,
         s->gauge ? " between the gauge planes" : "");
    free(phases);
}

static double count_steps(const struct simulation *s)
{
    return s->course->moving ? (double)s->n_steps : static_count(s);
}

int64_t simulation_records(const struct simulation *s)
{
    const double steps = count_steps(s), wanted = (double)s->scene.history;
    return 1 + (int64_t)(s->course->moving ? fmin(steps, wanted) : steps);
}

static void tell_outputs(const struct simulation *s)
{
    const struct scene_fields *fields = &s->scene.fields;
    const double steps = count_steps(s);
    note("about %lld records of %d columns", (long long)simulation_records(s),
         s->recorder.history.n_columns);
    if (fields->n_variables > 0)
        note("about %.0f frames of %d variables in %s",
             1 + (fields->every ? ceil(steps / (double)fields->every) : (double)fields->frames),
             fields->n_variables, s->arguments->fields ? s->arguments->fields : "no file");
}

void simulation_announce(struct simulation *s)
{
    double start = ranks_clock();
    model_force(s->model, &s->body, (struct force_mode){0}, NULL);
    double force = ranks_clock() - start;
    double memory = ranks_memory();
    if (s->ranks.rank != 0) return;
    if (s->arguments->check) tell_phases(s);
    char *plan = (s->integration.moving ? explicit_plan : static_plan)(s, memory, force);
    note("%lld nodes, %lld bonds, %d ranks; %s", (long long)s->lattice.n_particles,
         (long long)s->n_bonds, s->ranks.size, plan);
    free(plan);
    if (s->body.unsupported > 0 && s->materials.formulation->stress_of == STRESS_OF_NODES)
        warn("%lld nodes have too few neighbours for a deformation gradient and carry no stress",
             (long long)s->body.unsupported);
    if (s->arguments->check) tell_outputs(s);
}
