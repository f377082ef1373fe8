/* hexahedron.h - geometry of an element of eight corners. */
#ifndef HS_HEXAHEDRON_H
#define HS_HEXAHEDRON_H

#include <stdbool.h>

struct hexahedron {
    double corner[8][3]; /* m, in the order of Exodus: four around a face, then those above them */
};

/* Volume (m^3) of the trilinear hexahedron x(r, s, t) = sum_i N_i x_i, with warped faces as they
 * are, and its centroid (m): the integrals of |dx/dr| and x |dx/dr| over the cube, whose integrands
 * are of degree 2 and 3 in each of r, s, t, so that two Gauss points along each are exact. Negative
 * where the corners are in the mirrored order. */
double hexahedron_volume(const struct hexahedron *hexahedron, double centroid[3]);

/* The products rs, st, tr, rst of its coordinates, which run from -1 to 1. */
enum { HEXAHEDRON_MODES = 4 };

/* What a motion u = sum_i N_i u_i of the corners is made of: u = a + b x + sum_m h_m s_m(r)
 * (residual.1). */
struct hexahedron_shape {
    /* 1/m: the mean of grad u over the volume is sum_i u_i (x) gradient[i].  The integrands are of
     * degree 2: exact with the Gauss points of the volume (Flanagan, Belytschko, Int. J. Numer.
     * Methods Engrg. 17 (1981) 679). */
    double gradient[8][3];
    double amplitude[HEXAHEDRON_MODES]
                    [8]; /* h_m = sum_i amplitude[m][i] u_i; 0 of affine motions */
    /* 1/m^2: mean over the volume of the products of what grad s_m and grad s_n have beyond their
     * means, by the same points: the mean of |grad u - its mean|^2 is sum of h_m.h_n spread[m][n].
     */
    double spread[HEXAHEDRON_MODES][HEXAHEDRON_MODES];
};

/* False where the element is turned inside out in its middle or at a Gauss point. */
bool hexahedron_shape(const struct hexahedron *hexahedron, struct hexahedron_shape *shape);

/* grad s_m at the point r of an element that is nowhere inside out [1/m]. */
void hexahedron_slopes(const struct hexahedron *hexahedron, const double r[3],
                       double slope[HEXAHEDRON_MODES][3]);

#endif
