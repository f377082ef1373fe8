/* mesh.h - a mesh of hexahedra whose own nodes are the corners of the particles.
 *
 * Its nodes are a row of sites, each with its position, and particle p is kept at site p: nodes are
 * numbered anew, each particle in turn giving the next number to the first of its corners that has
 * none, so that it lies at one of its own.  A rank that has a node or a particle has all corners of
 * the particle within reach. */
#ifndef HS_MESH_H
#define HS_MESH_H

#include "domain.h"
#include "lattice.h"

/* What is made of nodes that lie on each other: one node, or a cut between the elements. */
enum mesh_coincident { MESH_JOIN, MESH_PART };

/* How many nodes of elements of a domain's mesh lie on others, or on their images (neighbours.h),
 * within 1e-5 of the mean edge; where they are to be joined, the elements and sets of all have the
 * first of them from here on. */
int64_t mesh_coincident(struct domain *domain, const double period[3], bool join);

/* Of a periodic domain: a node and its image become one.  Dies where a node of a face has none. */
void mesh_fold(struct domain *domain);

/* The lattice of a domain that has a mesh.  Its particles move to the means of their corners, where
 * the means of the corners' displacements belong.  *corners: the nodes in their new order with
 * their sets, those that no element has left out.  Dies where an element is inside out, or there
 * are more elements than nodes. */
struct lattice mesh_lattice(struct domain *domain, struct domain *corners);

/* Of each node the smallest edge of the cubes that are as stiff as its elements, [n_sites], a new
 * list [m]. */
double *mesh_edges(const struct lattice *lattice);

/* Places of a particle's corners. */
struct hexahedron;
void mesh_hexahedron(const struct lattice *lattice, int64_t site, struct hexahedron *hexahedron);

#endif
