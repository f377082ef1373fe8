/* legs.h - where a run by load steps is in its programme, and when its grips turn (course_legs.c).
 */
#ifndef HS_LEGS_H
#define HS_LEGS_H

#include <stdbool.h>

struct checkpoint;
struct simulation;

struct legs {
    int leg;                         /* from 0; the programme's count: it is done */
    double sense;                    /* 1: the grips go as boundary says, -1: back */
    double target;                   /* of this leg, strain or Pa */
    double strain, stress;           /* at the last look */
    double strain_rate, stress_rate; /* since the one before, 1/s and Pa/s; 0 behind a turn */
    double turn;                     /* strain of the last turn */
    double elastic;                  /* strain that is elastic behind it */
    double unloaded_from;            /* strain at which the last leg to a stress began */
    double unloaded_stress;          /* Pa, there */
    double section, modulus;         /* m^2, Pa; of the gauge */
};

/* Before the first step.  Collective. */
void legs_begin(struct simulation *simulation);
/* Longest next step [s]: to the end of the leg as it goes, and short behind a turn. */
double legs_time_left(const struct simulation *simulation);
/* After a step: to the next leg, where the end of this one is reached. */
void legs_look(struct simulation *simulation);
/* Whether there is a programme, and whether it is done. */
bool legs_are(const struct simulation *simulation);
bool legs_done(const struct simulation *simulation);

void legs_visit(struct legs *legs, struct checkpoint *checkpoint);

#endif
