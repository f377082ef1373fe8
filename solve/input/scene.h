/* scene.h - what to solve, from the deck's sections boundary, initial, solver and output. */
#ifndef HS_SCENE_H
#define HS_SCENE_H

#include "deck.h"
#include "domain.h"
#include "keys.h"
#include "material.h"
#include "programme.h"
#include "selection.h"
#include "value.h"

#include <stdbool.h>

/* How a run may advance (course.h), with a word for the manual: solver.type. */
#define COURSES(DO)                                                                                \
    DO(explicit, "explicit steps, with inertia"),                                                  \
        DO(quasi_static, "load steps from one equilibrium to the next"),                           \
        DO(hybrid, "load steps, and explicit ones from an event on"),                              \
        DO(auto, "load steps or explicit ones, whichever keeps the accuracy at less cost")
#define COURSE_NUMBER(name, words) SOLVER_##name
enum scene_type { COURSES(COURSE_NUMBER), SOLVER_TYPES };

/* Methods for equilibria (integrate/equilibrium.h); the first is the default. */
#define EQUILIBRIUM_METHODS(DO) DO(lbfgs), DO(newton), DO(relaxation)
extern const char *const equilibrium_methods[]; /* ended by NULL */

/* Largest load step, in strain, where none is given. */
static const double scene_strain_step = 0.005;

/* Of the load steps of a quasi-static solver, in strain where the run ends at a strain, else in s.
 */
struct scene_static {
    int method; /* of equilibrium_methods */
    /* In strain where the run ends at one, else s; first: INFINITY where what moves and yields says
     * it, and without an end_strain the others. */
    double first_step, largest_step, smallest_step;
    struct {
        struct deck_node first, largest, smallest;
    } given;
    double accuracy;          /* of the forces' curve */
    double tolerance;         /* of the residual */
    int64_t most_evaluations; /* 0: as many as the method usually takes */
    int64_t break_at_once;    /* bonds and nodes, the worst ones */
};

/* When a hybrid solver goes over to explicit steps, beside where no equilibrium is found; and back.
 */
struct scene_hybrid {
    struct deck_node events;
    bool at_damage, at_maximum; /* something has to break; the force on the grips falls */
    double strain;              /* of the gauge; INFINITY: never for that */
    double kinetic_share;       /* of the internal energy, below which it goes back; 0: never */
    double quiet;               /* s without a broken bond before that */
};

enum scene_start {
    START_AFFINE, /* the body moves with the grips from the first step: no wave is sent out */
    START_RAMP    /* the body is at rest, the grips gain their velocity over a time */
};

/* Some nodes of the body: known to the deck, and, once resolved, by their numbers. */
struct scene_nodes {
    struct selection selection;
    int64_t count, *numbers; /* from 0, ascending; rank 0 */
};

/* What an entry of boundary prescribes; one of initial is of the first two kinds. */
enum scene_kind { SCENE_VELOCITY, SCENE_DISPLACEMENT, SCENE_FORCE, SCENE_BODY_FORCE, SCENE_KINDS };

struct scene_entry {
    struct scene_nodes nodes;
    int direction; /* 0, 1, 2 */
    enum scene_kind kind;
    struct value value; /* m/s, m, N for all nodes together, N/m^3 */
    struct deck_node where;
};

/* What an entry of macroscopic prescribes. */
enum macroscopic_kind {
    MACROSCOPIC_RATE,
    MACROSCOPIC_STRAIN,
    MACROSCOPIC_STRESS,
    MACROSCOPIC_KINDS
};

struct scene_component {
    struct deck_node where;
    int component; /* 3 row + column */
    enum macroscopic_kind kind;
    struct value value; /* 1/s, 1, Pa */
};
extern const char *const scene_components[]; /* names, ended by NULL */

/* How the values of a quantity at the selected nodes become one number. */
enum scene_reduction { REDUCE_SUM, REDUCE_MEAN, REDUCE_MINIMUM, REDUCE_MAXIMUM };

/* A column of the history that the deck asks for. */
struct scene_quantity {
    const char *name;
    int value; /* a node_component */
    enum scene_reduction reduction;
    struct deck_node place; /* of its nearest node; index 0: the selection counts */
    struct scene_nodes nodes;
    struct deck_node where;
};

