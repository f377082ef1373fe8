/* simulation_parts.h - what a simulation consists of; private to the simulation*.c files. */
#ifndef HS_SIMULATION_PARTS_H
#define HS_SIMULATION_PARTS_H

#include "arguments.h"
#include "bonds.h"
#include "boundary.h"
#include "fields.h"
#include "gauge.h"
#include "model.h"
#include "profile.h"
#include "quantities.h"
#include "quasi_static.h"
#include "recorder.h"
#include "scene.h"

struct simulation;

/* How a run advances. */
struct course {
    /* From the last record to the next or less; fills simulation->failure where it cannot. */
    void (*advance)(struct simulation *simulation);
};
extern const struct course course_explicit, course_static, course_hybrid;

struct simulation {
    const struct arguments *arguments;
    struct ranks ranks;
    struct profile *profile; /* NULL: not asked for */
    struct domain domain;    /* rank 0 */
    struct deck *deck;
    struct scene scene;
    struct lattice lattice;
    struct family family;
    struct materials materials;
    struct body body;
    struct model *model;
    struct bonds *bonds;
    struct damage *damage;
    struct boundary boundary;
    struct gauge *gauge; /* NULL: none */
    struct quantities *quantities;
    struct integration integration;
    const struct course *course;
    struct equilibrium *equilibrium; /* NULL: never at rest */
    struct quasi_static *quasi_static;
    struct recorder recorder;
    struct fields *fields;
    struct spool history_output, fields_output; /* rank 0 */
    double critical_step, end_time;
    double strain;                    /* of the gauge */
    double checked_deformation;       /* as of the last critical step */
    double n_bonds, checked_broken;   /* bonds at the start; broken as of the last critical step */
    double drift;                     /* of the energy balance when it was last looked at */
    bool framing;                     /* the load step ends at a frame */
    bool looked;                      /* the energies are those of the explicit step just done */
    double quiet_since, quiet_broken; /* since when the motion is small; bonds broken by then */
    double highest_load;              /* of the grips so far, N */
    bool fallen;      /* as of the last record the body is broken and carries next to nothing */
    double disturbed; /* time at which the body was last known not to be at equilibrium, s */
    int64_t n_steps;  /* expected */
    double wall;      /* s */
    char *failure;
};

/* Share of a phase between the gauge planes, without them of the whole body. */
double simulation_fraction(const struct simulation *simulation, int phase);

/* Seconds of a load step that the deck gives in strain or seconds. */
double simulation_load_step(const struct simulation *simulation, double step);
/* Builds what finds equilibria; the body's velocities are its first guess, and become 0. */
void simulation_start_static(struct simulation *simulation);

/* A load step with its record; false where there is no equilibrium, and all is as before. */
bool simulation_load(struct simulation *simulation);

/* What follows such a step: damage, frame, stepped loads. */
void simulation_settle(struct simulation *simulation);

/* The stable step from here on [s], or where nothing acts on anything the one before. */
void simulation_find_step(struct simulation *simulation);

/* Whether the next step ends at a frame. */
bool simulation_frame_due(const struct simulation *simulation);
/* Whether a number of steps, or a time, is the end; whether the run has come to it. */
bool simulation_is_end(const struct simulation *simulation, int64_t step, double time);
bool simulation_at_end(const struct simulation *simulation);

/* Mean of the forces of both grips, N; 0 without grips. */
double simulation_grip_load(const struct simulation *simulation);

void simulation_record(struct simulation *simulation);
void simulation_write_frame(struct simulation *simulation);

/* Strain of the gauge, without one the root mean square displacement gradient.  Collective. */
double simulation_deformation(struct simulation *simulation);

/* NULL while the run is sound. */
char *simulation_find_failure(const struct simulation *simulation);

/* From here on a dying program keeps what is good as NAME.failed. */
void simulation_protect(struct simulation *simulation);

#endif
