/* load_steps.h - load steps (course_static.c), of a course of their own or of one that takes them
 * for a while. */
#ifndef HS_LOAD_STEPS_H
#define HS_LOAD_STEPS_H

#include "legs.h"
#include "quasi_static.h"

struct simulation;

struct load_steps {
    struct equilibrium *equilibrium; /* NULL: never at rest */
    struct quasi_static *quasi_static;
    double strain_rate; /* of the gauge in the last step, 1/s */
    double lasted;      /* the last step, s */
    bool framing;       /* the step ends at a frame */
    bool stretched;     /* steps are counted, and bounded by the strain of speeds */
    struct legs legs;   /* of a programme */
};

/* Seconds of a load step that the deck gives in strain or seconds. */
double static_step(const struct simulation *simulation, double step);
/* How many of them, and evaluations of the force, the run is going to take if nothing breaks. */
double static_count(const struct simulation *simulation);
double static_evaluations(const struct simulation *simulation);
/* The first step where the deck leaves it to the yield. */
void static_first_step(struct simulation *simulation);
/* Builds what finds equilibria; the body's velocities are its first guess, and become 0. */
void static_start(struct simulation *simulation);
void static_free(struct load_steps *steps);

/* A load step with its record; false where there is no equilibrium, and all is as before. */
bool static_load(struct simulation *simulation);
/* What follows a load step: damage, the next leg, frame, stepped loads. */
void static_settle(struct simulation *simulation);

#endif
