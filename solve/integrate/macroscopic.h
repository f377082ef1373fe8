/* macroscopic.h - a periodic body under a mean deformation gradient, of which each component is
 * given, or the mean stress that belongs to it.
 *
 *   u(X + L_b e_b) = u(X) + L_b H_b,  F = 1 + H                                     (macroscopic.1)
 *   P_ab = d(energy)/dH_ab/V = mean over the volume of the nominal stress           (macroscopic.2)
 *   X_ab = L_b H_ab,  g_ab = (P_ab - given) V/L_b/V_node                            (macroscopic.3)
 *
 * H: mean displacement gradient, L_b the period along axis b, V the volume of the body (Hill, J.
 * Mech. Phys. Solids 11 (1963) 357: the mean stress does the work).  (macroscopic.3) are the
 * unknowns whose stress is given, and what an equilibrium makes 0: the displacement of one face
 * against the other, and the force on it over the volume of a node.
 *
 * In explicit steps unknown components have an inertia of their own, W d2H/dt2 = V (given - P),
 * W_ab = M (L_b/pi)^2, M the mass of the body (after Parrinello, Rahman, J. Appl. Phys. 52 (1981)
 * 7182): they swing as the body's longest standing wave.
 *
 * Turning the body changes nothing: components that no entry of the deck names have no stress on
 * the diagonal and above it, and below it, where that is a turn, they stay 0; so do those that turn
 * an axis without period into one with. */
#ifndef HS_MACROSCOPIC_H
#define HS_MACROSCOPIC_H

#include "body.h"
#include "scene.h"

enum { COMPONENTS = 9 };

struct checkpoint;

struct macroscopic {
    struct {
        bool given; /* else its stress is */
        enum macroscopic_kind kind;
        const struct value *value; /* of the scene; NULL: 0 */
    } component[COMPONENTS];
    bool axis[3];              /* periodic */
    double period[3];          /* m; of other axes of no meaning */
    double volume;             /* m^3 */
    double mass;               /* kg */
    double target[COMPONENTS]; /* mean stress as it is given now, Pa */
    double target_before[COMPONENTS];
    double sense;              /* of rates that are numbers: 1, or -1 where they go back */
    double way[COMPONENTS];    /* of given components in this step */
    double before[COMPONENTS]; /* H and P at the end of the step before */
    double stress_before[COMPONENTS];
};

/* NULL where the body is not periodic.  The scene lives on. */
struct macroscopic *macroscopic_new(const struct scene *scene, const struct body *body);
/* Inverse densities of phases [m^3/kg]. */
void macroscopic_weigh(struct macroscopic *macroscopic, const struct body *body,
                       const double inverse_density[]);

/* body->mean_rate at the start: the given rates, and of diagonal components whose stress is given
 * the contraction under those along other axes. */
void macroscopic_start(const struct macroscopic *macroscopic, struct body *body,
                       double poissons_ratio, double dt);

/* Rates that are numbers go back (-1) or forth (1). */
void macroscopic_turn(struct macroscopic *macroscopic, double sense);

/* The ways of given components in the step from time on, and the stresses at its end. */
void macroscopic_set_ways(struct macroscopic *macroscopic, const struct body *body, double time,
                          double dt);
/* Given components of body->mean_gradient go these ways. */
void macroscopic_move(const struct macroscopic *macroscopic, struct body *body);

/* Of explicit steps: unknown components of body->mean_rate under the stress that is there, in a
 * time [s], and of body->mean_gradient under this rate. */
void macroscopic_kick(const struct macroscopic *macroscopic, struct body *body, double time);
void macroscopic_drift(const struct macroscopic *macroscopic, struct body *body, double time);
/* Kinetic energy of unknown components, and what leapfrog keeps beyond it with steps of this length
 * [J] (balance.1). */
double macroscopic_kinetic(const struct macroscopic *macroscopic, const struct body *body);
double macroscopic_staggered(const struct macroscopic *macroscopic, const struct body *body,
                             double dt);

/* Force on the faces across axis b, along a [N]: k = 3 a + b; and of given components the way of
 * one face against the other in this step [m]. */
double macroscopic_force(const struct macroscopic *macroscopic, const struct body *body, int k);
double macroscopic_way(const struct macroscopic *macroscopic, int k);

/* What a norm of forces on nodes would be, if the mean stress were the reactions of two faces
 * (equilibrium.2) [N/m^3]. */
double macroscopic_reactions(const struct macroscopic *macroscopic, const struct body *body);

/* Work of the mean stress since the last call, of unknown components in motion (moving) that of the
 * given stress [J]. */
double macroscopic_take_work(struct macroscopic *macroscopic, const struct body *body, bool moving);

/* Of the mean stress of now in a step as long as this one, of explicit steps [J]. */
double macroscopic_step_work(const struct macroscopic *macroscopic, const struct body *body,
                             double dt);

/* Explicit steps end: unknown components rest, under the stress that is given. */
void macroscopic_rest(struct macroscopic *macroscopic, struct body *body);

/* Rate of F_xx that is given as a number, at full speed [1/s]; else 0. */
double macroscopic_full_rate(const struct macroscopic *macroscopic);
/* Time in which it is reached [s]. */
double macroscopic_ramp(const struct macroscopic *macroscopic);
/* The largest of the rates that are given, at a time [1/s]; 0 without. */
double macroscopic_largest_rate(const struct macroscopic *macroscopic, double time);

void macroscopic_visit(struct macroscopic *macroscopic, struct body *body,
                       struct checkpoint *checkpoint);

#endif
