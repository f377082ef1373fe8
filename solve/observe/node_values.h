/* node_values.h - everything that is known of a node, as numbers: what fields and quantities are
 * made of.
 *
 * A value is one row of the table in node_values.c: its name, unit and source.  The deck's words,
 * the variables of a file for ParaView, their units in hspost and the table of docs/formats.md
 * follow from it. */
#ifndef HS_NODE_VALUES_H
#define HS_NODE_VALUES_H

#include "deck.h"

#include <stddef.h>

struct body;
struct damage;
struct model;
struct node_state;
struct node_values;

enum { NODE_COMPONENTS = 9 }; /* at most */

struct node_value {
    const char *name; /* in the deck: external_force; in a file: ExternalForceX */
    const char *unit; /* SI, "1": a pure number */
    int components;   /* 1; 3: x, y, z; 6: xx, yy, zz, xy, yz, zx; 9: row by row */
    bool density;     /* per volume: as a quantity it is that of the whole node, unit * m3 */
    bool label;       /* no quantity: it says which, not how much */
    const char *help; /* one line for the manual */
    /* One of the three: the offset of box fields in struct body, one a component, NULL where all is
     * 0; where a component is as a box field, in *buffer where it has to be made; or its values in
     * a state of nodes, [state->count].  None: it is the state of that name of a law (laws.h). */
    size_t member;
    const double *(*field)(const struct body *body, const struct damage *damage, int component,
                           double *buffer);
    void (*observe)(const struct node_state *state, int component, double *values);
};

/* The rows of the table, then the states of all laws; its name is NULL beyond the last one. */
struct node_value node_value(int i);

/* Which value a word of the deck means; dies where there is none, naming the nearest. */
int node_value_read(struct deck_node word);

/* One component as a word of the deck means it: stress_xx. */
struct node_component {
    struct node_value value;
    int component;
};
/* Component i of all that can be quantities; the name of its value is NULL beyond the last one. */
struct node_component node_component(int i);
/* Which component a word of the deck means; dies where there is none, naming the nearest. */
int node_component_read(struct deck_node word);

/* The variable's name in a file, a new text: StressXX. */
char *node_component_variable(struct node_component which);

/* Looks at the nodes. */
struct node_values *node_values_new(const struct body *body, const struct damage *damage);
void node_values_free(struct node_values *values);

/* A component as a box field, good at owned nodes until the next call; model_prepare goes before it
 * where the value is observed. */
const double *node_values_field(struct node_values *values, struct node_component which,
                                struct model *model, const struct body *body);

/* The same at the corners of particles, of a value that body has there (member). */
const double *node_values_at_corners(struct node_values *values, struct node_component which,
                                     const struct body *body);

#endif
