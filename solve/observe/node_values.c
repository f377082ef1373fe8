#include "node_values.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const node_value_names[NODE_VALUES] = {"displacement_x",   "displacement_y",
                                                   "displacement_z",   "velocity_x",
                                                   "velocity_y",       "velocity_z",
                                                   "force_x",          "force_y",
                                                   "force_z",          "external_force_x",
                                                   "external_force_y", "external_force_z",
                                                   "stress_xx",        "stress_yy",
                                                   "stress_zz",        "stress_xy",
                                                   "stress_yz",        "stress_zx",
                                                   "von_mises",        "equivalent_plastic_strain",
                                                   "damage",           "phase"};
const int node_value_count = PHASE;

enum { STRESSES = 6 };

struct node_values {
    const struct damage *damage;
    double *stress[STRESSES], *plastic,
        *scalar; /* box fields; but for the last, NULL until the first look */
};

struct node_values *node_values_new(const struct body *body, const struct damage *damage)
{
    const size_t n = (size_t)body->grid.n_sites;
    struct node_values *values = memory_new(1, sizeof *values);
    values->damage = damage;
    values->scalar = memory_new(n, sizeof(double));
    return values;
}

void node_values_free(struct node_values *values)
{
    if (!values) return;
    for (int k = 0; k < STRESSES; k++) free(values->stress[k]);
    free(values->plastic);
    free(values->scalar);
    free(values);
}

static void make_states(struct node_values *values, const struct body *body)
{
    const size_t n = (size_t)body->grid.n_sites;
    if (values->plastic) return;
    for (int k = 0; k < STRESSES; k++) values->stress[k] = memory_new(n, sizeof(double));
    values->plastic = memory_new(n, sizeof(double));
}

void node_values_find(struct node_values *values, struct model *model, struct body *body)
{
    make_states(values, body);
    const struct strips *strips = model_strips(model, body);
    for (int64_t s = 0; s < strips->count; s++) {
        const struct strip *strip = &strips->items[s];
        const size_t bytes = (size_t)strip->count * sizeof(double);
        struct node_state node;
        model_observe(model, body, strip, &node);
        for (int k = 0; k < STRESSES; k++)
            memcpy(values->stress[k] + strip->site, node.cauchy[k], bytes);
        memcpy(values->plastic + strip->site, node.plastic, bytes);
    }
}

static double von_mises(double *const stress[STRESSES], int64_t i)
{
    double xy = stress[0][i] - stress[1][i], yz = stress[1][i] - stress[2][i],
           zx = stress[2][i] - stress[0][i];
    double shear =
        stress[3][i] * stress[3][i] + stress[4][i] * stress[4][i] + stress[5][i] * stress[5][i];
    return sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * shear);
}

static double scalar(const struct node_values *values, int which, const struct body *body,
                     int64_t site)
{
    switch (which) {
    case VON_MISES:
        return von_mises(values->stress, site);
    case PHASE:
        return body->grid.phase[site];
    default:
        return 0; /* a load along an axis without loads */
    }
}

const double *node_values_field(struct node_values *values, int which, const struct body *body)
{
    if (which < VELOCITY_X) return body->u[which - DISPLACEMENT_X];
    if (which < FORCE_X) return body->v[which - VELOCITY_X];
    if (which < EXTERNAL_FORCE_X) return body->f[which - FORCE_X];
    if (which < STRESS_XX && body->b[which - EXTERNAL_FORCE_X])
        return body->b[which - EXTERNAL_FORCE_X];
    if (which >= STRESS_XX && which < VON_MISES) return values->stress[which - STRESS_XX];
    if (which == PLASTIC_STRAIN) return values->plastic;
    if (which == DAMAGE) {
        damage_index(values->damage, values->scalar);
        return values->scalar;
    }
    for (int64_t i = 0; i < body->grid.n_sites; i++)
        if (body->grid.flags[i] & SITE_OWNED) values->scalar[i] = scalar(values, which, body, i);
    return values->scalar;
}
