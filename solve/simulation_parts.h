/* simulation_parts.h - what a simulation consists of; private to the simulation*.c files. */
#ifndef HS_SIMULATION_PARTS_H
#define HS_SIMULATION_PARTS_H

#include "arguments.h"
#include "bonds.h"
#include "boundary.h"
#include "course.h"
#include "explicit_steps.h"
#include "fields.h"
#include "gauge.h"
#include "load_steps.h"
#include "model.h"
#include "profile.h"
#include "quantities.h"
#include "recorder.h"
#include "scene.h"
#include "stop.h"

/* A run to a strain, or through a programme, is given up after so many times the way expected. */
enum { MOST_WAYS = 4 };

struct simulation {
    const struct arguments *arguments;
    struct ranks ranks;
    struct profile *profile; /* NULL: not asked for */
    struct domain domain;    /* rank 0 */
    struct domain corners;   /* the nodes there, where they are corners of the particles */
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
    struct explicit_steps explicit_steps;
    struct load_steps load_steps;
    void *own; /* of the course */
    struct recorder recorder;
    struct exodus_history *journal; /* rank 0: the records that are on disk */
    double next_save;               /* of records, s */
    bool whole;                     /* all records are, and the file is closed */
    struct fields *fields;
    double framed;                              /* time of the last frame, s */
    bool frames_missing;                        /* those of before a restart; rank 0 */
    struct spool history_output, fields_output; /* rank 0 */
    double end_time;                            /* s */
    double strain;                              /* of the gauge */
    double n_bonds;                             /* at the start */
    double drift;        /* of the energy balance when it was last looked at */
    double highest_load; /* of the grips so far, N */
    bool fallen;         /* as of the last record the body is broken and carries next to nothing */
    int64_t n_steps;     /* expected */
    double wall;         /* s */
    struct stop stop;
    char *fields_name;     /* of frames, as a restart looks for them; rank 0 */
    int input;             /* open file of the domain; rank 0 */
    int64_t saved_step;    /* of the last checkpoint */
    double saved;          /* when, s */
    double saving;         /* how long that took, s */
    int64_t saved_records; /* that it has; rank 0 */
    bool resumable;        /* it is of the run as it stands */
    double longest;        /* of the advances so far, s */
    bool stopped;
    char *failure;
};

/* Share of a phase between the gauge planes, without them of the whole body. */
double simulation_fraction(const struct simulation *simulation, int phase);

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

/* From here on records go to disk, and a dying program keeps what is good as NAME.failed. */
void simulation_protect(struct simulation *simulation);

/* Records that are new go to disk, every now and then, or now.  Between the steps alone, which may
 * take one back. */
void simulation_save_records(struct simulation *simulation, bool now);

/* A checkpoint of the run as it stands; false, with a warning, where there is no room for it.
 * Collective. */
bool simulation_checkpoint(struct simulation *simulation);
/* Its name: a new text. */
char *simulation_checkpoint_name(const struct simulation *simulation);
/* Where nobody asked for them, they go with the end of the run. */
void simulation_forget_checkpoints(const struct simulation *simulation);
/* Whether this rank wishes for one, by time, or it is due by the steps. */
bool simulation_checkpoint_wish(const struct simulation *simulation);
bool simulation_checkpoint_due(const struct simulation *simulation);
/* The state of the checkpoint that the arguments name.  Collective. */
void simulation_restore(struct simulation *simulation);

/* Records expected, about. */
int64_t simulation_records(const struct simulation *simulation);

#endif
