/* boundary.h - nodes whose motion along an axis is prescribed, as a velocity or as a displacement:
 * the grips among them; and the loads on the body.
 *
 * A prescribed component has its velocity at each half step: the given one, or what brings the
 * displacement to its value at the step's end.  The components of such nodes along other axes are
 * free. */
#ifndef HS_BOUNDARY_H
#define HS_BOUNDARY_H

#include "loads.h"
#include "macroscopic.h"
#include "members.h"
#include "scene.h"

struct boundary_set {
    struct deck_node where; /* of its entry */
    int direction;
    enum scene_kind kind; /* of those that hold */
    struct value value;   /* m/s or m; the scene frees it */
    double sense;         /* of a velocity: 1, or -1 where it goes back */
    struct members members;
    double *place[3];      /* [members.count] m; NULL where the value is the same at all of them */
    double inner;          /* x of the set's layer nearest to the body's middle, m */
    double mass;           /* of the whole set, kg; the integrator fills it */
    struct exact_sum zero; /* empty sum of forces */
    /* Where the value is the same at all nodes: */
    double moved, way;          /* along its direction so far, and in this step, m */
    double speed, speed_before; /* at the end of this step and of the one before, m/s */
    /* Reaction force: the force on the body along the direction, over all ranks, N; now and a step
     * earlier. */
    double reaction, reaction_before;
};

struct boundary {
    int count;
    struct boundary_set *sets;
    uint8_t *held; /* box field: bit a where component a is prescribed; NULL: nowhere */
    /* The grips: of the sets with one motion along the axis of the test that with the lowest and
     * that with the highest mean place; -1 where there are not two, one beside the other. */
    int left, right;
    struct loads loads;
    struct macroscopic *macroscopic; /* of a periodic body; else NULL */
};

/* scene: resolved on rank 0.  largest_stress [Pa] bounds the reactions.  Collective. */
struct boundary boundary_new(const struct scene *scene, struct body *body, double largest_stress);
void boundary_free(struct boundary *boundary);

/* Marks the components that the sets prescribe; part of boundary_new. */
void boundary_mark(struct boundary *boundary, const struct body *body);

/* The displacement at the start, of sets that prescribe it. */
void boundary_set_displacements(const struct boundary *boundary, struct body *body);

/* Sets the prescribed components of body->v to their values at a time between steps of length dt.
 */
void boundary_set_velocities(struct boundary *boundary, struct body *body, double time, double dt);
/* Velocities that are numbers go back (-1) or forth (1). */
void boundary_turn(struct boundary *boundary, double sense);
/* The sets have no speed any more. */
void boundary_stop(struct boundary *boundary);
/* As boundary_set_velocities, for the step from time on: v becomes the displacement of the step
 * over dt. */
void boundary_set_ways(struct boundary *boundary, struct body *body, double time, double dt);

/* This rank's part of the reactions, the force each set exerts on the body along its direction:
 * sums[count], to be finished over all ranks. */
void boundary_reactions(const struct boundary *boundary, const struct body *body,
                        struct exact_sum *sums);

/* What holds the body, as generalised forces [N] and the ways of a step along them [m]: sets, then
 * the given components of a mean gradient.  forces: of the force that is in the body.  forces:
 * Collective. */
int boundary_holds(const struct boundary *boundary);
void boundary_forces(const struct boundary *boundary, const struct body *body, double *forces);
void boundary_ways(const struct boundary *boundary, double *ways);

/* Tensile force along x [N]: the mean of both grips, or that of the mean stress; 0 without. */
double boundary_load(const struct boundary *boundary, const struct body *body);

/* Adds the work, in this share of a step [s] at body->v, of the loads and of the sets with a motion
 * that depends on place; that of the others follows from their reactions. */
void boundary_add_work(const struct boundary *boundary, const struct body *body, double duration,
                       struct exact_sum *work);

/* The work of the sets alone. */
void boundary_add_set_work(const struct boundary *boundary, const struct body *body,
                           double duration, struct exact_sum *work);

/* Initial velocity field of the body: along x linear between the grips, across it the contraction
 * of uniaxial stress, which grows from nothing at the grips over half of the body's width.
 * poissons_ratio: of the mean material.  Without grips nothing. */
void boundary_affine_start(const struct boundary *boundary, struct body *body,
                           double poissons_ratio, double dt);

/* What sets have moved, and their reactions; the loads at this time.  Collective. */
void boundary_visit(struct boundary *boundary, struct body *body, double time,
                    struct checkpoint *checkpoint);

/* Velocity of a set with one motion at a time between steps [m/s]. */
double boundary_speed(const struct boundary_set *set, double time, double dt);

/* Strain rate between the grips at a time between steps [1/s]; 0 without grips. */
double boundary_strain_rate(const struct boundary *boundary, double time, double dt);
/* Strain rate between the grips, or of a periodic body, at full speed [1/s]; 0 where it is not
 * given by numbers. */
double boundary_full_strain_rate(const struct boundary *boundary);

/* Largest strain that velocities of grips, and rates of a periodic body, may give in a step from
 * time on, by those at its start, middle and end; 0 where they are displacements and strains. */
double boundary_stretch(const struct boundary *boundary, double time, double dt);

/* Time in which velocities that are numbers are reached [s]. */
double boundary_ramp(const struct boundary *boundary);

static inline bool boundary_has_grips(const struct boundary *boundary)
{
    return boundary->left >= 0;
}

#endif
