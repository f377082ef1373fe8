/* loads.h - forces from outside on the body: densities, or totals spread evenly over the volume of
 * a selection.  Loads add up; body->b holds their sum. */
#ifndef HS_LOADS_H
#define HS_LOADS_H

#include "members.h"
#include "scene.h"

struct checkpoint;

struct load {
    int direction;
    struct value value; /* N or N/m^3; the scene frees it */
    double share; /* of the value that is the density: 1, or one over the volume of all nodes, with
                   * that of their images where planes of symmetry make one set of them */
    struct members members;
    double *place[3]; /* [members.count] m; NULL where the value is the same at all of them */
    double *density;  /* N/m^3 now, [members.count] or one for all */
};

struct loads {
    int count;
    struct load *items;
    bool vary;    /* with time, other than by steps */
    bool current; /* body->b is what they are */
};

/* scene: resolved on rank 0.  Makes body->b along the axes that have loads.  Collective. */
struct loads loads_new(const struct scene *scene, struct body *body);
void loads_free(struct loads *loads);

/* body->b at a time. */
void loads_set(struct loads *loads, struct body *body, double time);

/* Adds the work of all loads while the body moves with body->v for a duration [s]. */
void loads_add_work(const struct loads *loads, const struct body *body, double duration,
                    struct exact_sum *work);

/* Raises stepped loads that are due (value_raise); true where one has been raised. */
bool loads_raise(struct loads *loads, int64_t steps, bool equilibrium);

/* How far stepped ones have been raised, and what acts on the body at this time.  Collective. */
void loads_visit(struct loads *loads, struct body *body, double time,
                 struct checkpoint *checkpoint);

#endif
