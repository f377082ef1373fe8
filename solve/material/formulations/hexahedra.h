/* hexahedra.h - families of particles between the corners of a mesh's hexahedra: each has a
 * gradient and modes of its own, where on a lattice all have the same (corner.c). */
#ifndef HS_HEXAHEDRA_H
#define HS_HEXAHEDRA_H

#include "points.h"

struct cells;
struct hexahedra;

/* Of the near particles of a body whose lattice is a mesh, which lives on. */
struct hexahedra *hexahedra_new(const struct body *body);
void hexahedra_free(struct hexahedra *hexahedra); /* NULL is none */

/* Takes for the amplitudes h_m those combinations of them that are normal: the mean over the cell
 * of the square of what the gradient has beyond its mean is then the sum of their squares [1], and
 * so are they.  On a box h'_m = w_m h_m (flowing.1). */
void hexahedra_normalise(struct hexahedra *hexahedra);

/* Unit vectors along the elements' own axes [TENSOR], strip by strip as box fields of points are:
 * from face to face along the first, across it in the plane of the first two, across both. */
void hexahedra_axes(const struct hexahedra *hexahedra, double *axes);

/* Gradient (corner.1) and amplitudes (corner.2) of the particles of a strip. */
void hexahedra_load(const struct hexahedra *hexahedra, const struct strip *strip,
                    struct points *points, struct cells *cells);

/* (corner.3): takes what the particles of a strip exert on their corners from f, in the order of
 * the particles. */
void hexahedra_scatter(const struct hexahedra *hexahedra, const struct cells *cells,
                       double *const f[3]);

#endif
