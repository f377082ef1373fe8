#include "hexahedron.h"

#include <math.h>

/* Corners in the coordinates r, s, t of the cube from -1 to 1. */
static const int sides[8][3] = {
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1},
};

/* Position relative to the mean of the corners, and the determinant of its gradient, at one point of the
 * cube. */
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
