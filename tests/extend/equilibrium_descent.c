/* descent.c - equilibrium by preconditioned descent, x -= t M^-1 g, with the length t of Barzilai
 * and Borwein, IMA J. Numer. Anal. 8 (1988) 141. */
#include "direction.h"
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

struct descent {
    float *z;
};

static void *start(const struct equilibrium *e)
{
    struct descent *self = memory_new(1, sizeof *self);
    self->z = direction_new(&e->unknowns);
    return self;
}

static void release(void *object)
{
    struct descent *self = object;
    free(self->z);
    free(self);
}

static bool solve(void *object, struct equilibrium *e)
{
    struct descent *self = object;
    const struct unknowns *unknowns = &e->unknowns;
    double t = 0.5;
    equilibrium_precondition(e, e->g, self->z);
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        const double slope = direction_product(unknowns, self->z, e->g);
        direction_add(unknowns, -t, self->z, e->x);
        equilibrium_evaluate(e, e->x, e->g);
        const double end = direction_product(unknowns, self->z, e->g);
        t = slope > end ? t * slope / (slope - end) : 0.5;
        equilibrium_precondition(e, e->g, self->z);
    }
    return true;
}

const struct equilibrium_method equilibrium_descent = {
    .usual_evaluations = 2000,
    .preconditions = true,
    .start = start,
    .solve = solve,
    .free = release,
};
