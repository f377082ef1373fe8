/* lbfgs.c - equilibrium by the limited-memory BFGS method (Nocedal, Math. Comput. 35 (1980) 773), whose first
 * guess of the inverse stiffness is the preconditioner.
 *
 *   d = -H g by the two loops over the pairs s = x' - x, y = g' - g;  x' = x + t d
 *
 * The products s_i . y_j that the loops need are differences of s_i . g between iterations: an iteration makes
 * two rounds of products, each in one pass and one message.  The step t = 1 stands where the slope g . d has
 * fallen enough; else one secant step follows. */
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEMORY = 6 };

struct lbfgs {
    int count; /* pairs, oldest first */
    double *s[MEMORY + 1], *y[MEMORY + 1], *spare;
    double s_norm[MEMORY + 1], y_norm[MEMORY + 1];
    double sg[MEMORY + 1];             /* s_i . g */
    double sy[MEMORY + 1][MEMORY + 1]; /* s_i . y_j, i <= j */
};

static void *lbfgs_start(const struct equilibrium *e)
{
    struct lbfgs *self = memory_new(1, sizeof *self);
    for (int k = 0; k <= MEMORY; k++) {
        self->s[k] = vector_new(&e->unknowns);
        self->y[k] = vector_new(&e->unknowns);
    }
    self->spare = vector_new(&e->unknowns);
    return self;
}

static void lbfgs_free(void *object)
{
    struct lbfgs *self = object;
    for (int k = 0; k <= MEMORY; k++) {
        free(self->s[k]);
        free(self->y[k]);
    }
    free(self->spare);
    free(self);
}

/* d = -H g */
static void direction(struct lbfgs *self, struct equilibrium *e, double *d)
{
    const struct unknowns *unknowns = &e->unknowns;
    const int n = self->count;
    double alpha[MEMORY + 1], minus[MEMORY + 1], products[MEMORY + 1], gain[MEMORY + 1];
    double *q = self->spare;
    memcpy(q, e->g, (size_t)unknowns->length * sizeof *q);
    for (int i = n - 1; i >= 0; i--) {
        double sq = self->sg[i];
        for (int j = i + 1; j < n; j++) sq -= alpha[j] * self->sy[i][j];
        alpha[i] = sq / self->sy[i][i];
        minus[i] = -alpha[i];
    }
    vector_add_all(unknowns, n, minus, self->y, q);
    equilibrium_precondition(e, q, d);
    const double norm = vector_norm(unknowns, d);
    vector_products(unknowns, n, self->y, self->y_norm, d, norm, products);
    for (int i = 0; i < n; i++) {
        double yr = products[i];
        for (int j = 0; j < i; j++) yr += gain[j] * self->sy[j][i];
        gain[i] = alpha[i] - yr / self->sy[i][i];
    }
    vector_add_all(unknowns, n, gain, self->s, d);
    vector_scale(unknowns, -1, d);
}

static void drop_oldest(struct lbfgs *self)
{
    double *s = self->s[0], *y = self->y[0];
    for (int i = 1; i < self->count; i++) {
        self->s[i - 1] = self->s[i];
        self->y[i - 1] = self->y[i];
        self->s_norm[i - 1] = self->s_norm[i];
        self->y_norm[i - 1] = self->y_norm[i];
        self->sg[i - 1] = self->sg[i];
        for (int j = i; j < self->count; j++) self->sy[i - 1][j - 1] = self->sy[i][j];
    }
    self->count--;
    self->s[self->count] = s;
    self->y[self->count] = y;
}

/* The products of all s with the new g, and by difference those with the new y. */
static void update_products(struct lbfgs *self, struct equilibrium *e)
{
    const int n = self->count;
    double before[MEMORY + 1];
    memcpy(before, self->sg, sizeof before);
    vector_products(&e->unknowns, n, self->s, self->s_norm, e->g, e->norm, self->sg);
    for (int i = 0; i < n; i++) self->sy[i][n - 1] = self->sg[i] - before[i];
}

static bool lbfgs_solve(void *object, struct equilibrium *e)
{
    struct lbfgs *self = object;
    const struct unknowns *unknowns = &e->unknowns;
    const size_t bytes = (size_t)unknowns->length * sizeof(double);
    const double farthest = 0.5 * e->body->lattice->spacing;
    self->count = 0;
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->most_evaluations || !isfinite(e->norm)) return false;
        if (self->count == MEMORY) drop_oldest(self);
        double *d = self->s[self->count], *y = self->y[self->count];
        direction(self, e, d);
        const double d_norm = vector_norm(unknowns, d), far = vector_largest(unknowns, d);
        double slope, end;
        vector_products(unknowns, 1, &d, &d_norm, e->g, e->norm, &slope);
        if (!(slope < 0)) {
            if (self->count == 0) return false;
            self->count = 0;
            continue;
        }
        double t = far > farthest ? farthest / far : 1, taken = 0;
        const double before = e->norm;
        memcpy(y, e->g, bytes);
        for (int trial = 0;; trial++) {
            vector_add(unknowns, t - taken, d, e->x);
            taken = t;
            equilibrium_evaluate(e, e->x, e->g);
            if (!isfinite(e->norm)) {
                if (trial >= 4) return false;
                t *= 0.25;
                continue;
            }
            vector_products(unknowns, 1, &d, &d_norm, e->g, e->norm, &end);
            if (fabs(end) <= 0.9 * -slope || e->norm <= 0.5 * before || trial >= 4) break;
            const double secant = t * slope / (slope - end);
            t = end > slope && isfinite(secant) ? fmin(fmax(secant, 0.1 * t), 4 * t) : 2 * t;
        }
        for (int64_t i = 0; i < unknowns->length; i++) y[i] = e->g[i] - y[i];
        vector_scale(unknowns, taken, d);
        self->s_norm[self->count] = fabs(taken) * d_norm;
        self->y_norm[self->count] = vector_norm(unknowns, y);
        self->sg[self->count] = taken * slope;
        self->count++;
        update_products(self, e);
        const double curvature = self->sy[self->count - 1][self->count - 1];
        if (!(curvature > 1e-10 * self->s_norm[self->count - 1] * self->y_norm[self->count - 1]))
            self->count--;
    }
    return true;
}

const struct equilibrium_method equilibrium_lbfgs = {
    .name = "lbfgs",
    .start = lbfgs_start,
    .solve = lbfgs_solve,
    .free = lbfgs_free,
};
