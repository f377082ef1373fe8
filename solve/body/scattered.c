/* scattered.c - shape tensor, gradient and divergence where particles lie anywhere: sums over the
 * list of bonds.
 *
 * Without a lattice there are no columns to share.  Each bond is visited once and adds to both of
 * its ends, xi being odd and xi (x) xi even under their exchange.  Volumes count by their share of
 * the mean one, in the units of the lattice's formulas, so that what is made of the results is the
 * same code for both. */
#include "scattered.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* field_i += w V_j/V term and field_j += sign w V_i/V term for each bond; V the mean volume. */
static void add_to_ends(const struct bond_view *view, double mean_volume, const double *term,
                        double sign, double *field)
{
    for (int k = 0; k < view->count; k++) {
        const double weighed = view->weight[k] * term[k] / mean_volume;
        field[view->lower[k]] += weighed * view->volume_j[k];
        field[view->upper[k]] += sign * weighed * view->volume_i[k];
    }
}

static void invert_shapes(struct body *body)
{
    struct exact_sum unsupported = exact_sum_new((double)body->n_nodes);
    for (int64_t s = 0; s < body->near.count; s++)
        for (int i = 0; i < body->near.items[s].count; i++) {
            const int64_t site = body->near.items[s].site + i;
            double K[6], inverse[6];
            for (int k = 0; k < 6; k++) K[k] = body->inverse[k][site];
            bool spans = family_invert_shape(K, body->lattice->dimensions, inverse);
            for (int k = 0; k < 6; k++) body->inverse[k][site] = inverse[k];
            if (!spans && (body->grid.flags[site] & SITE_OWNED)) exact_sum_add(&unsupported, 1);
        }
    double count;
    exact_sum_finish(&unsupported, 1, &count);
    body->unsupported = (int64_t)count;
}

void scattered_shapes(struct body *body)
{
    static const int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    const double spacing = body->lattice->spacing;
    body_need_gradient(body);
    body_clear(body, body->inverse, 6);
    for (int64_t s = 0; s < body->bonds->count; s++) {
        const struct bond_view view = bonds_view(body->bonds, &body->bonds->strips[s]);
        double term[LANES];
        for (int c = 0; c < 6; c++) {
            for (int k = 0; k < view.count; k++)
                term[k] = view.xi[row[c]][k] * view.xi[column[c]][k] / (spacing * spacing);
            add_to_ends(&view, body->volume, term, 1, body->inverse[c]);
        }
    }
    invert_shapes(body);
    body->bonds->changed = false;
}

void scattered_gradient(struct body *body)
{
    const double spacing = body->lattice->spacing;
    double *const *K = body->inverse;
    if (body->bonds->changed) scattered_shapes(body);
    body_clear(body, body->H, 9);
    for (int64_t s = 0; s < body->bonds->count; s++) {
        const struct bond_view view = bonds_view(body->bonds, &body->bonds->strips[s]);
        double term[LANES];
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) {
                for (int k = 0; k < view.count; k++)
                    term[k] = (body->u[a][view.upper[k]] - body->u[a][view.lower[k]]) *
                              view.xi[b][k] / (spacing * spacing);
                add_to_ends(&view, body->volume, term, 1, body->H[3 * a + b]);
            }
    }
    for (int64_t s = 0; s < body->near.count; s++)
        for (int64_t i = body->near.items[s].site, end = i + body->near.items[s].count; i < end;
             i++)
            for (int a = 0; a < 9; a += 3) {
                double x = body->H[a][i], y = body->H[a + 1][i], z = body->H[a + 2][i];
                body->H[a][i] = x * K[0][i] + y * K[3][i] + z * K[5][i];
                body->H[a + 1][i] = x * K[3][i] + y * K[1][i] + z * K[4][i];
                body->H[a + 2][i] = x * K[5][i] + y * K[4][i] + z * K[2][i];
            }
    for (int64_t s = 0; s < body->near.count; s++)
        body_add_mean(body, body->near.items[s].site, body->near.items[s].count);
}

void scattered_divergence(struct body *body)
{
    const double spacing = body->lattice->spacing;
    for (int64_t s = 0; s < body->bonds->count; s++) {
        const struct bond_view view = bonds_view(body->bonds, &body->bonds->strips[s]);
        for (int a = 0; a < 3; a++) {
            double term[LANES] = {0};
            for (int b = 0; b < 3; b++) {
                const double *Q = body->Q[3 * a + b];
                for (int k = 0; k < view.count; k++)
                    term[k] += (Q[view.lower[k]] + Q[view.upper[k]]) * view.xi[b][k] / spacing;
            }
            add_to_ends(&view, body->volume, term, -1, body->f[a]);
        }
    }
}
