/* relaxation.c - equilibrium by adaptive dynamic relaxation: explicit steps of a motion with
 * fictitious masses, damped as its own frequency asks for.
 *
 *   m x'' + c m x' = -g, steps of length 1:  v' = [(2 - c) v - 2 g/m]/(2 + c),  x' = x + v'
 *                                                                                    (relaxation.1)
 *   c = 2 [v.(g' - g)/(v.m v)]^1/2                                                   (relaxation.2)
 *
 * Underwood, in Computational Methods for Transient Analysis (1983) 245; Kilic, Madenci, Theor.
 * Appl. Fract. Mech. 53 (2010) 194.  c damps the frequency of the motion that is left critically:
 * its square is Rayleigh's quotient, here of the velocity; of the displacement, as in those works,
 * it takes more steps.  The masses make a step of length 1 stable (equilibrium.3); should the
 * quotient still come near its bound, they grow. */
#include "checkpoint.h"
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct relaxation {
    double *v, *mv, *change;
    double heavier; /* masses over those of (equilibrium.3) */
};

static void *relaxation_start(const struct equilibrium *e)
{
    struct relaxation *self = memory_new(1, sizeof *self);
    self->v = vector_new(&e->unknowns);
    self->mv = vector_new(&e->unknowns);
    self->change = vector_new(&e->unknowns);
    self->heavier = 1;
    return self;
}

static void relaxation_free(void *object)
{
    struct relaxation *self = object;
    free(self->v);
    free(self->mv);
    free(self->change);
    free(self);
}

static void relaxation_visit(void *object, struct checkpoint *checkpoint)
{
    struct relaxation *self = object;
    checkpoint_numbers(checkpoint, "relaxation: masses", &self->heavier, 1);
}

/* Rayleigh's quotient of (relaxation.2); change: g' - g. */
static double quotient(struct relaxation *self, const struct equilibrium *e)
{
    for (int64_t i = 0; i < e->unknowns.length; i++)
        self->mv[i] = self->heavier * e->bound[i] * self->v[i];
    return vector_product(&e->unknowns, self->v, self->change) /
           vector_product(&e->unknowns, self->v, self->mv);
}

static bool relaxation_solve(void *object, struct equilibrium *e)
{
    struct relaxation *self = object;
    const int64_t length = e->unknowns.length;
    bool at_rest = true;
    double c = 0;
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        for (int64_t i = 0; i < length; i++) {
            const double pull = e->g[i] / (self->heavier * e->bound[i]);
            self->v[i] = at_rest ? -0.5 * pull : ((2 - c) * self->v[i] - 2 * pull) / (2 + c);
            self->change[i] = e->g[i];
            e->x[i] += self->v[i];
        }
        equilibrium_evaluate(e, e->x, e->g);
        for (int64_t i = 0; i < length; i++) self->change[i] = e->g[i] - self->change[i];
        const double square = quotient(self, e);
        at_rest = square > 0.9 * 4;
        if (at_rest) self->heavier *= 1.5;
        c = square > 0 ? fmin(2 * sqrt(square), 1.9) : 0;
    }
    return true;
}

const struct equilibrium_method equilibrium_relaxation = {
    .usual_evaluations = 20000,
    .start = relaxation_start,
    .solve = relaxation_solve,
    .visit = relaxation_visit,
    .free = relaxation_free,
};
