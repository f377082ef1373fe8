/* model.h - the formulation of peridynamics that a body obeys: how its particles act on each other.
 *
 * All phases of a body share one formulation, each with a material law of its own.  The time loop
 * and the output know this page alone.  To add a formulation: one file, and the materials that obey
 * it in the table of material.c. */
#ifndef HS_MODEL_H
#define HS_MODEL_H

#include "body.h"
#include "material.h"
#include "simd.h"

#include <stdbool.h>

struct bonds;
struct bond_strip;
struct checkpoint;

struct force_mode {
    bool commit; /* states of the laws move on */
    bool frozen; /* no yield, for the stable step */
    bool energy; /* sum up energies */
    bool record; /* a record follows: keep what only this force can tell of the nodes */
    double dt;   /* s since the last commit */
    double time; /* now, s */
};

/* Sums over the whole body [J]. */
struct force_energy {
    struct exact_sum stored, plastic, stabilisation;
};

/* What is seen of a strip of nodes. */
struct node_state {
    int count;
    double H[9][LANES];      /* displacement gradient, row by row */
    double cauchy[6][LANES]; /* Pa: xx yy zz xy yz zx */
    double nominal[LANES];   /* first Piola-Kirchhoff stress along the axis of the test [Pa], at the
                                last record */
    double plastic[LANES];   /* equivalent plastic strain */
};

/* Whose law gives the stress.  Of nodes: each needs a deformation gradient; the force leaves
 * body->H as that of u, and what carries force along a bond has an integrity of its own. */
enum stress_of { STRESS_OF_BONDS, STRESS_OF_NODES };

struct formulation {
    const char *name;
    enum stress_of stress_of;
    const char *influence; /* the function it takes where the deck names none */
    double horizon;        /* the same, in spacings; 0: a deck names one */
    double scattered;      /* the same among scattered particles */
    bool corners; /* the corners of the particles' cells are the nodes (corners.h); it has no bonds
                   */
    const char *const *keys; /* of the deck's solver section that only some formulations have */
    /* Reads what the deck's solver section says to it. */
    void *(*read)(struct deck_node solver, const struct family *family,
                  const struct materials *materials);
    /* The half offsets of bonds whose both ends need a deformation gradient: how many.  NULL: none.
     */
    int (*near)(const void *self, const struct family *family, const struct offset **offsets);
    /* bonds: of the body, with their weights as they stand at any time. */
    void (*start)(void *self, const struct body *body, struct bonds *bonds);
    /* Internal force density body->f at owned nodes from body->u, of a periodic body with the mean
     * gradient on top, whose conjugate it adds to body->stress_sums where these are
     * (macroscopic.2); brings the ghosts of u up to date.  energy may be NULL where mode.energy is
     * false. Collective. */
    void (*force)(void *self, struct body *body, struct force_mode mode,
                  struct force_energy *energy);
    /* Makes the nodes' states ready to be seen; rows: of the stress, 1 where only xx will be looked
     * at, or 3.  Nothing is committed.  Collective.  NULL: the force has done so. */
    void (*prepare)(void *self, struct body *body, int rows);
    void (*observe)(void *self, const struct body *body, const struct strip *strip,
                    struct node_state *state);
    /* The strips that observe takes: all owned nodes, with ghosts where some belong to a strip.
     * NULL: owned nodes alone. */
    const struct strips *(*strips)(const void *self, const struct body *body);
    /* As model_state, of a state that a material of the body has; NULL: none of its materials has
     * one. */
    const double *(*state)(const void *self, const struct strip *strip, int number, int component,
                           double *buffer);
    /* Energy density c w s^2 |xi|/2 or the like of each bond of a strip in body's state [J/m^6];
     * NULL: its bonds have no energy of their own. */
    void (*bond_energy)(const void *self, const struct body *body, const struct bond_strip *strip,
                        double *energy);
    /* Energy per area and squared stretch that it takes to pull all bonds through a plane to the
     * stretch s, [J/m^2]; NULL: it has no such formula. */
    double (*opening)(const struct material *material, enum plane plane,
                      const struct family *family, const struct lattice *lattice);
    /* What it remembers from one step to the next (checkpoint.h); NULL: nothing. */
    void (*visit)(void *self, const struct body *body, struct checkpoint *checkpoint);
    void (*free)(void *self);
};

extern const struct formulation formulation_corner, formulation_correspondence,
    formulation_bond_based, formulation_ordinary, formulation_madenci_oterkus;

struct model {
    const struct formulation *formulation;
    const struct materials *materials;
    void *self;
};

/* The formulation of the materials, which dies where they have not one in common. */
struct model *model_new(struct deck_node solver, const struct family *family,
                        const struct materials *materials);
void model_free(struct model *model);

int model_near(const struct model *model, const struct family *family,
               const struct offset **offsets);
void model_start(struct model *model, const struct body *body, struct bonds *bonds);
void model_force(struct model *model, struct body *body, struct force_mode mode,
                 struct force_energy *energy);
void model_prepare(struct model *model, struct body *body, int rows);
const struct strips *model_strips(const struct model *model, const struct body *body);
void model_observe(const struct model *model, const struct body *body, const struct strip *strip,
                   struct node_state *state);

/* All that it remembers from one step to the next.  Collective. */
void model_visit(struct model *model, const struct body *body, struct checkpoint *checkpoint);

/* States by their number (laws.h). */
/* Whether a material of this body has the state. */
bool model_has_state(const struct model *model, int number);
/* A component of the state at the nodes of one of model_strips, as last committed, [strip->count]:
 * where it is kept, or in buffer, [LANES]; of nodes whose law has no such state what it would begin
 * with. */
const double *model_state(const struct model *model, const struct strip *strip, int number,
                          int component, double *buffer);

/* Cauchy stress P F^T/J of state->H and the nominal stress P, nominal[9][state->count] row by row
 * [Pa]. */
void node_state_cauchy(struct node_state *state, const double *const nominal[9]);

#endif
