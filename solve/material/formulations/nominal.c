/* nominal.c - what a node whose stress comes from bonds shows of itself: gradient, Cauchy and
 * nominal stress.
 *
 * No law at the node answers here: body->S holds the sums of its bonds (bond_stress.c), body->H the
 * gradient that the shape tensor gives, which a surface does not spoil.  A sheet is a layer of
 * nodes without a bond across it, so what the plane state says of that direction is put in: the
 * strain of plane stress, by Poisson's ratio of the material, and the stress of plane strain.  For
 * records alone; the force never reads it. */
#include "nominal.h"

#include <string.h>

/* Bonds of one layer have no force across it; the strain that is held at zero there has a stress.
 */
static void hold_across(const struct body *body, const struct strip *strip,
                        const struct materials *materials, struct node_state *state)
{
    for (int i = 0; i < strip->count; i++)
        state->cauchy[2][i] = materials->items[body->grid.phase[strip->site + i]].poissons_ratio *
                              (state->cauchy[0][i] + state->cauchy[1][i]);
}

/* A layer that is free across grows thinner, by linear elasticity. */
static double strain_across(const struct material *material, double xx, double yy)
{
    const double nu = material->poissons_ratio;
    return -nu / (1 - nu) * (xx + yy);
}

void node_state_from_nominal(const struct body *body, const struct strip *strip,
                             const struct materials *materials, struct node_state *state)
{
    const double *P[9];
    state->count = strip->count;
    for (int k = 0; k < 9; k++) {
        memcpy(state->H[k], body->H[k] + strip->site, (size_t)strip->count * sizeof(double));
        P[k] = body->S[k] + strip->site;
    }
    if (materials->plane == PLANE_STRESS)
        for (int i = 0; i < strip->count; i++)
            state->H[8][i] = strain_across(&materials->items[body->grid.phase[strip->site + i]],
                                           state->H[0][i], state->H[4][i]);
    memcpy(state->nominal, P[4 * body->lattice->axis], (size_t)strip->count * sizeof(double));
    node_state_cauchy(state, P);
    if (materials->plane == PLANE_STRAIN) hold_across(body, strip, materials, state);
}
