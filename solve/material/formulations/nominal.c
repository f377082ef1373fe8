#include "nominal.h"

/* Bonds of one layer have no force across it; the strain that is held at zero there has a stress. */
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
    static const int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    state->count = strip->count;
    for (int i = 0; i < strip->count; i++) {
        double F[9], P[9];
        for (int k = 0; k < 9; k++) state->H[k][i] = body->H[k][strip->site + i];
        if (materials->plane == PLANE_STRESS)
            state->H[8][i] = strain_across(&materials->items[body->grid.phase[strip->site + i]],
                                           state->H[0][i], state->H[4][i]);
        for (int k = 0; k < 9; k++) {
            F[k] = state->H[k][i] + (k % 4 == 0);
            P[k] = body->S[k][strip->site + i];
        }
        state->nominal[i] = P[0];
        double J = F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
                   F[2] * (F[3] * F[7] - F[4] * F[6]);
        for (int k = 0; k < 6; k++) {
            const double *a = P + 3 * row[k], *b = F + 3 * column[k];
            state->cauchy[k][i] = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / J;
        }
    }
    if (materials->plane == PLANE_STRAIN) hold_across(body, strip, materials, state);
}
