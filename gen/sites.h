/* sites.h - the lattice that carries the nodes.
 *
 * The bounding box of the specimen is filled exactly by equal cells, boxes with the edges
 * `spacing`, and centred at the origin; a node sits at the centre of its cell and owns its volume,
 * or the part of it that lies in the specimen (of a sheet, one layer of them, a column of its own
 * thickness: specimen.h).  A specimen that is no block leaves sites empty, and may be turned about
 * z against the lattice.  Nodes are numbered x fastest, then y, then z, empty sites skipped. */
#ifndef HS_SITES_H
#define HS_SITES_H

#include <stdbool.h>
#include <stdint.h>

struct sites {
    int64_t count[3];  /* cells along x, y, z */
    double spacing[3]; /* m, their edges */
    int64_t n_nodes;
    int64_t *node;  /* [count[0] * count[1] * count[2]] node on the site, -1 where there is none */
    int64_t *site;  /* [n_nodes] */
    double *volume; /* [n_nodes] m^3; NULL: all own their cells */
    double turn[2]; /* cosine and sine of the angle from the lattice's x to the body's */
    bool periodic[3]; /* along these axes the last layer's neighbour is the first one */
    bool
        mirrored[3]; /* the lower half along these has no nodes: it is the image of the upper one */
};

/* Says whether a node sits on the site, whose centre is the point (m, from the body's centre). */
typedef bool sites_inside(const void *specimen, int64_t site, const double point[3]);

struct sites sites_new(const int64_t count[3], const double spacing[3], sites_inside *inside,
                       const void *specimen);
void sites_free(struct sites *sites);

/* "25", or "25 x 50 x 50" of cells that are no cubes [um]; the caller frees it. */
char *sites_cell(const struct sites *sites);

/* Lattice indices of a node. */
void sites_index(const struct sites *sites, int64_t node, int64_t index[3]);

/* Coordinate (m) of layer i along an axis: (i + 1/2 - count / 2) edges. */
double sites_coordinate(const struct sites *sites, int axis, int64_t i);

void sites_position(const struct sites *sites, int64_t node, double position[3]);

/* The same in the frame of the body: without a turn the same bits. */
void sites_in_body(const struct sites *sites, int64_t node, double position[3]);

/* Centre of a site (m); how many there are, fewer than 2^31 or the user's error (exit 2). */
void sites_centre(const struct sites *sites, int64_t site, double centre[3]);
int64_t sites_number(const int64_t count[3]);

/* m^3, of a node, and of all of them that are in `counted` ([n_nodes]; NULL: all). */
double sites_volume(const struct sites *sites, int64_t node);
double sites_whole_volume(const struct sites *sites, const uint8_t *counted);

/* How often the way from the box to layer i along an axis goes around the body: 0 within it, 1 in
 * its next image, -1 in the one before; 0 along axes that are not periodic. */
static inline int64_t sites_around(const struct sites *sites, int axis, int64_t i)
{
    const int64_t count = sites->count[axis];
    if (!sites->periodic[axis] || (i >= 0 && i < count)) return 0;
    return i >= 0 ? i / count : -((count - 1 - i) / count);
}

/* Node at the indices, in a periodic body the one whose image is there; -1 outside or where the
 * site is empty. */
static inline int64_t sites_at(const struct sites *sites, int64_t i, int64_t j, int64_t k)
{
    const int64_t *count = sites->count;
    i -= count[0] * sites_around(sites, 0, i);
    j -= count[1] * sites_around(sites, 1, j);
    k -= count[2] * sites_around(sites, 2, k);
    if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2]) return -1;
    return sites->node[i + count[0] * (j + count[1] * k)];
}

#endif
