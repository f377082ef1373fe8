/* cores.h - the centres of the coarse-grained cores (or of the grains of a random structure), which
 * do not know of any lattice spacing: one set of cores can be resolved at several.
 *
 * Around the centres stand equal spheres, or Voronoi cells shrunk by the same distance from all
 * their faces. */
#ifndef HS_CORES_H
#define HS_CORES_H

#include <stdbool.h>
#include <stdint.h>

enum core_shape { CORE_CELL, CORE_SPHERE };
enum core_lattice { LATTICE_SC, LATTICE_BCC, LATTICE_FCC };

/* The body that cores are made for, centred at the origin. */
struct cores_box {
    double size[3]; /* m */
    bool periodic[3];
    double offset[3]; /* m, from the body's centre to a site of a lattice of cores */
};

/* The periodic axes in their order, "xyz" or "xz" or ""; returns text. */
const char *cores_axes(const struct cores_box *box, char text[4]);

struct cores {
    enum core_shape shape;
    struct cores_box box;
    double distance; /* m, scale: nearest neighbours of the lattice, else mean cell size */
    int64_t count;
    double (*centre)[3]; /* [count] m; beyond the body too, as far as their cells reach in */
    int64_t *order;      /* [count] the order in which cells become coarse, of the first `own` a
                            permutation */
    /* Of a periodic body the first `own` are its cores, and what follows are their images within
     * `reach` (m) of it.  Else all are its own, and original and image are NULL. */
    int64_t own;
    int64_t *original; /* [count] the core that it is an image of, or itself */
    int (*image)[3];   /* [count] by how many sizes of the body it lies beyond the original */
    double reach;
    /* Boxes of the width `distance`, for searching: members of box b are
     * member[first[b]] ... member[first[b + 1] - 1]. */
    double low[3];
    int64_t boxes[3];
    int64_t *first, *member;
};

/* Edge of the cubic cell, in distances of nearest neighbours.  It is the shortest translation of
 * the lattice along x, y and z, for sc, bcc and fcc alike, so that a periodic body is a whole
 * number of edges long. */
double cores_lattice_edge(enum core_lattice lattice);

/* A cubic lattice of centres with a site at the box's offset; jitter: deviation of each coordinate,
 * in distances, Gaussian (stream "jitter"). */
struct cores cores_lattice(enum core_lattice lattice, enum core_shape shape, double distance,
                           double jitter, const struct cores_box *box, long seed);

/* Independent uniform centres (stream "positions"), their number the nearest whole one to density
 * (1/m^3) times the volume of the body grown by margin (m) on every side that is not periodic.  A
 * periodic body that expects less than one is the user's error (exit 2). */
struct cores cores_random(enum core_shape shape, double density, double margin,
                          const struct cores_box *box, long seed);

void cores_free(struct cores *cores);

/* Images of random cores are kept so many distances beyond the body: a ball of a radius of 2
 * distances without a centre, which is what they could not reach across, has the odds exp(-33). */
#define CORES_REACH 6

struct core_place {
    int64_t core;    /* index of the nearest centre */
    double distance; /* m, to it */
    double depth;    /* m, to the nearest face of its Voronoi cell */
};

/* Where a point (m) stands among the cores.  depth is found only where with_depth is not 0.  Dies
 * (exit 2) where cores of a periodic body leave a gap that their images do not reach across. */
struct core_place cores_place(const struct cores *cores, const double point[3], int with_depth);

/* Distance (m) of the two nearest centres, images included, whose spheres of the given diameter
 * touch the body; where there are no two, infinity. */
double cores_nearest_pair(const struct cores *cores, double diameter);

/* The .cores file: text, "%.17g", see docs/microstructure.md.  Reading refuses what it does not
 * understand with file:line (exit 2). */
void cores_write(const struct cores *cores, const char *topology, const char *path);
struct cores cores_read(const char *path, const char *topology);

/* To be called by whoever has filled box, distance, centres, order and count: moves the centres
 * into a periodic body and adds their images to `reach` (m) beyond it, and builds the search boxes.
 */
void cores_finish(struct cores *cores, double reach);

/* The search boxes alone. */
void cores_index(struct cores *cores);

#endif
