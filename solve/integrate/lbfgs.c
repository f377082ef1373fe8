/* lbfgs.c - equilibrium by the limited-memory BFGS method (Nocedal, Math. Comput. 35 (1980) 773),
 * whose first guess of the inverse stiffness is the preconditioner, scaled to what the last step
 * has shown (Liu, Nocedal, Math. Program. 45 (1989) 503).
 *
 *   d = -H g by the two loops over the pairs s = x' - x, y = g' - g;  x' = x + t d
 *   H_0 = c M^-1,  c = s.y/(y.M^-1 y)
 *
 * z = M^-1 y = w' - w, w = M^-1 g, is kept in place of y: an iteration then preconditions once, and
 * all products that the loops need are differences of s_i.g and z_i.g between iterations, found in
 * one pass and one message; the slope g.d follows from them.  d and w are directions in single
 * precision (direction.h), s and z in sixteen bits (narrow.h): M^-1 is no better, and what 2^-16 of
 * the largest number of s and z misses the next w makes up for.  The step t = 1 stands where the
 * slope has fallen enough; else one secant step follows.
 *
 * The pairs outlive their solution: the stiffness of the next load step is nearly that of the last,
 * and where it is not, eight iterations have replaced them. */
#include "checkpoint.h"
#include "direction.h"
#include "equilibrium.h"
#include "memory.h"
#include "narrow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEMORY = NARROW_MOST / 2 }; /* pairs, with the one that an iteration makes */

struct lbfgs {
    const struct unknowns *unknowns;
    int count;    /* pairs, oldest first */
    double scale; /* c */
    struct narrow s[MEMORY], z[MEMORY];
    float *w, *next, *d;               /* next: of the gradient that w follows, then z */
    double w_most;                     /* largest number of w, at most */
    double sg[MEMORY], zg[MEMORY], wg; /* s_i.g, z_i.g, w.g */
    double sy[MEMORY][MEMORY];         /* s_i.y_j, i <= j */
    double zy[MEMORY][MEMORY];         /* z_i.y_j, symmetric */
};

static void *lbfgs_start(const struct equilibrium *e)
{
    struct lbfgs *self = memory_new(1, sizeof *self);
    self->unknowns = &e->unknowns;
    for (int k = 0; k < MEMORY; k++) {
        self->s[k] = narrow_new(&e->unknowns);
        self->z[k] = narrow_new(&e->unknowns);
    }
    self->w = direction_new(&e->unknowns);
    self->next = direction_new(&e->unknowns);
    self->d = direction_new(&e->unknowns);
    self->scale = 1;
    return self;
}

static void lbfgs_free(void *object)
{
    struct lbfgs *self = object;
    for (int k = 0; k < MEMORY; k++) {
        narrow_free(&self->s[k]);
        narrow_free(&self->z[k]);
    }
    free(self->w);
    free(self->next);
    free(self->d);
    free(self);
}

