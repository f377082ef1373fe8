/* body.h - the particles of one rank: where they are, how they move, what acts on them. */
#ifndef HS_BODY_H
#define HS_BODY_H

#include "exact_sum.h"
#include "family.h"
#include "grid.h"
#include "halo.h"
#include "lattice.h"
#include "partition.h"
#include "ranks.h"

#include <string.h>

struct bonds;
struct broken;
struct integrity;
struct profile;

struct body {
    struct ranks ranks;
    const struct lattice *lattice;
    const struct family *family;
    struct partition partition;
    struct grid grid;
    struct profile *profile; /* NULL: none */
    struct halo *displacement_halo, *stress_halo, *gradient_halo;
    struct strips owned, near, ghosts; /* ghosts: near sites that are not owned */
    /* Of a periodic body, row by row: the mean displacement gradient, its rate [1/s], and the mean
     * nominal stress of the last force [Pa], along the axes of the test, which are the rows of
     * frame; turned: not those of the lattice.  The gradient of the last force along these. */
    double frame[9], mean_gradient[9], mean_rate[9], mean_stress[9], lattice_gradient[9];
    bool turned;
    double whole_volume;           /* of a periodic body with its holes, m^3 */
    struct exact_sum *stress_sums; /* [9] P V [J] of owned particles, in a force; else NULL */
    struct bonds *bonds;
    double volume;            /* of a node, m^3; of scattered ones their mean */
    double *volumes;          /* box field where they differ, else NULL */
    double *particle_volumes; /* where particles between corners have different ones, else NULL */
    double *densities;   /* of corners [kg/m^3], box field; NULL: a node has that of its phase */
    int64_t n_nodes;     /* of the whole body */
    int64_t unsupported; /* nodes of the whole body without a deformation gradient */
    /* Made and freed by damage and cracks (damage.h). */
    struct broken *broken;       /* NULL: all bonds are whole */
    struct integrity *integrity; /* NULL: no node degrades */

    /* Fields over the grid's box. */
    double *u[3]; /* displacement, of a periodic body beyond that of the mean gradient, m */
    double *v[3]; /* velocity, m/s */
    union {
        double *f[3];        /* internal force density, N/m^3 */
        double *before_f[3]; /* sums over families that are used up before the forces are made */
    };
    double *b[3]; /* external force density, N/m^3; NULL along axes without loads */
    /* Made by body_need_gradient, else NULL. */
    double *H[9]; /* displacement gradient F - 1, row by row; valid at near sites */
    union {
        double *S[9];        /* nominal stress, Pa */
        double *Q[9];        /* S K^-1 in its place (correspondence.2), Pa/m */
        double *before_S[9]; /* forces on nodes, where a stress is not made yet */
    };
    double *inverse[6];  /* inverse shape tensor, lattice units */
    double *first[3];    /* s_i of family.2, lattice units */
    double *yield_shift; /* what a node's flow stress has over its law's, Pa; NULL: nothing */
};

/* bonds: the half offsets of the stabilisation, which decide what lies near. */
struct body body_new(const struct lattice *lattice, const struct family *family,
                     const struct offset *bonds, int n_bonds, struct ranks ranks);
void body_free(struct body *body);

/* profile: lives as long as the body. */
void body_profile(struct body *body, struct profile *profile);

/* Axes of the test of a periodic body: x along a direction of the lattice, z as close to the
 * lattice's z as may be, or where these two are one to -x. */
void body_turn(struct body *body, const double direction[3]);

/* A tensor of the lattice's axes along those of the test, and back: out = R T R^T, R^T T R. */
void body_to_test(const struct body *body, const double T[9], double out[9]);
void body_to_lattice(const struct body *body, const double T[9], double out[9]);

/* Makes the fields of gradients and stresses and counts the unsupported nodes, at the first call:
 * formulations whose forces come from bonds need them for output and for damage alone.  Collective.
 */
void body_need_gradient(struct body *body);

/* Adds the mean gradient of a periodic body to body->H from a site on, where a node has one. */
void body_add_mean(struct body *body, int64_t site, int count);

/* Reference position of a site [m]. */
static inline void body_position(const struct body *body, int64_t site, double x[3])
{
    int at[3];
    grid_position(&body->grid, site, at);
    lattice_coordinates(body->lattice, at, x);
}

/* That of the particle at a site [m]. */
static inline void body_particle_position(const struct body *body, int64_t site, double x[3])
{
    int at[3];
    grid_position(&body->grid, site, at);
    lattice_particle(body->lattice, at, x);
}

/* A number of the site's node that is the same on every rank: its site in the lattice, of an image
 * that of its original. */
static inline int64_t body_number(const struct body *body, int64_t site)
{
    int at[3];
    grid_position(&body->grid, site, at);
    return lattice_site_of(body->lattice, at);
}

/* Volume of the node at a site [m^3]. */
static inline double body_volume(const struct body *body, int64_t site)
{
    return body->volumes ? body->volumes[site] : body->volume;
}

/* Volume of the particle at a site [m^3]. */
static inline double body_particle_volume(const struct body *body, int64_t site)
{
    if (!body->lattice->corner) return body_volume(body, site);
    return body->particle_volumes ? body->particle_volumes[site] : body->volume;
}

/* terms[i] times the volume of the node at site + i. */
static inline void body_times_volume(const struct body *body, int64_t site, int count,
                                     double *terms)
{
    for (int i = 0; i < count; i++)
        terms[i] *= body->volumes ? body->volumes[site + i] : body->volume;
}

/* Box fields set to zero. */
static inline void body_clear(const struct body *body, double *const fields[], int count)
{
    for (int k = 0; k < count; k++)
        memset(fields[k], 0, (size_t)body->grid.n_sites * sizeof(double));
}

/* Adds scale times the terms of nodes or particles from site on to the sum; those that are not
 * owned, which another rank counts, become zero. */
static inline void body_sum_owned(const struct body *body, int64_t site, int count, double *terms,
                                  double scale, struct exact_sum *sum)
{
    for (int i = 0; i < count; i++)
        terms[i] = (body->grid.flags[site + i] & SITE_OWNED) ? terms[i] : 0;
    exact_sum_add_strip(sum, count, terms, scale);
}

#endif
