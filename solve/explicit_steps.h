/* explicit_steps.h - explicit steps (course_explicit.c), of a course of their own or of one that
 * takes them for a while. */
#ifndef HS_EXPLICIT_STEPS_H
#define HS_EXPLICIT_STEPS_H

#include <stdbool.h>

struct simulation;

struct explicit_steps {
    double critical;            /* step, s */
    double deformation, broken; /* as of the last critical step; bonds */
    double disturbed;      /* time at which the body was last known not to be at equilibrium, s */
    bool looked;           /* the energies are those of the step just done */
    double length;         /* of a step, s; the last ones are cut */
    double strain, growth; /* of the gauge at the last look, and since the one before, for each s */
    double since;          /* time of that look, s */
};

/* Length of the next steps [s]: within solver.safety, strain_step and least_steps. */
double explicit_length(const struct simulation *simulation);
/* Explicit steps follow, with the step that simulation->integration has. */
void explicit_begin(struct simulation *simulation);
void explicit_advance(struct simulation *simulation);
/* The step from here on, which is stable and resolves the test; where nothing acts on anything the
 * one before. */
void explicit_find_step(struct simulation *simulation);

#endif
