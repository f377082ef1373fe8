#include "bond_ends.h"

#include <math.h>

double bond_ends_extension(const struct bond_view *view, const struct bond_ends *u, int k)
{
    double longer = 0, square = 0;
    for (int a = 0; a < 3; a++) {
        double xi = view->xi[a][k * view->geometry_step], eta = u->upper[a][k] - u->lower[a][k];
        longer += (2 * xi + eta) * eta;
        square += (xi + eta) * (xi + eta);
    }
    return longer / (sqrt(square) + view->length[k * view->geometry_step]);
}

void bond_ends_add_stress(const struct bond_view *view, const struct bond_ends *u,
                          const double *lower, const double *upper, struct body *body)
{
    const int g = view->geometry_step;
    for (int k = 0; k < view->count; k++) {
        const int64_t i = bond_lower(view, k), j = bond_upper(view, k);
        double y[3], square = 0;
        for (int a = 0; a < 3; a++) {
            y[a] = view->xi[a][k * g] + u->upper[a][k] - u->lower[a][k];
            square += y[a] * y[a];
        }
        const double ti = lower[k] * view->volume_j[k * g] / sqrt(square),
                     tj = upper[k] * view->volume_i[k * g] / sqrt(square);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) {
                double term = y[a] * view->xi[b][k * g];
                body->S[3 * a + b][i] += ti * term;
                body->S[3 * a + b][j] += tj * term;
            }
    }
}
