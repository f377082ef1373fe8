/* simulation_parts.h - what a simulation consists of; private to the simulation*.c files. */
#ifndef HS_SIMULATION_PARTS_H
#define HS_SIMULATION_PARTS_H

#include "bonds.h"
#include "boundary.h"
#include "fields.h"
#include "gauge.h"
#include "model.h"
#include "quantities.h"
#include "recorder.h"
#include "scene.h"
#include "simulation.h"
#include "verlet.h"

struct simulation {
    const struct arguments *arguments;
    struct ranks ranks;
    struct domain domain; /* rank 0 */
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
    struct recorder recorder;
    struct fields *fields;
    struct spool history_output, fields_output; /* rank 0 */
    double *axial;                              /* box field */
    double critical_step, end_time;
    double strain; /* of the gauge */
    double deformation,
        checked_deformation;        /* as of the last record, and of the last critical step */
    double n_bonds, checked_broken; /* bonds at the start; broken as of the last critical step */
    double drift;                   /* of the energy balance when it was last looked at */
    double disturbed; /* time at which the body was last known not to be at equilibrium, s */
    int64_t n_steps;  /* expected */
    double wall;      /* s */
    char *failure;
};

/* From here on a dying program keeps what is good as NAME.failed. */
void simulation_protect(struct simulation *simulation);

#endif
