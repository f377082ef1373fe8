/* cores.h - the centres of the coarse-grained cores (or of the grains of a random structure), which
 * do not know of any lattice spacing: one set of cores can be resolved at several.
 *
 * Around the centres stand equal spheres, or Voronoi cells shrunk by the same distance from all
 * their faces. */
#ifndef HS_CORES_H
#define HS_CORES_H

#include <stdint.h>

enum core_shape { CORE_CELL, CORE_SPHERE };
enum core_lattice { LATTICE_SC, LATTICE_BCC, LATTICE_FCC };

struct cores {
    enum core_shape shape;
    double size[3];  /* m, the body they were made for, centred at the origin */
    double distance; /* m, scale: nearest neighbours of the lattice, else mean cell size */
    int64_t count;
    double (*centre)[3]; /* [count] m; beyond the body too, as far as their cells reach in */
    int64_t *order;      /* [count] the order in which cells become coarse, a permutation */
    /* Boxes of the width `distance`, for searching: members of box b are
     * member[first[b]] ... member[first[b + 1] - 1]. */
    double low[3];
    int64_t boxes[3];
    int64_t *first, *member;
};

/* A cubic lattice of centres with a site at the origin; jitter: deviation of each coordinate, in
 * distances, Gaussian (stream "jitter"). */
struct cores cores_lattice(enum core_lattice lattice, enum core_shape shape, double distance,
                           double jitter, const double size[3], long seed);

/* Independent uniform centres (stream "positions"), their number the nearest whole one to density
 * (1/m^3) times the volume of the body grown by margin (m) on every side. */
struct cores cores_random(enum core_shape shape, double density, double margin,
                          const double size[3], long seed);

void cores_free(struct cores *cores);

struct core_place {
    int64_t core;    /* index of the nearest centre */
    double distance; /* m, to it */
    double depth;    /* m, to the nearest face of its Voronoi cell */
};

/* Where a point (m) stands among the cores.  depth is found only where with_depth is not 0. */
struct core_place cores_place(const struct cores *cores, const double point[3], int with_depth);

/* Distance (m) of the two nearest centres whose spheres of the given diameter touch the body; where
 * there are no two, infinity. */
double cores_nearest_pair(const struct cores *cores, double diameter);

/* The .cores file: text, "%.17g", see docs/microstructure.md.  Reading refuses what it does not
 * understand with file:line (exit 2). */
void cores_write(const struct cores *cores, const char *topology, const char *path);
struct cores cores_read(const char *path, const char *topology);

/* Builds the search boxes; called by whoever fills the centres. */
void cores_index(struct cores *cores);

#endif
