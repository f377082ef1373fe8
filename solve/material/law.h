/* law.h - the constitutive law of a point: what it reads, what it remembers, what stress it answers
 * with.
 *
 * A law declares itself: its keys in the deck, the states that it keeps at each point, and an
 * update that moves a strip of points on.  Who owns points (nodes, bonds of a stabilisation) keeps
 * no law's state and knows no law by name: points.h stores the states, and calls the law of each
 * point.  A law may have no update: then a formulation has a law of bonds of its own, which
 * declares keys and states the same way (ordinary_plastic.c).
 *
 * To add a law: one file after the pattern of laws/elastic.c, its name in the list of laws.h, its
 * equations in docs/theory.md.  Its keys are in the manual then, its states in fields and
 * quantities. */
#ifndef HS_LAW_H
#define HS_LAW_H

#include "keys.h"
#include "simd.h"

#include <stdbool.h>
#include <stdint.h>

struct yield;

/* Components of a tensor: row by row; of a symmetric one: xx yy zz xy yz zx. */
enum { TENSOR = 9, SYMMETRIC = 6 };

/* What a law remembers of a point, known by its name in output and damage. */
struct state {
    const char *name; /* in the deck's words: equivalent_plastic_strain */
    const char *unit; /* SI; "1": a pure number */
    int components;   /* 1, SYMMETRIC or TENSOR */
    double initial;   /* of a number; of the diagonal of a tensor, the rest of which is 0 */
    const char *help; /* one line */
};

/* What a component of a state begins with. */
static inline double state_initial(const struct state *state, int component)
{
    const int step = state->components == TENSOR ? 4 : 1;
    return component % step == 0 && component < 3 * step ? state->initial : 0;
}

/* The equivalent plastic strain, by which nodes degrade and break, of all laws that have one. */
#define STATE_PLASTIC_STRAIN                                                                       \
    {                                                                                              \
        "equivalent_plastic_strain", "1", 1, 0, "equivalent plastic strain"                        \
    }

/* The move from the last committed state to now. */
struct step {
    double dt;   /* s; 0 where no time has passed since the last commit */
    double time; /* now, s */
    bool commit; /* write the new state; otherwise it is only read */
    bool frozen; /* the instantaneous elastic answer, whatever the stress (for the stable step) */
    bool energy; /* fill stored, dissipated and dissipating */
};

/* A strip of points. */
struct points {
    int count;                          /* at most LANES */
    HS_ALIGNED double H[TENSOR][LANES]; /* in: displacement gradient F - 1 */
    double mu[LANES];                   /* in: shear modulus [Pa] */
    double bulk[LANES];                 /* in: bulk modulus [Pa] */
    int64_t pair[LANES]; /* in: of which phases, first * phases + second, whose means it obeys */
    double shift[LANES]; /* in: what the yield stress has over the law's own (yield.h) [Pa] */
    bool flows;          /* out: some point flows */
    HS_ALIGNED double P[TENSOR][LANES]; /* out: first Piola-Kirchhoff stress [Pa] */
    double stored[LANES];               /* out: energy density that comes back [J/m^3] */
    double dissipated[LANES];  /* out: work density that does not, of all steps up to now [J/m^3] */
    double dissipating[LANES]; /* out, at a commit: what this step adds to dissipated [J/m^3] */
};

struct law {
    struct variant words; /* name, help, and the keys that fill its parameters */
    size_t parameters;    /* their size */
    int n_states;         /* 0: it remembers nothing */
    const struct state *states;
    /* Reads what the rows of keys leave to it, and checks; NULL: nothing. */
    void (*read)(struct deck_node map, void *parameters);
    void (*release)(void *parameters);
    /* How its yield stress varies within a phase; NULL: it has none (yield.h). */
    const struct yield *(*yield)(const void *parameters);
    /* What update reads of the pairs of phases: pair k has the mean of the parameters first[k] and
     * second[k], both NULL where it obeys another law.  Freed with free(); NULL: it needs nothing.
     */
    void *(*pairs)(int count, const void *const first[], const void *const second[]);
    /* State of points as they begin, where that follows from more than struct state.initial, which
     * is set; NULL. */
    void (*start)(const void *pairs, const struct points *points, double *state, int64_t stride);
    /* state[k * stride + point], k counting the components of all states in their order.  NULL: a
     * law of bonds. */
    void (*update)(const void *pairs, struct points *points, double *state, int64_t stride,
                   struct step step);
    int flow_stress; /* component of the state that is the current flow stress [Pa]; -1: it never
                        flows */
};

/* Point i carries nothing: to be called before the update. */
static inline void points_switch_off(struct points *points, int i)
{
    for (int k = 0; k < TENSOR; k++) points->H[k][i] = 0;
    points->mu[i] = points->bulk[i] = 0;
}

/* The states of points as they begin; arrays as of update. */
void law_start(const struct law *law, const void *pairs, const struct points *points, double *state,
               int64_t stride);

/* Numbers that the law keeps at a point. */
int law_components(const struct law *law);
/* Component of the state of that name; -1: the law has no such state. */
int law_component(const struct law *law, const char *state);

#endif
