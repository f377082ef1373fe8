#include "hexahedron.h"

#include <math.h>
#include <string.h>

/* Corners in the coordinates r, s, t of the cube from -1 to 1. */
static const int sides[8][3] = {
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1},
};

/* Position relative to the mean of the corners, and the determinant of its gradient, at one point
 * of the cube. */
static double at_point(double corner[8][3], const double r[3], double x[3])
{
    double g[3][3] = {{0}};
    for (int a = 0; a < 3; a++) x[a] = 0;
    for (int i = 0; i < 8; i++) {
        double part[3];
        for (int d = 0; d < 3; d++) part[d] = 0.5 * (1 + sides[i][d] * r[d]);
        for (int a = 0; a < 3; a++) {
            x[a] += part[0] * part[1] * part[2] * corner[i][a];
            g[a][0] += 0.5 * sides[i][0] * part[1] * part[2] * corner[i][a];
            g[a][1] += 0.5 * sides[i][1] * part[0] * part[2] * corner[i][a];
            g[a][2] += 0.5 * sides[i][2] * part[0] * part[1] * corner[i][a];
        }
    }
    return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) -
           g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
           g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

double hexahedron_volume(const struct hexahedron *hexahedron, double centroid[3])
{
    const double place = sqrt(1.0 / 3);
    double corner[8][3], mean[3] = {0}, moment[3] = {0}, volume = 0;
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) mean[a] += 0.125 * hexahedron->corner[i][a];
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) corner[i][a] = hexahedron->corner[i][a] - mean[a];
    for (int p = 0; p < 8; p++) {
        const double r[3] = {sides[p][0] * place, sides[p][1] * place, sides[p][2] * place};
        double x[3], determinant = at_point(corner, r, x);
        volume += determinant;
        for (int a = 0; a < 3; a++) moment[a] += determinant * x[a];
    }
    for (int a = 0; a < 3; a++) centroid[a] = mean[a] + moment[a] / volume;
    return volume;
}

/* Gradients of the shape functions at a point [1/m]; the determinant of dx/dr there. */
static double gradients(const struct hexahedron *hexahedron, const double r[3],
                        double gradient[8][3])
{
    double by_r[8][3], g[3][3] = {{0}}, inverse[3][3];
    for (int i = 0; i < 8; i++) {
        double part[3];
        for (int d = 0; d < 3; d++) part[d] = 0.5 * (1 + sides[i][d] * r[d]);
        for (int d = 0; d < 3; d++)
            by_r[i][d] = 0.5 * sides[i][d] * part[(d + 1) % 3] * part[(d + 2) % 3];
        for (int a = 0; a < 3; a++)
            for (int d = 0; d < 3; d++) g[a][d] += by_r[i][d] * hexahedron->corner[i][a];
    }
    /* By the determinant: inverse[d][a] = dr_d/dx_a. */
    for (int a = 0; a < 3; a++)
        for (int d = 0; d < 3; d++) {
            const int b = (a + 1) % 3, c = (a + 2) % 3, e = (d + 1) % 3, f = (d + 2) % 3;
            inverse[d][a] = g[b][e] * g[c][f] - g[b][f] * g[c][e];
        }
    double determinant = 0;
    for (int d = 0; d < 3; d++) determinant += g[0][d] * inverse[d][0];
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) {
            gradient[i][a] = 0;
            for (int d = 0; d < 3; d++) gradient[i][a] += by_r[i][d] * inverse[d][a] / determinant;
        }
    return determinant;
}

/* s_m at a corner. */
static int product(int m, int i)
{
    const int *s = sides[i];
    return m == 3 ? s[0] * s[1] * s[2] : s[m] * s[(m + 1) % 3];
}

static void slopes_of(double gradient[8][3], double slope[HEXAHEDRON_MODES][3])
{
    for (int m = 0; m < HEXAHEDRON_MODES; m++)
        for (int a = 0; a < 3; a++) {
            slope[m][a] = 0;
            for (int i = 0; i < 8; i++) slope[m][a] += product(m, i) * gradient[i][a];
        }
}

void hexahedron_slopes(const struct hexahedron *hexahedron, const double r[3],
                       double slope[HEXAHEDRON_MODES][3])
{
    double gradient[8][3];
    gradients(hexahedron, r, gradient);
    slopes_of(gradient, slope);
}

/* The four functionals of the corners that vanish for 1 and x and give 1 for their own product, 0
 * for the others: s_m less the affine motion that its values have by the gradients in the middle,
 * where those of all s_m vanish. */
static void find_amplitudes(const struct hexahedron *hexahedron, double middle[8][3],
                            double amplitude[HEXAHEDRON_MODES][8])
{
    for (int m = 0; m < HEXAHEDRON_MODES; m++) {
        double along[3] = {0};
        for (int i = 0; i < 8; i++)
            for (int a = 0; a < 3; a++) along[a] += product(m, i) * hexahedron->corner[i][a];
        for (int i = 0; i < 8; i++) {
            amplitude[m][i] = product(m, i);
            for (int a = 0; a < 3; a++) amplitude[m][i] -= along[a] * middle[i][a];
            amplitude[m][i] /= 8;
        }
    }
}

bool hexahedron_shape(const struct hexahedron *hexahedron, struct hexahedron_shape *shape)
{
    const double place = sqrt(1.0 / 3);
    double gradient[8][3], slope[HEXAHEDRON_MODES][3], mean[HEXAHEDRON_MODES][3] = {{0}},
                                                       volume = 0;
    memset(shape, 0, sizeof *shape);
    if (!(gradients(hexahedron, (const double[3]){0}, gradient) > 0)) return false;
    find_amplitudes(hexahedron, gradient, shape->amplitude);
    for (int p = 0; p < 8; p++) {
        const double r[3] = {sides[p][0] * place, sides[p][1] * place, sides[p][2] * place};
        const double weight = gradients(hexahedron, r, gradient);
        if (!(weight > 0)) return false;
        volume += weight;
        slopes_of(gradient, slope);
        for (int i = 0; i < 8; i++)
            for (int a = 0; a < 3; a++) shape->gradient[i][a] += weight * gradient[i][a];
        for (int m = 0; m < HEXAHEDRON_MODES; m++)
            for (int a = 0; a < 3; a++) {
                mean[m][a] += weight * slope[m][a];
                for (int n = 0; n < HEXAHEDRON_MODES; n++)
                    shape->spread[m][n] += weight * slope[m][a] * slope[n][a];
            }
    }
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) shape->gradient[i][a] /= volume;
    for (int m = 0; m < HEXAHEDRON_MODES; m++)
        for (int n = 0; n < HEXAHEDRON_MODES; n++) {
            shape->spread[m][n] /= volume;
            for (int a = 0; a < 3; a++)
                shape->spread[m][n] -= mean[m][a] / volume * mean[n][a] / volume;
        }
    return true;
}
