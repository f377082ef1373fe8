/* grid.h - the part of the lattice that a rank computes on.
 *
 * A padded box around the owned sites; every field is an array over the box, x contiguous, zero at
 * sites without a particle.  Work is listed as strips: runs of consecutive x, cut where the global
 * x is a multiple of LANES, ordered by global z, y, x.  Since each node's sums are made strip by
 * strip in that order, they have the same bits on any number of ranks. */
#ifndef HS_GRID_H
#define HS_GRID_H

#include "family.h"
#include "lattice.h"
#include "partition.h"

enum {
    SITE_OWNED = 1,
    SITE_NEAR = 2,     /* its deformation gradient is needed: owned, or bonded to an owned site */
    SITE_MOVES = 4,    /* its displacement comes from another rank */
    SITE_STRESSED = 8, /* its stress comes from another rank */
    SITE_GHOST = 16    /* near, but not owned */
};

struct strip {
    int64_t site; /* of its first point, in the box */
    int count;
    int x;         /* global x of its first point */
    int stride;    /* count rounded up to whole vectors: room for one number a point */
    int64_t store; /* sum of the strides of the strips before it */
};

struct strips {
    int64_t count;
    int64_t points; /* sum of the strides: state kept strip by strip needs this room a number */
    struct strip *items;
};

struct grid {
    int rank;
    int origin[3], size[3]; /* the box in global lattice coordinates */
    int64_t step[3];        /* from a site to the next along x, y, z */
    int64_t n_sites, n_owned;
    uint8_t *phase; /* [n_sites] or ABSENT */
    uint8_t *flags; /* [n_sites] SITE_... */
};

/* bonds: the half offsets along which bonds of the stabilisation run (n_bonds of them). */
struct grid grid_new(const struct lattice *lattice, const struct partition *partition,
                     const struct family *family, const struct offset *bonds, int n_bonds,
                     int rank);
void grid_free(struct grid *grid);

static inline int64_t grid_shift(const struct grid *grid, const int step[3])
{
    return step[0] * grid->step[0] + step[1] * grid->step[1] + step[2] * grid->step[2];
}

/* Box index of global coordinates, -1 outside of the box. */
int64_t grid_site(const struct grid *grid, const int at[3]);
/* Global coordinates of a box index. */
void grid_position(const struct grid *grid, int64_t site, int at[3]);

/* Strips of the sites with all of the flags wanted and none of those unwanted. */
struct strips grid_strips(const struct grid *grid, int wanted, int unwanted);
/* Strips of the lower ends i of the bonds i -> i + step with an owned end, cut at multiples of
 * lanes. */
struct strips grid_bond_strips(const struct grid *grid, const int step[3], int lanes);
void strips_free(struct strips *strips);

#endif
