/* newton.c - equilibrium by Newton's method, whose linear systems are solved by preconditioned
 * conjugate gradients without a matrix (Knoll, Keyes, J. Comput. Phys. 193 (2004) 357).
 *
 *   K p = [g(x + h p) - g(x)]/h;  |g + K d| <= eta |g|;  x' = x + t d                    (newton.1)
 *
 * K is the tangent with the flow of the step so far.  eta: Eisenstat, Walker, SIAM J. Sci. Comput.
 * 17 (1996) 16. Where a direction has no stiffness, d ends before it (Steihaug, SIAM J. Numer.
 * Anal. 20 (1983) 626). */
#include "direction.h"
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double moved = 2e-6;   /* h max |p|, spacings */
static const double forcing = 0.05; /* eta */

struct newton {
    double *d, *p, *r, *Kp, *beside;
    float *z;
};

static void *newton_start(const struct equilibrium *e)
{
    struct newton *self = memory_new(1, sizeof *self);
    self->d = vector_new(&e->unknowns);
    self->p = vector_new(&e->unknowns);
    self->r = vector_new(&e->unknowns);
    self->z = direction_new(&e->unknowns);
    self->Kp = vector_new(&e->unknowns);
    self->beside = vector_new(&e->unknowns);
    return self;
}

static void newton_free(void *object)
{
    struct newton *self = object;
    free(self->d);
    free(self->p);
    free(self->r);
    free(self->z);
    free(self->Kp);
    free(self->beside);
    free(self);
}

/* Kp = K p, the state at x left as it is known. */
static void multiply(struct newton *self, struct equilibrium *e)
{
    const struct unknowns *unknowns = &e->unknowns;
    const double norm = e->norm, reference = e->reference,
                 h = moved * e->body->lattice->spacing / vector_largest(unknowns, self->p);
    memcpy(self->beside, e->x, (size_t)unknowns->length * sizeof(double));
    vector_add(unknowns, h, self->p, self->beside);
    equilibrium_evaluate(e, self->beside, self->Kp);
    for (int64_t i = 0; i < unknowns->length; i++) self->Kp[i] = (self->Kp[i] - e->g[i]) / h;
    e->norm = norm;
    e->reference = reference;
}

/* d of (newton.1), r what is left of -g. */
static void find_direction(struct newton *self, struct equilibrium *e)
{
    const struct unknowns *unknowns = &e->unknowns;
    const size_t bytes = (size_t)unknowns->length * sizeof(double);
    const double enough = 0.5 * e->tolerance / equilibrium_residual(e),
                 goal = fmax(forcing, enough) * e->norm;
    memset(self->d, 0, bytes);
    memcpy(self->r, e->g, bytes);
    vector_scale(unknowns, -1, self->r);
    memset(self->p, 0, bytes);
    equilibrium_precondition(e, self->r, self->z);
    direction_add(unknowns, 1, self->z, self->p);
    double rz = direction_product(unknowns, self->z, self->r);
    for (int k = 0; e->evaluations < e->last; k++) {
        multiply(self, e);
        const double stiffness = vector_product(unknowns, self->p, self->Kp);
        if (!(stiffness > 0)) {
            if (k == 0) memcpy(self->d, self->p, bytes);
            return;
        }
        vector_add(unknowns, rz / stiffness, self->p, self->d);
        vector_add(unknowns, -rz / stiffness, self->Kp, self->r);
        if (vector_norm(unknowns, self->r) <= goal) return;
        equilibrium_precondition(e, self->r, self->z);
        const double before = rz;
        rz = direction_product(unknowns, self->z, self->r);
        vector_scale(unknowns, rz / before, self->p);
        direction_add(unknowns, 1, self->z, self->p);
    }
}

/* x += t d, t halved until |g| falls; false where it does not. */
static bool go(struct newton *self, struct equilibrium *e)
{
    enum { TRIALS = 9 };
    const double farthest = 0.5 * e->body->lattice->spacing,
                 far = vector_largest(&e->unknowns, self->d), before = e->norm;
    double t = far > farthest ? farthest / far : 1, taken = 0;
    for (int trial = 0; trial < TRIALS; trial++, t *= 0.5) {
        vector_add(&e->unknowns, t - taken, self->d, e->x);
        taken = t;
        if (equilibrium_evaluate(e, e->x, e->g) < before) return true;
    }
    return false;
}

static bool newton_solve(void *object, struct equilibrium *e)
{
    struct newton *self = object;
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        find_direction(self, e);
        if (!go(self, e)) return false;
    }
    return true;
}

const struct equilibrium_method equilibrium_newton = {
    .usual_evaluations = 2000,
    .preconditions = true,
    .start = newton_start,
    .solve = newton_solve,
    .free = newton_free,
};
