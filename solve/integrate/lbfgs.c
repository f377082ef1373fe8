/* lbfgs.c - equilibrium by the limited-memory BFGS method (Nocedal, Math. Comput. 35 (1980) 773),
 * whose first guess of the inverse stiffness is the preconditioner, scaled to what the last step
 * has shown (Liu, Nocedal, Math. Program. 45 (1989) 503).
 *
 *   d = -H g by the two loops over the pairs s = x' - x, y = g' - g;  x' = x + t d
 *   H_0 = c M^-1,  c = s.y/(y.M^-1 y)
 *
 * z = M^-1 y = w' - w, w = M^-1 g, is kept in place of y: an iteration then preconditions once, and
 * all products that the loops need are differences of s_i.g and z_i.g between iterations, found in
 * one pass and one message; the slope g.d follows from them.  s, z and w are directions in single
 * precision (direction.h): M^-1 is no better, and s is what x moves by, to the last bit.  The step
 * t = 1 stands where the slope has fallen enough; else one secant step follows.
 *
 * The pairs outlive their solution: the stiffness of the next load step is nearly that of the last,
 * and where it is not, six iterations have replaced them. */
#include "checkpoint.h"
#include "direction.h"
#include "equilibrium.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEMORY = 6 }; /* pairs, with the one that an iteration makes */

struct lbfgs {
    const struct unknowns *unknowns;
    int count;                               /* pairs, oldest first */
    double scale;                            /* c */
    float *s[MEMORY], *z[MEMORY], *w, *next; /* next: of the gradient that w follows */
    double *before;                          /* the gradient before the step */
    double s_norm[MEMORY], z_norm[MEMORY];   /* bounds of norms */
    double w_norm;
    double sg[MEMORY], zg[MEMORY], wg; /* s_i.g, z_i.g, w.g */
    double sy[MEMORY][MEMORY];         /* s_i.y_j, i <= j */
    double zy[MEMORY][MEMORY];         /* z_i.y_j, symmetric */
};

static void *lbfgs_start(const struct equilibrium *e)
{
    struct lbfgs *self = memory_new(1, sizeof *self);
    self->unknowns = &e->unknowns;
    for (int k = 0; k < MEMORY; k++) {
        self->s[k] = direction_new(&e->unknowns);
        self->z[k] = direction_new(&e->unknowns);
    }
    self->w = direction_new(&e->unknowns);
    self->next = direction_new(&e->unknowns);
    self->before = vector_new(&e->unknowns);
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
    free(self->next);
    free(self->before);
    free(self);
}

/* Two directions as one vector, number by number, and back. */
static void visit_pair(const struct unknowns *unknowns, struct checkpoint *checkpoint, float *s,
                       float *z)
{
    double *both = vector_new(unknowns);
    float halves[2];
    for (int64_t i = 0; i < unknowns->length; i++)
        memcpy(&both[i], (const float[]){s[i], z[i]}, sizeof halves);
    vector_visit(unknowns, checkpoint, "lbfgs: pair", both);
    for (int64_t i = 0; i < unknowns->length; i++) {
        memcpy(halves, &both[i], sizeof halves);
        s[i] = halves[0];
        z[i] = halves[1];
    }
    free(both);
}

static void lbfgs_visit(void *object, struct checkpoint *checkpoint)
{
    struct lbfgs *self = object;
    int64_t count = self->count;
    checkpoint_numbers(checkpoint, "lbfgs: scale", &self->scale, 1);
    checkpoint_integer(checkpoint, "lbfgs: pairs", &count);
    self->count = (int)count;
    for (int k = 0; k < self->count; k++)
        visit_pair(self->unknowns, checkpoint, self->s[k], self->z[k]);
    checkpoint_numbers(checkpoint, "lbfgs: norms of s", self->s_norm, self->count);
    checkpoint_numbers(checkpoint, "lbfgs: norms of z", self->z_norm, self->count);
    checkpoint_numbers(checkpoint, "lbfgs: s.y", self->sy[0], (int64_t)MEMORY * MEMORY);
    checkpoint_numbers(checkpoint, "lbfgs: z.y", self->zy[0], (int64_t)MEMORY * MEMORY);
}

/* d = -H g; its largest number and the slope d.g. */
static double direction(const struct lbfgs *self, const struct equilibrium *e, float *d,
                        double *slope)
{
    const int n = self->count;
    double alpha[MEMORY], gain[MEMORY], factors[2 * MEMORY + 1] = {-self->scale};
    float *vectors[2 * MEMORY + 1] = {self->w};
    for (int i = n - 1; i >= 0; i--) {
        double sq = self->sg[i];
        for (int j = i + 1; j < n; j++) sq -= alpha[j] * self->sy[i][j];
        alpha[i] = sq / self->sy[i][i];
    }
    for (int i = 0; i < n; i++) {
        double yr = self->zg[i];
        for (int j = 0; j < n; j++) yr -= alpha[j] * self->zy[i][j];
        yr *= self->scale;
        for (int j = 0; j < i; j++) yr += gain[j] * self->sy[j][i];
        gain[i] = alpha[i] - yr / self->sy[i][i];
    }
    *slope = -self->scale * self->wg;
    for (int i = 0; i < n; i++) {
        vectors[1 + i] = self->z[i];
        factors[1 + i] = self->scale * alpha[i];
        vectors[1 + n + i] = self->s[i];
        factors[1 + n + i] = -gain[i];
        *slope += factors[1 + i] * self->zg[i] + factors[1 + n + i] * self->sg[i];
    }
    return direction_combine(&e->unknowns, 1 + 2 * n, factors, vectors, d);
}

