/* lattice.h - the whole body as every rank knows it: one byte a lattice site, and a bit for its
 * corner.
 *
 * Sites are numbered x fastest; a site without a particle is ABSENT.  Nodes (particles) are
 * numbered in site order, as in the domain file.
 *
 * Scattered particles are kept as a row of sites, each with a position and a volume of its own.
 *
 * A periodic body goes on beyond its sites: what lies there are images of them.  In a row there are
 * none: what two sites have between them is the shortest way from one to an image of the other.
 *
 * Where the unknowns are those of the corners of the particles' cells (corners.h), sites are
 * corners: the nodes are those that a particle has, and a particle is kept at the site of its
 * lowest corner.  A mesh of hexahedra is a row of such sites (mesh.h). */
#ifndef HS_LATTICE_H
#define HS_LATTICE_H

#include "domain.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { ABSENT = 255 };

/* Dimension, and in two of them what is zero across the plane. */
enum plane { SPACE, PLANE_STRESS, PLANE_STRAIN };

struct lattice {
    bool periodic[3]; /* along these axes the body repeats itself after size sites: a site beyond is
                         the image of one; of a row after period */
    bool mirror[3];   /* across these axes the plane below the first layer is one of symmetry */
    int dimensions;   /* 2: one layer of sites that has a thickness of its own; else 3 */
    int size[3];
    double spacing;     /* m; along x where edges differ */
    double edge[3];     /* m, of a cell along each axis */
    double thickness;   /* m, of the layer; in three dimensions 0 */
    double node_volume; /* m^3, of each: spacing^3, in two dimensions spacing^2 thickness */
    double origin[3];   /* m, position of site (0, 0, 0) */
    int64_t n_sites, n_nodes, n_particles;
    uint8_t *phase;      /* [n_sites] of the particle, or ABSENT */
    uint8_t *corner;     /* [lattice_corner_bytes] a bit a site: whether a particle has this corner;
                          * NULL: particles are the nodes */
    double *grain;       /* [n_sites] id of the particle's grain; NULL: none are known */
    double *point[3];    /* [n_sites] m, of scattered particles and nodes of a mesh; else NULL */
    double *volume;      /* [n_sites] m^3, likewise, and of those cut by the surface; else NULL */
    double extent[3];    /* m, between the outermost positions, likewise */
    double period[3];    /* m, of a row along its periodic axes; else 0 */
    int32_t *hexahedron; /* [8 n_sites] of a mesh: sites of the corners of the particle at a site,
                          * in the order of Exodus; else NULL */
    bool sorted;         /* the domain's nodes were in the order of their sites */
    int axis;            /* of the test: grips, gauge and what is measured along it */
    double finest; /* m, of a mesh: edge of the cube that is as stiff as its stiffest element */
};

/* Finds out whether the particles of a domain, in whatever order, lie on a lattice: positions
 * within 1e-6 spacings (of a long body that share of its length), equal volumes of a cell within
 * 1e-6, or, where the attribute volumes says cut, no larger ones; no site twice.  The edge of a
 * cell along x is the attribute spacing_m, else the cube root of the volume, those along y and z
 * spacing_y_m and spacing_z_m, else the same.
 *
 * Particles in one plane of z are a lattice of two dimensions where the attribute dimensions says
 * 2, or where it says nothing and their volume is not spacing^3; without spacing_m their spacing is
 * then the smallest distance along x.  The thickness is the attribute thickness_m, else volume /
 * spacing^2.
 *
 * False where they do not; then nothing is in the lattice.  The nodes' numbers are those of the
 * sites only after domain_sort. */
bool lattice_recognise(const struct domain *domain, struct lattice *lattice);

/* Site nearest to a position (m) within the lattice. */
int64_t lattice_nearest(const struct lattice *lattice, const double x[3]);

/* Periods that a domain says [m]: 0 along axes that are not periodic, NAN where it says none. */
void lattice_periods(const struct domain *domain, double period[3]);

/* Particles that lie on no lattice; of one layer where they lie in a plane and the thickness is not
 * 0.  Dies where the domain is periodic and says no period, or one that the particles do not fit.
 */
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

static inline bool lattice_contains(const struct lattice *lattice, int x, int y, int z)
{
    const int *n = lattice->size;
    return x >= 0 && y >= 0 && z >= 0 && x < n[0] && y < n[1] && z < n[2];
}

/* Whether its sites are a row, each with a position of its own. */
static inline bool lattice_is_row(const struct lattice *lattice)
{
    return lattice->point[0] != NULL;
}

/* The position among the sites of which this one is an image; itself where it is none. */
static inline void lattice_original(const struct lattice *lattice, const int at[3], int original[3])
{
    for (int a = 0; a < 3; a++) {
        const int n = lattice->size[a];
        const bool wraps = lattice->periodic[a] && !lattice_is_row(lattice);
        original[a] = wraps ? ((at[a] % n) + n) % n : at[a];
    }
}

static inline bool lattice_is_periodic(const struct lattice *lattice)
{
    return lattice->periodic[0] || lattice->periodic[1] || lattice->periodic[2];
}

/* Site at any integer position, that of the original of an image; -1 outside. */
static inline int64_t lattice_site_of(const struct lattice *lattice, const int at[3])
{
    int original[3];
    lattice_original(lattice, at, original);
    if (!lattice_contains(lattice, original[0], original[1], original[2])) return -1;
    return lattice_site(lattice, original[0], original[1], original[2]);
}

