/* scene.h - what to solve, from the deck's sections boundary, solver and output. */
#ifndef HS_SCENE_H
#define HS_SCENE_H

#include "deck.h"
#include "domain.h"
#include "material.h"

#include <stdbool.h>

enum scene_start {
    START_AFFINE, /* the body moves with the grips from the first step: no wave is sent out */
    START_RAMP    /* the body is at rest, the grips gain their velocity over a time */
};

struct scene_boundary {
    const char *set;
    int direction;   /* 0, 1, 2 */
    double velocity; /* m/s */
    struct deck_node node;
};

struct scene_fields {
    int frames; /* 0: none */
    int n_variables;
    int *variables; /* indices into the table of output/fields.c */
};

struct scene {
    struct deck *deck;
    double horizon;          /* spacings */
    int influence;           /* -1: that of the formulation */
    struct deck_node solver; /* for what belongs to the formulation */
    bool partial_volumes;
    enum plane plane;
    int n_boundary;
    struct scene_boundary *boundary;
    double end_strain, end_time; /* one of them; the other is 0 */
    double safety;
    enum scene_start start;
    double ramp;             /* s */
    double damping;          /* 1/s */
    double energy_tolerance; /* of the balance, relative */
    int history;             /* records */
    struct scene_fields fields;
};

/* Reads and checks everything but the materials, which need the domain's phases.  The deck must
 * outlive the scene. */
struct scene scene_read(struct deck *deck);
/* Dies where a set of the boundary is not in the domain. */
void scene_check_sets(const struct scene *scene, const struct domain *domain);
void scene_free(struct scene *scene);

#endif
