/* lbfgs.c - equilibrium by the limited-memory BFGS method (Nocedal, Math. Comput. 35 (1980) 773), whose first
 * guess of the inverse stiffness is the preconditioner, scaled to what the last step has shown (Liu, Nocedal,
 * Math. Program. 45 (1989) 503).
 *
 *   d = -H g by the two loops over the pairs s = x' - x, y = g' - g;  x' = x + t d
 *   H_0 = c M^-1,  c = s.y/(y.M^-1 y)
 *
 * z = M^-1 y = w' - w, w = M^-1 g, is kept in place of y: an iteration then preconditions once, and all products that the
 * loops need are differences of s_i.g and z_i.g between iterations, found in one pass and one message.  The
 * step t = 1 stands where the slope g.d has fallen enough; else one secant step follows. */
#include "checkpoint.h"
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEMORY = 6 }; /* pairs, with the one that an iteration makes */

struct lbfgs {
    int count;    /* pairs, oldest first */
    double scale; /* c */
    double *s[MEMORY], *z[MEMORY], *w, *y;
    double s_norm[MEMORY], z_norm[MEMORY], y_norm; /* bounds of norms */
    double sg[MEMORY], zg[MEMORY];                 /* s_i.g, z_i.g */
    double sy[MEMORY][MEMORY];                     /* s_i.y_j, i <= j */
    double zy[MEMORY][MEMORY];                     /* z_i.y_j, symmetric */
};

static void *lbfgs_start(const struct equilibrium *e)
{
    struct lbfgs *self = memory_new(1, sizeof *self);
    for (int k = 0; k < MEMORY; k++) {
        self->s[k] = vector_new(&e->unknowns);
        self->z[k] = vector_new(&e->unknowns);
    }
    self->w = vector_new(&e->unknowns);
    self->y = vector_new(&e->unknowns);
    self->scale = 1;
    return self;
}

static void lbfgs_free(void *object)
{
    struct lbfgs *self = object;
    for (int k = 0; k < MEMORY; k++) {
        free(self->s[k]);
        free(self->z[k]);
    }
    free(self->w);
    free(self->y);
    free(self);
}

/* The pairs begin anew with each solution, the scale does not. */
static void lbfgs_visit(void *object, struct checkpoint *checkpoint)
{
    struct lbfgs *self = object;
    checkpoint_numbers(checkpoint, "lbfgs: scale", &self->scale, 1);
}

/* d = -H g */
static void direction(const struct lbfgs *self, const struct equilibrium *e, double *d)
{
    const int n = self->count;
    double alpha[MEMORY], minus[MEMORY], gain[MEMORY];
    for (int i = n - 1; i >= 0; i--) {
        double sq = self->sg[i];
        for (int j = i + 1; j < n; j++) sq -= alpha[j] * self->sy[i][j];
        alpha[i] = sq / self->sy[i][i];
        minus[i] = -alpha[i];
    }
    for (int i = 0; i < n; i++) {
        double yr = self->zg[i];
        for (int j = 0; j < n; j++) yr -= alpha[j] * self->zy[i][j];
        yr *= self->scale;
        for (int j = 0; j < i; j++) yr += gain[j] * self->sy[j][i];
        gain[i] = alpha[i] - yr / self->sy[i][i];
    }
    memcpy(d, self->w, (size_t)e->unknowns.length * sizeof *d);
    vector_add_all(&e->unknowns, n, minus, self->z, d);
    vector_scale(&e->unknowns, self->scale, d);
    vector_add_all(&e->unknowns, n, gain, self->s, d);
    vector_scale(&e->unknowns, -1, d);
}

static void drop_oldest(struct lbfgs *self)
{
    double *s = self->s[0], *z = self->z[0];
    for (int i = 1; i < self->count; i++) {
        self->s[i - 1] = self->s[i];
        self->z[i - 1] = self->z[i];
        self->s_norm[i - 1] = self->s_norm[i];
        self->z_norm[i - 1] = self->z_norm[i];
        self->sg[i - 1] = self->sg[i];
        self->zg[i - 1] = self->zg[i];
        for (int j = 1; j < self->count; j++) {
            self->sy[i - 1][j - 1] = self->sy[i][j];
            self->zy[i - 1][j - 1] = self->zy[i][j];
        }
    }
    self->count--;
    self->s[self->count] = s;
    self->z[self->count] = z;
}

/* The pair of this number has s and y: finds z and all products.  slope: s.g before. */
static void complete_pair(struct lbfgs *self, struct equilibrium *e, double slope)
{
    const struct unknowns *unknowns = &e->unknowns;
    const int k = self->count, n = k + 1;
    double *z = self->z[k], *vectors[2 * MEMORY], norms[2 * MEMORY], products[2 * MEMORY];
    memcpy(z, self->w, (size_t)unknowns->length * sizeof *z);
    equilibrium_precondition(e, e->g, self->w);
    for (int64_t i = 0; i < unknowns->length; i++) z[i] = self->w[i] - z[i];
    self->z_norm[k] = vector_bound(unknowns, vector_largest(unknowns, z));
    vector_products(unknowns, 1, &z, &self->z_norm[k], self->y, self->y_norm, &self->zy[k][k]);
    for (int i = 0; i < n; i++) {
        vectors[i] = self->s[i];
        norms[i] = self->s_norm[i];
        vectors[n + i] = self->z[i];
        norms[n + i] = self->z_norm[i];
    }
    vector_products(unknowns, 2 * n, vectors, norms, e->g, e->norm, products);
    for (int i = 0; i < n; i++) {
        self->sy[i][k] = products[i] - (i < k ? self->sg[i] : slope);
        if (i < k) self->zy[i][k] = self->zy[k][i] = products[n + i] - self->zg[i];
        self->sg[i] = products[i];
        self->zg[i] = products[n + i];
    }
}

static bool lbfgs_solve(void *object, struct equilibrium *e)
{
    struct lbfgs *self = object;
    const struct unknowns *unknowns = &e->unknowns;
    const size_t bytes = (size_t)unknowns->length * sizeof(double);
    const double farthest = 0.5 * e->body->lattice->spacing;
    self->count = 0;
    equilibrium_precondition(e, e->g, self->w);
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        if (self->count == MEMORY) drop_oldest(self);
        double *d = self->s[self->count], *y = self->y;
        direction(self, e, d);
        const double far = vector_largest(unknowns, d), d_norm = vector_bound(unknowns, far);
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
        const double y_largest = vector_largest(unknowns, y);
        self->y_norm = vector_bound(unknowns, y_largest);
        complete_pair(self, e, taken * slope);
        const int k = self->count;
        /* Curvature, or rounding: the product of the largest numbers is not beyond that of the norms. */
        if (!(self->sy[k][k] > 1e-10 * fabs(taken) * far * y_largest)) continue;
        if (self->zy[k][k] > 0) self->scale = self->sy[k][k] / self->zy[k][k];
        self->count++;
    }
    return true;
}

const struct equilibrium_method equilibrium_lbfgs = {
    .usual_evaluations = 2000,
    .preconditions = true,
    .next = &equilibrium_newton,
    .start = lbfgs_start,
    .solve = lbfgs_solve,
    .visit = lbfgs_visit,
    .free = lbfgs_free,
};