static void drop_oldest(struct lbfgs *self)
{
    float *s = self->s[0], *z = self->z[0];
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

/* w, and what is known of it. */
static void precondition(struct lbfgs *self, struct equilibrium *e)
{
    float *next = self->next;
    self->next = self->w;
    self->w = next;
    equilibrium_precondition(e, e->g, self->w);
}

/* The pair of this number has s: finds z and all products.  slope and end: s.g before and behind
 * it; norm: of g before. */
static void complete_pair(struct lbfgs *self, struct equilibrium *e, double slope, double end,
                          double norm)
{
    const struct unknowns *unknowns = &e->unknowns;
    const int k = self->count;
    float *vectors[2 * MEMORY + 1];
    double norms[2 * MEMORY + 1], products[2 * MEMORY + 1], z_before;
    precondition(self, e);
    self->z_norm[k] =
        vector_bound(unknowns, direction_combine(unknowns, 2, (double[]){1, -1},
                                                 (float *[]){self->w, self->next}, self->z[k]));
    self->w_norm += self->z_norm[k];
    int count = 0;
    for (int i = 0; i < k; i++) {
        vectors[count] = self->s[i];
        norms[count++] = self->s_norm[i];
    }
    for (int i = 0; i <= k; i++) {
        vectors[count] = self->z[i];
        norms[count++] = self->z_norm[i];
    }
    vectors[count] = self->w;
    norms[count++] = self->w_norm;
    direction_products(unknowns, 1, &self->z[k], &self->z_norm[k], self->before, norm, &z_before);
    direction_products(unknowns, count, vectors, norms, e->g, e->norm, products);
    for (int i = 0; i < k; i++) {
        self->sy[i][k] = products[i] - self->sg[i];
        self->zy[i][k] = self->zy[k][i] = products[k + i] - self->zg[i];
        self->sg[i] = products[i];
        self->zg[i] = products[k + i];
    }
    self->sy[k][k] = end - slope;
    self->zy[k][k] = products[2 * k] - z_before;
    self->sg[k] = end;
    self->zg[k] = products[2 * k];
    self->wg = products[2 * k + 1];
}

/* x goes along s of the pair at hand, whose bound is known, until its slope has fallen enough;
 * false where the force is not finite.  far: its largest number; slope: at the start, and behind
 * it.  What of s has been gone is returned. */
static double go(struct lbfgs *self, struct equilibrium *e, double far, double *slope)
{
    const struct unknowns *unknowns = &e->unknowns;
    const double farthest = 0.5 * e->body->lattice->spacing, start = *slope, before = e->norm;
    float *d = self->s[self->count];
    double t = far > farthest ? farthest / far : 1, taken = 0, *g = e->g;
    e->g = self->before;
    self->before = g;
    for (int trial = 0;; trial++) {
        direction_add(unknowns, t - taken, d, e->x);
        taken = t;
        equilibrium_evaluate(e, e->x, e->g);
        if (!isfinite(e->norm)) {
            if (trial >= 4) return 0;
            t *= 0.25;
            continue;
        }
        direction_products(unknowns, 1, &d, &self->s_norm[self->count], e->g, e->norm, slope);
        if (fabs(*slope) <= 0.9 * -start || e->norm <= 0.5 * before || trial >= 4) return taken;
        const double secant = t * start / (start - *slope);
        t = *slope > start && isfinite(secant) ? fmin(fmax(secant, 0.1 * t), 4 * t) : 2 * t;
    }
}

/* M^-1 g and the products with g of the pairs at hand, those of the solution before. */
static void begin(struct lbfgs *self, struct equilibrium *e)
{
    const struct unknowns *unknowns = &e->unknowns;
    const int n = self->count;
    float *vectors[2 * MEMORY + 1];
    double norms[2 * MEMORY + 1], products[2 * MEMORY + 1];
    precondition(self, e);
    self->w_norm =
        vector_bound(unknowns, direction_combine(unknowns, 1, (double[]){1}, &self->w, self->next));
    for (int i = 0; i < n; i++) {
        vectors[i] = self->s[i];
        norms[i] = self->s_norm[i];
        vectors[n + i] = self->z[i];
        norms[n + i] = self->z_norm[i];
    }
    vectors[2 * n] = self->w;
    norms[2 * n] = self->w_norm;
    direction_products(unknowns, 2 * n + 1, vectors, norms, e->g, e->norm, products);
    for (int i = 0; i < n; i++) {
        self->sg[i] = products[i];
        self->zg[i] = products[n + i];
    }
    self->wg = products[2 * n];
}

static bool lbfgs_solve(void *object, struct equilibrium *e)
{
    struct lbfgs *self = object;
    begin(self, e);
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        if (self->count == MEMORY) drop_oldest(self);
        const int k = self->count;
        double slope;
        const double far = direction(self, e, self->s[k], &slope), norm = e->norm;
        if (!(slope < 0)) {
            if (k == 0) return false;
            self->count = 0;
            continue;
        }
        self->s_norm[k] = vector_bound(&e->unknowns, far);
        double end = slope;
        const double taken = go(self, e, far, &end);
        if (!(taken > 0)) return false;
        if (taken < 1 || taken > 1) direction_scale(&e->unknowns, taken, self->s[k]);
        self->s_norm[k] *= taken;
        complete_pair(self, e, taken * slope, taken * end, norm);
        /* Curvature, or rounding. */
        if (!(self->sy[k][k] > 1e-6 * taken * -slope)) continue;
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
