/* boundary.h - node sets whose velocity is prescribed along an axis: the grips. */
#ifndef HS_BOUNDARY_H
#define HS_BOUNDARY_H

#include "domain.h"
#include "members.h"
#include "scene.h"

struct boundary_set {
    const char *name;
    int direction;
    double velocity; /* m/s, after the ramp */
    struct members members;
    double inner;          /* x of the set's layer nearest to the body's middle, m */
    double mass;           /* of the whole set, kg; the integrator fills it */
    struct exact_sum zero; /* empty sum of forces */
    double moved;          /* along its direction so far, m */
    double total_force;    /* at the end of the step, over all ranks, N */
    double force_before;   /* the same a step earlier, N */
};

struct boundary {
    int count;
    struct boundary_set *sets;
    double ramp; /* s; 0 for none */
    int left,
        right; /* of the sets along x: the one with the lowest and the highest mean x, or -1 */
};

/* largest_stress [Pa] bounds the reactions.  domain: rank 0's.  Collective. */
struct boundary boundary_new(const struct scene *scene, const struct body *body,
                             const struct domain *domain, double largest_stress);
void boundary_free(struct boundary *boundary);

/* Factor on the velocities at time t: 10 s^3 - 15 s^4 + 6 s^5 with s = t/ramp, then 1; its first and
 * second derivatives vanish at both ends. */
double boundary_factor(const struct boundary *boundary, double time);

/* Sets the prescribed components of body->v to their values at the time. */
void boundary_set_velocities(const struct boundary *boundary, struct body *body, double time);

/* This rank's part of the reactions, the force each set exerts on the body along its direction:
 * sums[count], to be finished over all ranks. */
void boundary_reactions(const struct boundary *boundary, const struct body *body,
                        struct exact_sum *sums);

/* Initial velocity field of the body: along x linear between the grips, across it the contraction of
 * uniaxial stress.  poissons_ratio: of the mean material. */
void boundary_affine_start(const struct boundary *boundary, struct body *body,
                           double poissons_ratio);

/* Nominal strain rate between the grips [1/s], 0 where there are not two. */
double boundary_strain_rate(const struct boundary *boundary);

#endif
