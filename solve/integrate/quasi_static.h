/* quasi_static.h - load steps from one equilibrium to the next.
 *
 * Time is what the prescribed motions and loads depend on; nothing has inertia.  A step that is
 * hard to solve is halved and tried again, an easy one makes the next longer; none is accepted
 * above the tolerance.  Their lengths follow from the error that they leave, too (step_error.h).
 *
 * While an equilibrium is sought, nodes carry what they would if their integrity went on falling as
 * in the step before:
 *
 *   c' = max(c + 0.8 (dt'/dt) min(c - c_before, 0), c/10)                          (quasi_static.1)
 *
 * and get their own with the state that is found (quasi_static_break).  With none of it, what
 * softens flows too little and the rest too much, with all of it the other way round; the errors of
 * the first order cancel at 0.7 to 0.9 (docs/errors.md, load steps). */
#ifndef HS_QUASI_STATIC_H
#define HS_QUASI_STATIC_H

#include "equilibrium.h"
#include "step_error.h"

#define QUASI_STATIC_GROWTH 1.5 /* of an easy step to the next */

struct quasi_static {
    struct equilibrium *equilibrium;
    double largest, smallest; /* steps, s */
    struct step_error error;
    double *rate;                   /* motion of the last step, the guess for the next, m/s */
    double *before;                 /* x at the start of the step */
    double *held_before;            /* u of equilibrium->held, three a node */
    double mean_before[COMPONENTS]; /* mean gradient */
    double *force_before[3], *load_before[3]; /* box fields, where work depends on place */
    double *sound[2]; /* integrities (box fields) at the start of this step and of the one before;
                         NULL: no node degrades */
    double lasted;    /* the last step, s; 0: it says nothing of the next */
    int64_t refused;  /* steps tried in vain */
};

/* integration->dt is the first step; accuracy: of the curve, 0 where steps need not care
 * (step_error.h); breaking: the same where bonds break.  The body's velocities are the first guess;
 * they become 0.  Collective. */
struct quasi_static *quasi_static_new(struct equilibrium *equilibrium, double largest,
                                      double smallest, double accuracy, double breaking);
void quasi_static_free(struct quasi_static *quasi_static);

/* One step of at most integration->dt, which becomes the length of the next; ends in a committed
 * equilibrium with the energies known.  False where none is found with the smallest step: then all
 * is as it was before.  Collective. */
bool quasi_static_step(struct quasi_static *quasi_static);

/* The held components go back from here on: so does the guess for the next step. */
void quasi_static_turn(struct quasi_static *quasi_static);

/* The free components of the body's velocities become those of the last step. */
void quasi_static_velocities(const struct quasi_static *quasi_static);

/* The body comes to rest where it is held now: what it loses is returned, J; INFINITY where no
 * equilibrium is found.  Collective. */
double quasi_static_settle(struct quasi_static *quasi_static);

/* The rate of the last step, and what finds equilibria.  Collective. */
void quasi_static_visit(struct quasi_static *quasi_static, struct checkpoint *checkpoint);

/* Damage catches up with an accepted state while the held components stand still: nodes degrade,
 * the worst `most` of what has to break does so, the body comes to rest again, until nothing
 * changes.  What it loses by broken bonds counts as fracture, the rest is booked by the material.
 * False where no equilibrium is found. */
struct quasi_static_damage {
    double most;        /* bonds and nodes at once */
    int64_t rounds;     /* equilibria it took */
    double degradation; /* largest change of a node's integrity in the first round */
};
bool quasi_static_break(struct quasi_static *quasi_static, struct quasi_static_damage *damage);

#endif
