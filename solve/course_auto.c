/* The course of a run whose deck leaves it open: of load steps and explicit ones the cheaper that
 * keeps the accuracy, by numbers that follow from the scene alone, so that a restart and any number
 * of ranks choose alike.
 *
 *   error of explicit steps = 0.06 (l/2c)/(e/|rate|)                                       (auto.1)
 *
 * A wave takes l/2c from a grip to the middle, and the test e/|rate| to the strain of the first
 * yield, or to its end: there the body moves no longer as it would at rest, which sets waves off,
 * whose force is the largest error.  The 0.06 is measured, of bars and harmonic plates at 0.5 to
 * 5 m/s, of which it is the upper end: they have 0.02 to 0.065. */
#include "explicit_steps.h"

#include "die.h"
#include "memory.h"
#include "simulation_parts.h"
#include "stable_step.h"
#include "yield.h"

#include <math.h>
#include <stdlib.h>

static const double ERROR_OF_WAVES = 0.06; /* (auto.1) */

/* What a step costs, in forces. */
static const double COST_EXPLICIT = 1.15, COST_STATIC = 1.5;

/* (auto.1); INFINITY where no rate of the test is known. */
static double error_of_inertia(const struct simulation *s)
{
    const double rate = fabs(boundary_full_strain_rate(&s->boundary)),
                 strain = fmin(yield_first_strain(&s->materials), rate * s->end_time),
                 speed = materials_wave_speed(&s->materials) / sqrt(s->scene.mass_scaling),
                 way = lattice_extent(&s->lattice, s->lattice.axis);
    return rate > 0 ? ERROR_OF_WAVES * 0.5 * way / speed * rate / strain : INFINITY;
}

static double explicit_forces(struct simulation *s)
{
    s->explicit_steps.critical = stable_step(s->model, &s->body, &s->materials);
    return s->end_time / explicit_length(s);
}

static char *words_for(double error)
{
    return isfinite(error) ? memory_print("errors of %.2g %% by inertia", 100 * error)
                           : memory_text("an error by inertia that no rate of strain tells");
}

static const struct course *auto_choose(struct simulation *s)
{
    const double accuracy = s->scene.statics.accuracy, error = error_of_inertia(s),
                 moving = explicit_forces(s), resting = static_evaluations(s);
    const bool cheaper = COST_EXPLICIT * moving < COST_STATIC * resting,
               explicitly = cheaper && error <= accuracy;
    if (s->ranks.rank == 0) {
        char *inertia = words_for(error);
        note("auto takes %s: about %.0f forces by load steps, %.3g by explicit ones with %s, where "
             "accuracy asks for %.2g %%",
             explicitly ? "explicit steps" : "load steps", resting, moving, inertia,
             100 * accuracy);
        free(inertia);
    }
    return explicitly ? &course_explicit : &course_quasi_static;
}

const struct course course_auto = {.choose = auto_choose};
