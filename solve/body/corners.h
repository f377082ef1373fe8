/* corners.h - the corners of the particles' cells as the nodes of a body.
 *
 * A particle is a box around its position, as wide as the lattice is spaced; in two dimensions a
 * square of one layer. Its corners, which it shares with its neighbours, move; the particle itself
 * is a point of the material between them.  A corner has the shares of its particles' volume and
 * mass, one eighth (in a plane: one quarter) of each. */
#ifndef HS_CORNERS_H
#define HS_CORNERS_H

#include "body.h"
#include "domain.h"

/* The lattice of the corners of particles that lie on one. */
struct lattice corners_lattice(const struct lattice *particles);

/* Positions [m] and numbers of the corners, as a domain without phases and sets, which makes them
 * of the lattice as they are asked for; that lives as long. */
struct domain corners_domain(const struct lattice *lattice);

/* Ascending numbers of the corners that these particles have, a new list; count: in, of particles,
 * out, of corners. */
int64_t *corners_of_particles(const struct lattice *lattice, const int64_t *particles,
                              int64_t *count);

/* Volumes of the corners and density [phases, kg/m^3] of what they carry, over the box of a body of
 * corners. */
void corners_fill(struct body *body, const double density[]);

/* A field of the nodes at the particles, the mean of their corners, in out at the particles' sites;
 * of bodies whose particles are the nodes the field itself.  The field at the corners of other
 * ranks is brought up to date. Collective. */
const double *corners_mean(const struct body *body, double *field, double *out);

#endif
