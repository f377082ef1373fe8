/* The quasi-static course: load steps, each from one equilibrium to the next. */
#include "load_steps.h"

#include "law.h"
#include "memory.h"
#include "simulation_parts.h"
#include "yield.h"

#include <math.h>

double static_step(const struct simulation *s, double step)
{
    return s->scene.end_strain > 0 ? step / boundary_full_strain_rate(&s->boundary) : step;
}

static const double LONGEST = 1e12; /* s */

/* Seconds in which speeds that are given strain the body by so much from now on; LONGEST where they
 * do not. */
static double time_of_strain(const struct simulation *s, double strain)
{
    const double time = s->integration.time;
    double dt = 1e-15;
    while (dt < LONGEST && boundary_stretch(&s->boundary, time, 2 * dt) <= strain) dt *= 2;
    const double whole = dt * strain / boundary_stretch(&s->boundary, time, dt);
    return whole < 2 * dt && boundary_stretch(&s->boundary, time, whole) <= strain ? whole : dt;
}

void static_first_step(struct simulation *s)
{
    /* Of the elastic part: with this growth three records or more lie between 0.1 and 0.4 of any
     * Rp0.2.  A short test has records, too. */
    static const double share = 1.0 / 80, of_test = 0.01;
    struct scene_static *statics = &s->scene.statics;
    const double yield = share * yield_first_strain(&s->materials);
    const double rate = fabs(boundary_full_strain_rate(&s->boundary));
    if (isfinite(statics->first_step)) return;
    const double largest = time_of_strain(s, scene_strain_step);
    if (s->scene.end_strain > 0) {
        statics->first_step =
            fmin(fmin(yield, of_test * s->scene.end_strain), statics->largest_step);
    } else if (largest < LONGEST) {
        s->load_steps.stretched = true;
        statics->first_step = time_of_strain(s, fmin(yield, scene_strain_step));
        statics->smallest_step = 1e-4 * largest;
        statics->largest_step = rate > 0 ? scene_strain_step / rate : LONGEST;
    } else {
        statics->first_step = statics->largest_step;
        statics->smallest_step = 1e-4 * statics->largest_step;
    }
    statics->smallest_step = fmin(statics->smallest_step, statics->first_step);
}

/* Steps leave no error where no phase remembers its path; those that are counted are as long as the
 * deck says. */
static double accuracy_of_steps(const struct simulation *s)
{
    bool remembers = false;
    for (int i = 0; i < s->materials.count; i++) {
        const struct law *law = s->materials.items[i].law;
        remembers |= law && law->n_states > 0;
    }
    return remembers && !(s->scene.end_steps > 0) ? s->scene.statics.accuracy : 0;
}

/* Those that grow to the largest, and those that the accuracy asks for: of harmonic and random
 * plates and cells to 5 and 10 % 32 to 78 at 1e-3, 280 to 620 at 1e-4 (docs/bench). */
double static_count(const struct simulation *s)
{
    static const double of_accuracy = 0.04;
    const double largest = static_step(s, s->scene.statics.largest_step),
                 accuracy = accuracy_of_steps(s);
    double step = static_step(s, s->scene.statics.first_step), time = 0, count = 0;
    if (s->scene.end_steps > 0) return (double)s->scene.end_steps;
    for (; step < largest && time < s->end_time; step *= QUASI_STATIC_GROWTH, count++) time += step;
    return count + ceil(fmax(s->end_time - time, 0) / largest) +
           (accuracy > 0 ? of_accuracy / accuracy : 0);
}

/* A step takes so many where something flows and where nothing does (docs/bench), by lbfgs. */
double static_evaluations(const struct simulation *s)
{
    static const double plastic = 12, elastic = 5;
    return static_count(s) * (accuracy_of_steps(s) > 0 ? plastic : elastic);
}

void static_start(struct simulation *s)
{
    const struct scene_static *statics = &s->scene.statics;
    s->load_steps.equilibrium =
        equilibrium_new(statics->method, &s->integration, &s->body, &s->boundary, s->model,
                        s->scene.solver, &s->materials);
    s->load_steps.equilibrium->tolerance = statics->tolerance;
    if (statics->most_evaluations > 0)
        s->load_steps.equilibrium->most_evaluations = statics->most_evaluations;
    s->load_steps.quasi_static =
        quasi_static_new(s->load_steps.equilibrium, static_step(s, statics->largest_step),
                         static_step(s, statics->smallest_step), accuracy_of_steps(s),
                         s->scene.end_steps > 0 ? 0 : statics->accuracy);
}

void static_free(struct load_steps *steps)
{
    quasi_static_free(steps->quasi_static);
    equilibrium_free(steps->equilibrium);
}

