/* hexahedron.h - volume and centroid of an element of eight corners. */
#ifndef HS_HEXAHEDRON_H
#define HS_HEXAHEDRON_H

struct hexahedron {
    double corner[8][3]; /* m, in the order of Exodus: four around a face, then those above them */
};

/* Volume (m^3) of the trilinear hexahedron x(r, s, t) = sum_i N_i x_i, with warped faces as they are, and
 * its centroid (m): the integrals of |dx/dr| and x |dx/dr| over the cube, whose integrands are of degree 2
 * and 3 in each of r, s, t, so that two Gauss points along each are exact.  Negative where the corners are in
 * the mirrored order. */
double hexahedron_volume(const struct hexahedron *hexahedron, double centroid[3]);

#endif
