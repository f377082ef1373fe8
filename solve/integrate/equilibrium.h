/* equilibrium.h - a body at rest under its loads and held components: the problem, and who solves
 * it.
 *
 *   g(u) = - (f(u) + b) V / mean V = 0 at the free components                       (equilibrium.1)
 *   residual = |g_free| / (|g_held|^2 + |b_free|^2)^1/2                             (equilibrium.2)
 *
 * Of a periodic body the mean stress counts among the held (macroscopic.h).
 *
 * What a falling body still carries is no measure of its forces: the denominator of (equilibrium.2)
 * is at least a hundredth of the largest one so far, and what a strain of 1e-7 throughout would
 * cause.
 *
 *   bound = rho V/mean V/dt^2 * 1.2, dt the critical step of the body with its densities rho
 *                                                                                   (equilibrium.3)
 *
 * f is the force of the material from its last accepted state: nothing is committed here, and
 * damage does not grow.  To add a method: one file, its name in the list of scene.h. */
#ifndef HS_EQUILIBRIUM_H
#define HS_EQUILIBRIUM_H

#include "integration.h"
#include "preconditioner.h"
#include "stop.h"
#include "unknowns.h"

struct checkpoint;
struct equilibrium;

struct equilibrium_method {
    int64_t usual_evaluations; /* at most, of one solution, where the deck says no other number */
    bool preconditions;        /* else it takes equilibrium->bound */
    const struct equilibrium_method *next; /* goes on where this one gives up; NULL: none */
    void *(*start)(const struct equilibrium *equilibrium);
    /* From equilibrium->x, whose g and norm are known, until the residual is below the tolerance
     * (true), or no more evaluations are left, or the motion goes astray.  The force is then that
     * of x. */
    bool (*solve)(void *self, struct equilibrium *equilibrium);
    /* What the next solution takes over from the last one; NULL: nothing. */
    void (*visit)(void *self, struct checkpoint *checkpoint);
    void (*free)(void *self);
};

struct equilibrium {
    struct integration *integration;
    struct body *body;
    struct boundary *boundary;
    struct model *model;
    const struct equilibrium_method *method;
    void *self, *next; /* of the method and the next; NULL: not needed so far */
    double tolerance;
    int64_t most_evaluations; /* of one method for one solution */
    struct unknowns unknowns;
    struct symbol symbol;
    struct preconditioner *preconditioner;       /* NULL: the method does not precondition */
    double mean_inverse[COMPONENTS][COMPONENTS]; /* of the stiffness against the mean gradient's
                                                    unknowns, m^4/N */
    double *weights;        /* [n_nodes] V/mean V, where nodes' volumes differ; else NULL */
    double *bound;          /* of the stiffness as a diagonal, N/m^4; NULL: not needed */
    struct members held;    /* nodes with held components */
    double *x, *g;          /* m, N/m^3 */
    double norm, reference; /* of g; of (equilibrium.2) */
    double largest;         /* reference at any equilibrium so far */
    double loads;           /* |b_free| */
    int64_t evaluations;    /* of this solution so far */
    int64_t last;           /* evaluation at which a method gives up */
    /* Where a solution may be cut off, as its start is kept elsewhere: what asks for that; else
     * NULL. */
    const struct stop *stop;
    bool cut; /* it was, and what it leaves is nothing */
    /* Told of each evaluation, for those who wait; NULL: nobody. */
    void (*watch)(void *watcher, const struct equilibrium *equilibrium);
    void *watcher;
};

/* method: its number in equilibrium_methods.  Collective. */
struct equilibrium *equilibrium_new(int method, struct integration *integration, struct body *body,
                                    struct boundary *boundary, struct model *model,
                                    struct deck_node solver, const struct materials *materials);
void equilibrium_free(struct equilibrium *equilibrium);

/* Held components and loads are as the body has them; the free ones start from equilibrium->x and
 * end there, in body->u, too.  True where the residual is below the tolerance.  Collective. */
bool equilibrium_solve(struct equilibrium *equilibrium);

/* What the next solution takes over.  Collective. */
void equilibrium_visit(struct equilibrium *equilibrium, struct checkpoint *checkpoint);

double equilibrium_residual(const struct equilibrium *equilibrium);

/* For methods: g at x, and its norm; sets the reference.  Collective, all. */
double equilibrium_evaluate(struct equilibrium *equilibrium, const double *x, double *g);
/* equilibrium->g where the body is when it has gone a d further, a direction (direction.h) of which
 * no number is beyond far; d.g is returned, and x found when it is asked for. */
double equilibrium_go(struct equilibrium *equilibrium, double a, const float *d, double far);
void equilibrium_find_x(struct equilibrium *equilibrium);
/* z = M^-1 g (transform.h), a direction (direction.h), and what (equilibrium.3) gives where
 * particles share a site; held components are left as they are, 0. */
void equilibrium_precondition(struct equilibrium *equilibrium, const double *g, float *z);
bool equilibrium_reached(const struct equilibrium *equilibrium);

/* The methods that the deck may name (scene.h): equilibrium_NAME, each in a file of its own. */
#define EQUILIBRIUM_METHOD(name) equilibrium_##name
extern const struct equilibrium_method EQUILIBRIUM_METHODS(EQUILIBRIUM_METHOD);

#endif