static char *no_equilibrium(const struct simulation *s, const char *what)
{
    return memory_print(
        "no equilibrium %s, at t = %.4g s, gauge strain %.4g, after %lld load steps "
        "(residual %.2g, tolerance %g): the load is more than the body carries, or it takes a "
        "smaller "
        "solver.smallest_step or more most_evaluations",
        what, s->integration.time, s->strain, (long long)s->integration.step,
        equilibrium_residual(s->load_steps.equilibrium), s->load_steps.equilibrium->tolerance);
}

/* Until the next multiple of the largest step, where motions and loads that are given over time may
 * turn. */
static double time_to_turn(const struct simulation *s)
{
    static const double met = 1e-6; /* steps */
    const double step = s->load_steps.quasi_static->largest, time = s->integration.time;
    return (floor(time / step + met) + 1) * step - time;
}

/* Until the next row of a table of what moves or loads the body. */
static double time_to_row(const struct simulation *s)
{
    static const double met = 1e-9; /* of the time */
    const double time = s->integration.time;
    double next = INFINITY;
    for (int i = 0; i < s->scene.n_boundary; i++)
        next = fmin(next, value_next_row(&s->scene.boundary[i].value, time * (1 + met)));
    for (int i = 0; i < s->scene.n_components; i++)
        next = fmin(next, value_next_row(&s->scene.components[i].value, time * (1 + met)));
    return next - time;
}

/* The last step ends where the run does; at a strain, where the gauge gets there if it goes on as
 * in the last step. */
static double time_left(const struct simulation *s)
{
    enum {
        A_LITTLE_MORE = 1000000
    }; /* a part in so many, or the end would be missed by rounding */
    const double rate = s->load_steps.strain_rate, left = s->scene.end_strain - s->strain;
    if (legs_are(s)) return legs_time_left(s);
    if (s->scene.end_time > 0) {
        const double whole =
            fmin(fmin(s->end_time - s->integration.time, time_to_turn(s)), time_to_row(s));
        return whole /
               ceil(whole / s->integration.dt * (1 - 1.0 / A_LITTLE_MORE)); /* equal steps */
    }
    if (s->load_steps.stretched) return fmin(time_of_strain(s, scene_strain_step), time_to_row(s));
    if (!(s->scene.end_strain > 0 && rate > 0)) return INFINITY;
    return fmax(left / rate * (1 + 1.0 / A_LITTLE_MORE), s->load_steps.quasi_static->smallest);
}

/* Nothing has changed where there is no equilibrium. */
bool static_load(struct simulation *s)
{
    struct integration *integration = &s->integration;
    const double time = integration->time, strain = s->strain;
    integration->dt = fmin(integration->dt, time_left(s));
    s->load_steps.framing = simulation_frame_due(s);
    if (!quasi_static_step(s->load_steps.quasi_static)) return false;
    s->drift = energy_drift(&integration->balance);
    simulation_record(s);
    s->load_steps.lasted = integration->time - time;
    s->load_steps.strain_rate = (s->strain - strain) / s->load_steps.lasted;
    return true;
}

/* The step was too long where the integrity of a node fell by more than was foreseen: a fortieth at
 * the usual accuracy, a tenth at the most; what that leaves of an error is measured
 * (docs/errors.md). */
static void shorten_step(struct simulation *s, double degradation)
{
    static const double of_accuracy = 25, most = 0.1;
    double *dt = &s->integration.dt;
    if (degradation > fmin(of_accuracy * s->scene.statics.accuracy, most))
        *dt = fmax(0.5 * *dt, s->load_steps.quasi_static->smallest);
}

void static_settle(struct simulation *s)
{
    struct quasi_static_damage damage = {.most = (double)s->scene.statics.break_at_once};
    if (!quasi_static_break(s->load_steps.quasi_static, &damage)) {
        s->failure = no_equilibrium(s, "after something broke");
        return;
    }
    shorten_step(s, damage.degradation);
    if (damage.rounds > 0) {
        /* A force with the integrities of the step before is no point of the curve; one at which
         * bonds break is. */
        if (damage.degradation > 0) recorder_forget(&s->recorder);
        s->drift = energy_drift(&s->integration.balance);
        simulation_record(s);
    }
    if (legs_are(s)) legs_look(s);
    if (s->load_steps.framing || (s->fields && simulation_at_end(s))) simulation_write_frame(s);
    loads_raise(&s->boundary.loads, s->integration.step, true);
}

static void static_advance(struct simulation *s)
{
    if (!static_load(s)) {
        s->failure = no_equilibrium(s, "with the smallest step");
        return;
    }
    static_settle(s);
}

const struct course course_quasi_static = {.advance = static_advance};