/* Two directions as one vector, number by number, and back. */
static void visit_pair(const struct unknowns *unknowns, struct checkpoint *checkpoint,
                       struct narrow *s, struct narrow *z)
{
    const int64_t n = 3 * unknowns->n_nodes;
    double *both = vector_new(unknowns), units[] = {s->unit, z->unit};
    float halves[2];
    for (int64_t i = 0; i < n; i++)
        memcpy(&both[i], (float[]){s->numbers[i], z->numbers[i]}, sizeof halves);
    for (int64_t i = n; i < unknowns->length; i++)
        memcpy(&both[i], (float[]){s->mean[i - n], z->mean[i - n]}, sizeof halves);
    checkpoint_numbers(checkpoint, "lbfgs: units", units, 2);
    vector_visit(unknowns, checkpoint, "lbfgs: pair", both);
    s->unit = units[0];
    z->unit = units[1];
    for (int64_t i = 0; i < unknowns->length; i++) {
        memcpy(halves, &both[i], sizeof halves);
        if (i < n) {
            s->numbers[i] = (int16_t)halves[0];
            z->numbers[i] = (int16_t)halves[1];
        } else {
            s->mean[i - n] = halves[0];
            z->mean[i - n] = halves[1];
        }
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
        visit_pair(self->unknowns, checkpoint, &self->s[k], &self->z[k]);
    checkpoint_numbers(checkpoint, "lbfgs: s.y", self->sy[0], (int64_t)MEMORY * MEMORY);
    checkpoint_numbers(checkpoint, "lbfgs: z.y", self->zy[0], (int64_t)MEMORY * MEMORY);
}

/* d = -H g, and the bits of its largest number; the slope d.g. */
static double find_direction(struct lbfgs *self, uint32_t *most)
{
    const int n = self->count;
    double alpha[MEMORY], gain[MEMORY], factors[2 * MEMORY], slope = -self->scale * self->wg;
    const struct narrow *vectors[2 * MEMORY];
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
    for (int i = 0; i < n; i++) {
        vectors[2 * i] = &self->z[i];
        factors[2 * i] = self->scale * alpha[i];
        vectors[2 * i + 1] = &self->s[i];
        factors[2 * i + 1] = -gain[i];
        slope += factors[2 * i] * self->zg[i] + factors[2 * i + 1] * self->sg[i];
    }
    *most = narrow_combine(self->unknowns, -self->scale, self->w, 2 * n, factors, vectors, self->d);
    return slope;
}

static void drop_oldest(struct lbfgs *self)
{
    const struct narrow s = self->s[0], z = self->z[0];
    for (int i = 1; i < self->count; i++) {
        self->s[i - 1] = self->s[i];
        self->z[i - 1] = self->z[i];
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

/* Products with g of so many pairs, and of w. */
static void multiply(struct lbfgs *self, const struct equilibrium *e, int n, double products[])
{
    const struct narrow *vectors[2 * MEMORY];
    for (int i = 0; i < n; i++) {
        vectors[2 * i] = &self->s[i];
        vectors[2 * i + 1] = &self->z[i];
    }
    narrow_products(&e->unknowns, 2 * n, vectors, self->w, self->w_most, e->g, e->norm, products);
}

/* The pair of this number has s: finds z and all products.  slope and end: s.g before and behind
 * it.  As M is symmetric, z times the g before is what w had with it less that of the w before with
 * this one. */
static void complete_pair(struct lbfgs *self, struct equilibrium *e, double slope, double end)
{
    const struct unknowns *unknowns = &e->unknowns;
    const int k = self->count;
    double products[2 * MEMORY + 1], of_nodes;
    precondition(self, e);
    self->w_most += direction_subtract_from(unknowns, self->w, self->next, &of_nodes);
    narrow_take(unknowns, self->next, of_nodes, &self->z[k]);
    multiply(self, e, k + 1, products);
    for (int i = 0; i < k; i++) {
        self->sy[i][k] = products[2 * i] - self->sg[i];
        self->zy[i][k] = self->zy[k][i] = products[2 * i + 1] - self->zg[i];
        self->sg[i] = products[2 * i];
        self->zg[i] = products[2 * i + 1];
    }
    const double zg = products[2 * k + 1], wg = products[2 * k + 2];
    self->sy[k][k] = end - slope;
    self->sg[k] = end;
    self->zg[k] = zg;
    self->zy[k][k] = zg - (wg - zg) + self->wg;
    self->wg = wg;
}

/* x goes along d until its slope has fallen enough; false where the force is not finite.  far: its
 * largest number; slope: at the start, and behind it.  What of d has been gone is returned. */
static double go(struct lbfgs *self, struct equilibrium *e, double far, double *slope)
{
    const double farthest = 0.5 * e->body->lattice->spacing, start = *slope, before = e->norm;
    double t = far > farthest ? farthest / far : 1, taken = 0;
    for (int trial = 0;; trial++) {
        *slope = equilibrium_go(e, t - taken, self->d, far);
        taken = t;
        if (!isfinite(e->norm)) {
            if (trial >= 4) return 0;
            t *= 0.25;
            continue;
        }
        if (fabs(*slope) <= 0.9 * -start || e->norm <= 0.5 * before || trial >= 4) return taken;
        const double secant = t * start / (start - *slope);
        t = *slope > start && isfinite(secant) ? fmin(fmax(secant, 0.1 * t), 4 * t) : 2 * t;
    }
}

/* M^-1 g and the products with g of the pairs at hand, those of the solution before. */
static void begin(struct lbfgs *self, struct equilibrium *e)
{
    double products[2 * MEMORY + 1], of_nodes;
    precondition(self, e);
    self->w_most = direction_largest(&e->unknowns, self->w, &of_nodes);
    multiply(self, e, self->count, products);
    for (int i = 0; i < self->count; i++) {
        self->sg[i] = products[2 * i];
        self->zg[i] = products[2 * i + 1];
    }
    self->wg = products[2 * self->count];
}

static bool iterate(struct lbfgs *self, struct equilibrium *e)
{
    if (isfinite(e->norm)) begin(self, e);
    while (!equilibrium_reached(e)) {
        if (e->evaluations >= e->last || !isfinite(e->norm)) return false;
        if (self->count == MEMORY) drop_oldest(self);
        const int k = self->count;
        uint32_t most;
        const double slope = find_direction(self, &most);
        if (!(slope < 0)) {
            if (k == 0) return false;
            self->count = 0;
            continue;
        }
        double end = slope, of_nodes;
        const double far = direction_largest_of(&e->unknowns, self->d, most, &of_nodes),
                     taken = go(self, e, far, &end);
        if (!(taken > 0)) return false;
        narrow_take(&e->unknowns, self->d, of_nodes, &self->s[k]);
        narrow_scale(taken, &self->s[k]);
        complete_pair(self, e, taken * slope, taken * end);
        /* Curvature, or rounding. */
        if (!(self->sy[k][k] > 1e-6 * taken * -slope)) continue;
        if (self->zy[k][k] > 0) self->scale = self->sy[k][k] / self->zy[k][k];
        self->count++;
    }
    return true;
}

static bool lbfgs_solve(void *object, struct equilibrium *e)
{
    const bool reached = iterate(object, e);
    equilibrium_find_x(e);
    return reached;
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