/* Phase at any integer position, ABSENT outside. */
static inline uint8_t lattice_phase(const struct lattice *lattice, int x, int y, int z)
{
    const int64_t site = lattice_site_of(lattice, (const int[]){x, y, z});
    return site < 0 ? ABSENT : lattice->phase[site];
}

static inline size_t lattice_corner_bytes(const struct lattice *lattice)
{
    return (size_t)(lattice->n_sites + 7) / 8;
}

/* Whether a site has a node. */
static inline bool lattice_has_node(const struct lattice *lattice, int64_t site)
{
    return lattice->corner ? lattice->corner[site / 8] >> (site % 8) & 1
                           : lattice->phase[site] != ABSENT;
}

/* Volume of the particle kept at a site [m^3]. */
static inline double lattice_volume(const struct lattice *lattice, int64_t site)
{
    return lattice->volume ? lattice->volume[site] : lattice->node_volume;
}

/* How many corners a particle's cell has; corner k from its lowest one: a step of 0 or 1 along each
 * axis. */
static inline int lattice_corners(const struct lattice *lattice)
{
    return lattice->dimensions == 2 ? 4 : 8;
}
static inline void lattice_corner_step(int k, int step[3])
{
    for (int a = 0; a < 3; a++) step[a] = k >> a & 1;
}

/* Whether its cells are no cubes (in a plane: squares). */
static inline bool lattice_is_oblong(const struct lattice *lattice)
{
    const double *edge = lattice->edge;
    return edge[1] < edge[0] || edge[1] > edge[0] || edge[2] < edge[0] || edge[2] > edge[0];
}

/* The largest face of a cell [m^2]. */
static inline double lattice_largest_face(const struct lattice *lattice)
{
    const bool flat = lattice->dimensions == 2;
    const double edge[3] = {lattice->edge[0], lattice->edge[1],
                            flat ? lattice->thickness : lattice->edge[2]};
    double largest = edge[0] * edge[1];
    for (int a = 0; a < 2; a++)
        if (edge[a] * edge[2] > largest) largest = edge[a] * edge[2];
    return largest;
}

/* Site of corner k of the particle at a site. */
static inline int64_t lattice_corner_site(const struct lattice *lattice, int64_t site, int k)
{
    int at[3], step[3];
    if (lattice->hexahedron) return lattice->hexahedron[8 * site + k];
    lattice_corner_step(k, step);
    if (!lattice_is_periodic(lattice))
        return site + lattice_site(lattice, step[0], step[1], step[2]);
    lattice_position(lattice, site, at);
    for (int a = 0; a < 3; a++) at[a] += step[a];
    return lattice_site_of(lattice, at);
}

/* Whether its particles lie on no lattice: a row of sites with a list of neighbours. */
static inline bool lattice_is_scattered(const struct lattice *lattice)
{
    return lattice_is_row(lattice) && !lattice->hexahedron;
}

/* Length after which a body repeats itself along a periodic axis [m]. */
static inline double lattice_period(const struct lattice *lattice, int axis)
{
    return lattice_is_row(lattice) ? lattice->period[axis]
                                   : lattice->size[axis] * lattice->edge[axis];
}

/* As many sites as a lattice of its spacing has along a periodic axis. */
static inline int lattice_places(const struct lattice *lattice, int axis)
{
    const double places = lattice->period[axis] / lattice->spacing;
    if (!lattice_is_row(lattice)) return lattice->size[axis];
    return places > 1.5 ? (int)(places + 0.5) : 1;
}

/* The shortest way between images of two places that are so far apart [m]; period 0: there are no
 * images. */
static inline double lattice_shortest(double apart, double period)
{
    return period > 0 ? apart - period * round(apart / period) : apart;
}

/* Of a row, from site i to the nearest image of j [m]. */
static inline void lattice_between(const struct lattice *lattice, int64_t i, int64_t j,
                                   double way[3])
{
    for (int a = 0; a < 3; a++)
        way[a] = lattice_shortest(lattice->point[a][j] - lattice->point[a][i], lattice->period[a]);
}

/* Volume of a body that is periodic along all of its axes, with what holes it has; of another one
 * that of its particles [m^3]. */
double lattice_whole_volume(const struct lattice *lattice);

/* Distance of the outermost positions along an axis, and the middle between them [m]. */
static inline double lattice_extent(const struct lattice *lattice, int axis)
{
    return lattice_is_row(lattice) ? lattice->extent[axis]
                                   : (lattice->size[axis] - 1) * lattice->edge[axis];
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
                                 : lattice->origin[a] + at[a] * lattice->edge[a];
}

/* Reference position of the particle kept at a site [m]: of one between corners the mean of theirs.
 */
static inline void lattice_particle(const struct lattice *lattice, const int at[3], double x[3])
{
    if (lattice->hexahedron) {
        const int32_t *corner = lattice->hexahedron + 8 * at[0];
        for (int a = 0; a < 3; a++) x[a] = 0;
        for (int k = 0; k < 8; k++) {
            double way[3];
            lattice_between(lattice, corner[0], corner[k], way);
            for (int a = 0; a < 3; a++) x[a] += 0.125 * (lattice->point[a][corner[0]] + way[a]);
        }
        for (int a = 0; a < 3; a++)
            if (lattice->periodic[a])
                x[a] -= lattice->period[a] *
                        floor((x[a] - lattice->origin[a]) / lattice->period[a] + 1e-9);
        return;
    }
    lattice_coordinates(lattice, at, x);
    for (int a = 0; lattice->corner && a < lattice->dimensions; a++) x[a] += 0.5 * lattice->edge[a];
}

#endif
