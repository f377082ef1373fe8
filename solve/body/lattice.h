/* lattice.h - the whole body as every rank knows it: one byte a lattice site.
 *
 * Sites are numbered x fastest; a site without a particle is ABSENT.  Nodes (particles) are numbered in
 * site order, as in the domain file.
 *
 * Scattered particles are kept as a row of sites, each with a position and a volume of its own. */
#ifndef HS_LATTICE_H
#define HS_LATTICE_H

#include "domain.h"

#include <stdint.h>

enum { ABSENT = 255 };

struct lattice {
    int size[3];
    int dimensions;     /* 2: one layer of particles in z */
    double spacing;     /* m */
    double thickness;   /* of the layer where dimensions is 2, m */
    double node_volume; /* m^3 */
    double origin[3];   /* m, position of site (0, 0, 0) */
    int64_t n_sites, n_nodes;
    uint8_t *phase;   /* [n_sites] or ABSENT */
    double *point[3]; /* [n_sites] m, of scattered particles; else NULL */
    double *volume;   /* [n_sites] m^3, likewise */
    double extent[3]; /* m, between the outermost positions, likewise */
};

/* Recognises the lattice in a domain (every rank may call it with rank 0's domain only): positions on
 * a cubic lattice within 1e-6 spacings, equal volumes spacing^3 within 1e-6, no site twice.  Dies,
 * naming the first node that does not fit, since scattered particles are not supported. */
struct lattice lattice_find(const struct domain *domain);

/* Particles that lie on no lattice: spacing is the edge of a cube (of a square of the given thickness, where
 * they lie in a plane and it is not 0) of their mean volume. */
struct lattice lattice_scattered(const struct domain *domain, double thickness);

/* Copies rank 0's lattice to all ranks. */
void lattice_share(struct lattice *lattice, int rank);
void lattice_free(struct lattice *lattice);

static inline int64_t lattice_site(const struct lattice *lattice, int x, int y, int z)
{
    return ((int64_t)z * lattice->size[1] + y) * lattice->size[0] + x;
}

/* The reverse. */
static inline void lattice_position(const struct lattice *lattice, int64_t site, int at[3])
{
    int64_t line = site / lattice->size[0];
    at[0] = (int)(site % lattice->size[0]);
    at[1] = (int)(line % lattice->size[1]);
    at[2] = (int)(line / lattice->size[1]);
}

/* Phase at any integer position, ABSENT outside. */
static inline uint8_t lattice_phase(const struct lattice *lattice, int x, int y, int z)
{
    const int *n = lattice->size;
    if (x < 0 || y < 0 || z < 0 || x >= n[0] || y >= n[1] || z >= n[2]) return ABSENT;
    return lattice->phase[lattice_site(lattice, x, y, z)];
}

/* Distance of the outermost positions along an axis, and the middle between them [m]. */
static inline double lattice_extent(const struct lattice *lattice, int axis)
{
    return lattice->point[0] ? lattice->extent[axis] : (lattice->size[axis] - 1) * lattice->spacing;
}
static inline double lattice_middle(const struct lattice *lattice, int axis)
{
    return lattice->origin[axis] + 0.5 * lattice_extent(lattice, axis);
}

/* Reference position of a site [m]. */
static inline void lattice_coordinates(const struct lattice *lattice, const int at[3], double x[3])
{
    for (int a = 0; a < 3; a++)
        x[a] = lattice->point[a] ? lattice->point[a][at[0]]
                                 : lattice->origin[a] + at[a] * lattice->spacing;
}

#endif