struct scene_fields {
    struct {
        struct deck_node every, variables; /* index 0: no fields */
    } given;
    int64_t frames; /* roughly; 0: none, or every */
    int64_t every;  /* steps; 0: by frames */
    int n_variables;
    int *variables; /* [n_variables] node_values */
};

/* Of the states of a run on its way. */
struct scene_checkpoint {
    struct deck_node given; /* every; index 0: not given */
    double seconds;         /* from one to the next, 0: not by time */
    int64_t steps;          /* 0: not by steps */
    int64_t keep;           /* the newest */
};

struct scene {
    enum scene_type type;
    struct scene_static statics;
    struct scene_hybrid hybrid;
    struct deck_node given_horizon;
    double horizon;             /* spacings; 0: that of the formulation, or a length so far */
    int influence;              /* -1: that of the formulation */
    struct deck_node solver;    /* for what belongs to the formulation */
    struct deck_node elsewhere; /* of keys that it looks up there */
    struct deck_node legs;      /* solver.programme */
    int partial_volumes;
    int coincident; /* nodes of a mesh: enum mesh_coincident (mesh.h), -1: not said */
    enum plane plane;
    int n_boundary, n_initial;
    struct scene_entry *boundary, *initial;
    struct deck_node periodic_load; /* the section macroscopic; index 0: none */
    double direction[3];            /* of its x, along the lattice's axes */
    int n_components;
    struct scene_component *components;
    double end_strain, end_time; /* s */
    int64_t end_steps;           /* one of the three; the others are 0 */
    struct programme programme;  /* in their place; then end_strain is its farthest strain */
    double end_load; /* share of the largest load below which a broken body ends the run; 0: none */
    double safety;
    bool accept; /* numbers that no metal has */
    enum scene_start start;
    double ramp;             /* s */
    double damping;          /* 1/s */
    double local_damping;    /* share of the force on a node */
    double mass_scaling;     /* of the inertia alone */
    double energy_tolerance; /* of the balance, relative */
    double strain_step;      /* largest strain between the grips in an explicit step */
    int64_t least_steps;     /* explicit ones, of the whole test */
    int64_t history;         /* records */
    struct deck_node columns;
    int n_quantities;
    struct scene_quantity *quantities;
    struct scene_fields fields;
    struct scene_checkpoint checkpoint;
};

/* Reads and checks everything but the materials, which need the domain's phases.  The deck must
 * outlive the scene. */
struct scene scene_read(struct deck *deck);

/* A horizon that the deck gives as a length becomes one in spacings [m]. */
void scene_measure_horizon(struct scene *scene, double spacing);

/* The parts of scene_read that have files of their own; output.index may be 0. */
void scene_read_entries(struct scene *scene, struct deck_node root);
void scene_read_macroscopic(struct scene *scene, struct deck_node list);
void scene_read_output(struct scene *scene, struct deck_node output);

extern const struct section section_solver, section_boundary, section_initial, section_macroscopic,
    section_output;

/* Finds the nodes of every selection: the particles of the domain, or of what moves and loads the
 * body the nodes, if those are corners: all that the particles of a set or block have, or those
 * that lie in the place.  nodes: positions of the nodes, the domain itself where they are its
 * particles.  Dies where there are none, and where a node is held, or set, twice along one
 * direction. */
void scene_resolve(struct scene *scene, const struct domain *domain, const struct domain *nodes,
                   const struct lattice *lattice);
/* Dies where a body with planes of symmetry is held, loaded, set in motion or observed otherwise
 * than its images, by a box or an expression that holds on one side alone, below.  Arguments of
 * scene_resolve. */
void scene_check_images(const struct scene *scene, const struct domain *domain,
                        const struct domain *nodes, const struct lattice *lattice);
/* Dies where a value acts across a plane of symmetry on nodes in it, or on both sides otherwise
 * than on images of each other.  After scene_resolve; end_time [s]. */
void scene_check_planes(const struct scene *scene, const struct domain *nodes,
                        const struct lattice *lattice, double end_time);

/* Evaluates the expressions of all entries up to this time [s], at their nodes: dies where one is
 * not finite or out of range. */
void scene_try(const struct scene *scene, const struct domain *nodes, double end_time);
void scene_free(struct scene *scene);

/* Kinds that hold nodes in their motion, not load them. */
static inline bool scene_holds(enum scene_kind kind)
{
    return kind == SCENE_VELOCITY || kind == SCENE_DISPLACEMENT;
}

#endif
