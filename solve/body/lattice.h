/* lattice.h - the whole body as every rank knows it: one byte a lattice site.
 *
 * Sites are numbered x fastest; a site without a particle is ABSENT.  Nodes (particles) are numbered in
 * site order, as in the domain file.
 *
 * Scattered particles are kept as a row of sites, each with a position and a volume of its own. */
#ifndef HS_LATTICE_H
#define HS_LATTICE_H

#include "domain.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { ABSENT = 255 };

/* Dimension, and in two of them what is zero across the plane. */
enum plane { SPACE, PLANE_STRESS, PLANE_STRAIN };

struct lattice {
    int dimensions; /* 2: one layer of sites that has a thickness of its own; else 3 */
    int size[3];
    double spacing;     /* m */
    double thickness;   /* m, of the layer; in three dimensions 0 */
    double node_volume; /* m^3, of each: spacing^3, in two dimensions spacing^2 thickness */
    double origin[3];   /* m, position of site (0, 0, 0) */
    int64_t n_sites, n_nodes;
    uint8_t *phase;   /* [n_sites] or ABSENT */
    double *point[3]; /* [n_sites] m, of scattered particles; else NULL */
    double *volume;   /* [n_sites] m^3, likewise */
    double extent[3]; /* m, between the outermost positions, likewise */
};

/* Finds out whether the particles of a domain, in whatever order, lie on a cubic lattice: positions
 * within 1e-6 spacings (of a long body that share of its length), equal volumes spacing^3 within 1e-6,
 * no site twice.  The spacing is the attribute spacing_m, else the cube root of the volume.
 *
 * Particles in one plane of z are a lattice of two dimensions where the attribute dimensions says 2, or
 * where it says nothing and their volume is not spacing^3; without spacing_m their spacing is then the
 * smallest distance along x.  The thickness is the attribute thickness_m, else volume / spacing^2.
 *
 * False where they do not; then nothing is in the lattice.  The nodes' numbers are those of the sites
 * only after domain_sort. */
bool lattice_recognise(const struct domain *domain, struct lattice *lattice);

/* Site nearest to a position (m) within the lattice. */
int64_t lattice_nearest(const struct lattice *lattice, const double x[3]);

/* Particles that lie on no lattice; of one layer where they lie in a plane and the thickness is not 0. */
struct lattice lattice_scattered(const struct domain *domain, double thickness);

/* Copies rank 0's lattice to all ranks. */
void lattice_share(struct lattice *lattice, int rank);
void lattice_free(struct lattice *lattice);

static inline int64_t lattice_site(const struct lattice *lattice, int x, int y, int z)
{
    return ((int64_t)z * lattice->size[1] + y) * lattice->size[0] + x;
}

/* Position of a site along the axes. */
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

/* Whether its particles lie on no lattice: a row of sites with a list of neighbours. */
static inline bool lattice_is_scattered(const struct lattice *lattice)
{
    return lattice->point[0] != NULL;
}

/* Distance of the outermost positions along an axis, and the middle between them [m]. */
static inline double lattice_extent(const struct lattice *lattice, int axis)
{
    return lattice_is_scattered(lattice) ? lattice->extent[axis]
                                         : (lattice->size[axis] - 1) * lattice->spacing;
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
