/* node_values.h - everything that is known of a node, as numbers: what fields and quantities are made of. */
#ifndef HS_NODE_VALUES_H
#define HS_NODE_VALUES_H

#include "damage.h"
#include "model.h"

enum node_value {
    DISPLACEMENT_X,                   /* and Y, Z; m */
    VELOCITY_X = DISPLACEMENT_X + 3,  /* m/s */
    FORCE_X = VELOCITY_X + 3,         /* inner force density, N/m^3 */
    EXTERNAL_FORCE_X = FORCE_X + 3,   /* density of the loads, N/m^3 */
    STRESS_XX = EXTERNAL_FORCE_X + 3, /* Cauchy, and YY, ZZ, XY, YZ, ZX; Pa */
    VON_MISES = STRESS_XX + 6,        /* Pa */
    PLASTIC_STRAIN,                   /* equivalent */
    DAMAGE,
    PHASE,
    NODE_VALUES
};

/* In the deck's words: displacement_x, ..., phase.  Those but phase are quantities. */
extern const char *const node_value_names[NODE_VALUES];
extern const int node_value_count; /* of quantities */

/* Whether it is one that node_values_find sees. */
static inline bool node_value_is_state(int which)
{
    return which >= STRESS_XX && which <= PLASTIC_STRAIN;
}

struct node_values;

struct node_values *node_values_new(const struct body *body, const struct damage *damage);
void node_values_free(struct node_values *values);

/* Sees the nodes' states, for the values that are such; model_prepare goes before it.  Collective. */
void node_values_find(struct node_values *values, struct model *model, struct body *body);

/* One of them (enum node_value) as a box field, good at owned nodes until the next call. */
const double *node_values_field(struct node_values *values, int which, const struct body *body);

#endif
