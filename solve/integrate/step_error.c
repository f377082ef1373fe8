#include "step_error.h"

#include "checkpoint.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PART = 1.0 / 24; /* of D that stays as an error */
static const double MEMORY = 9;      /* elastic strains after which flow has forgotten */
static const double LEAST_FLOW =
    0.3; /* of the largest force, where the load passes through nothing */
static const double UNBALANCED = 0.2; /* of the residual's tolerance, that forces may differ by */
static const double SHARE = 0.35;     /* of what is left of the accuracy, for one step */
static const double BREAKING = 5;     /* accuracies, for one at whose end bonds break */

struct step_error step_error_new(double accuracy, double breaking, const struct boundary *boundary)
{
    struct step_error e = {
        .accuracy = accuracy, .breaking = breaking, .count = boundary_holds(boundary)};
    double **const arrays[] = {&e.force, &e.now, &e.change, &e.way, &e.stiffest, &e.stiffest_way};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        *arrays[k] = memory_new((size_t)e.count, sizeof(double));
    return e;
}

void step_error_free(struct step_error *e)
{
    free(e->force);
    free(e->now);
    free(e->change);
    free(e->way);
    free(e->stiffest);
    free(e->stiffest_way);
}

static bool measures(const struct step_error *e)
{
    return (e->accuracy > 0 || e->breaking > 0) && e->count > 0;
}

static void find_forces(struct step_error *e, const struct boundary *boundary,
                        const struct body *body)
{
    boundary_forces(boundary, body, e->now);
}

void step_error_start(struct step_error *e, const struct boundary *boundary,
                      const struct body *body)
{
    if (e->started || !measures(e)) return;
    find_forces(e, boundary, body);
    memcpy(e->force, e->now, (size_t)e->count * sizeof(double));
    e->started = true;
}

static double product(int count, const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < count; k++) sum += a[k] * b[k];
    return sum;
}

static double norm(int count, const double *a)
{
    return sqrt(product(count, a, a));
}

/* What is left of an error after a way. */
static double kept(const struct step_error *e, double way, double force, double largest)
{
    const double memory = MEMORY * fmax(force, LEAST_FLOW * largest);
    return memory > 0 ? exp(-way * e->steepest / memory) : 0;
}

/* What one step may add to the error [N]: its share of what is left of the accuracy. */
static double allowed(const struct step_error *e, double way, double force, double largest)
{
    return fmax(SHARE * (e->accuracy * largest - e->error * kept(e, way, force, largest)), 0);
}

/* Share of a step's length at which its error, of the second order, is as large as allowed. */
static double room(const struct step_error *e, double way, double force, double largest)
{
    return e->local > 0 ? sqrt(allowed(e, way, force, largest) / e->local) : INFINITY;
}

/* What the forces did not do as in the step before; where the motion turns back, as in the stiffest
 * one. */
static double missed(const struct step_error *e, const double *way)
{
    const bool back = product(e->count, way, e->way) < 0;
    const double *change = back ? e->stiffest : e->change, *like = back ? e->stiffest_way : e->way,
                 again = product(e->count, way, like) / product(e->count, like, like);
    double square = 0;
    for (int b = 0; b < e->count; b++) {
        const double off = e->now[b] - e->force[b] - again * change[b];
        square += off * off;
    }
    return sqrt(square);
}

double step_error_room(struct step_error *e, const struct boundary *boundary,
                       const struct body *body, double tolerance)
{
    e->local = 0;
    if (!measures(e)) return INFINITY;
    find_forces(e, boundary, body);
    if (!e->predicts || !(e->accuracy > 0)) return INFINITY;
    double *way = memory_new((size_t)e->count, sizeof *way);
    boundary_ways(boundary, way);
    const double far = norm(e->count, way), force = norm(e->count, e->now);
    if (far > 0) e->local = PART * fmax(missed(e, way) - UNBALANCED * tolerance * force, 0);
    free(way);
    return far > 0 ? room(e, far, force, fmax(e->largest, force)) : INFINITY;
}

double step_error_breaking_room(const struct step_error *e)
{
    double square = 0;
    if (!measures(e)) return INFINITY;
    for (int b = 0; b < e->count; b++)
        square += (e->now[b] - e->force[b]) * (e->now[b] - e->force[b]);
    return BREAKING * e->breaking * fmax(e->largest, norm(e->count, e->now)) / sqrt(square);
}

double step_error_take(struct step_error *e, const struct boundary *boundary)
{
    if (!measures(e)) return INFINITY;
    const size_t bytes = (size_t)e->count * sizeof(double);
    boundary_ways(boundary, e->way);
    for (int b = 0; b < e->count; b++) e->change[b] = e->now[b] - e->force[b];
    memcpy(e->force, e->now, bytes);
    const double way = norm(e->count, e->way), force = norm(e->count, e->force);
    e->largest = fmax(e->largest, force);
    e->falls = e->accuracy > 0 && product(e->count, e->change, e->way) < 0;
    e->predicts = way > 0;
    if (!(way > 0)) return INFINITY;
    const double slope = norm(e->count, e->change) / way;
    if (slope > e->steepest) {
        e->steepest = slope;
        memcpy(e->stiffest, e->change, bytes);
        memcpy(e->stiffest_way, e->way, bytes);
    }
    /* A step that was taken because it is short counts no more than it might. */
    e->local = fmin(e->local, allowed(e, way, force, e->largest));
    e->error *= kept(e, way, force, e->largest);
    e->error += e->local;
    return room(e, way, force, e->largest);
}

void step_error_forget(struct step_error *e)
{
    e->started = e->predicts = false;
}

void step_error_visit(struct step_error *e, struct checkpoint *checkpoint)
{
    double numbers[] = {e->largest, e->steepest, e->error};
    checkpoint_numbers(checkpoint, "error of load steps", numbers,
                       (int)(sizeof numbers / sizeof *numbers));
    e->largest = numbers[0];
    e->steepest = numbers[1];
    e->error = numbers[2];
    checkpoint_numbers(checkpoint, "forces of the last load step", e->force, e->count);
    checkpoint_numbers(checkpoint, "their change", e->change, e->count);
    checkpoint_numbers(checkpoint, "ways of the last load step", e->way, e->count);
    checkpoint_numbers(checkpoint, "the largest change", e->stiffest, e->count);
    checkpoint_numbers(checkpoint, "ways in which it was", e->stiffest_way, e->count);
    checkpoint_flag(checkpoint, "load steps have begun", &e->started);
    checkpoint_flag(checkpoint, "load steps are predicted", &e->predicts);
}
