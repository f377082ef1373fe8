/* explicit_steps.h - explicit steps (course_explicit.c), of a course of their own or of one that takes them for a while. */
#ifndef HS_EXPLICIT_STEPS_H
#define HS_EXPLICIT_STEPS_H

#include <stdbool.h>

struct simulation;

struct explicit_steps {
    double critical;            /* step, s */
    double deformation, broken; /* as of the last critical step; bonds */
    double disturbed; /* time at which the body was last known not to be at equilibrium, s */
    bool looked;      /* the energies are those of the step just done */
    bool ending;      /* the gauge is at its end: the next step is the last */
};

/* Explicit steps follow, with the step that simulation->integration has. */
void explicit_begin(struct simulation *simulation);
void explicit_advance(struct simulation *simulation);
/* The stable step from here on [s], or where nothing acts on anything the one before. */
void explicit_find_step(struct simulation *simulation);

#endif
