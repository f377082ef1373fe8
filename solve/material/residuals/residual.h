/* residual.h - the energy of what the motion of a particle's corners has beyond the particle's own
 * gradient.
 *
 * Eight corners have twelve degrees of freedom more than a rigid motion and a gradient; without
 * energy of their own they would be free.  They are the amplitudes h_m of the products s_m of the
 * corners' signs (residual.1).  The energy has to flow with the material, or shells and necks grow
 * stiff.  To add one: one file, its name in the list below. */
#ifndef HS_RESIDUAL_H
#define HS_RESIDUAL_H

#include "keys.h"
#include "model.h"
#include "points.h"

/* s = xy, yz, zx, xyz, the coordinates of a cell running from -1 to 1; in a plane the first alone
 * is not zero. */
enum { MODES = 4, MODE_XYZ = 3 };

/* Rows of particles whose neighbours are asked for: particle i is element PAD + i, the elements
 * beside them are zero. */
enum { PAD = 8, PADDED = PAD + LANES + 8 };

/* A strip of particles between their corners. */
struct cells {
    const struct strip *strip;
    struct points *points;                /* in: H, moduli; of particles that carry nothing zero */
    HS_ALIGNED double volume[LANES];      /* in [m^3] */
    const double *integrity;              /* in: integrities; NULL: all are sound */
    HS_ALIGNED double h[MODES][3][LANES]; /* in: amplitudes [m] */
    double A[TENSOR][PADDED];             /* in and out: conjugate to H [J] */
    double m[MODES][3][PADDED];           /* out: conjugate to h [N] */
};

/* Adds share times the energies of a strip's particles to the sum, from their densities [J/m^3],
 * which become energies. */
static inline void cells_sum(const struct body *body, const struct cells *cells, double *density,
                             double share, struct exact_sum *sum)
{
    for (int i = 0; i < cells->strip->count; i++) density[i] *= cells->volume[i];
    body_sum_owned(body, cells->strip->site, cells->strip->count, density, share, sum);
}

struct hexahedra;

struct residual {
    struct variant words; /* name, help, and the keys that fill its parameters */
    size_t size;          /* of its parameters and state */
    /* body and materials live on; hexahedra: of a mesh, else NULL. */
    void (*start)(void *self, const struct body *body, const struct materials *materials,
                  struct hexahedra *hexahedra);
    double (*share)(const void *self); /* of the particle's own stress */
    /* flow: current flow stress of the particles [Pa], INFINITY: it never flows. */
    void (*add)(void *self, const struct body *body, struct cells *cells, const double *flow,
                struct force_mode mode, struct force_energy *energy);
    /* What it remembers (checkpoint.h), of the body's near strips. */
    void (*visit)(void *self, const struct strips *strips, struct checkpoint *checkpoint);
    void (*free)(void *self);
};

/* All of them: residual_NAME, each in a file of its own; the first is the default. */
#define RESIDUALS(DO)  DO(flowing), DO(four_points)
#define RESIDUAL(name) residual_##name
extern const struct residual RESIDUALS(RESIDUAL);

extern const struct section section_residual;

/* The one that the deck names, "residual: {form: ..., ...}", and what it has read; map.index 0: the
 * first one with its defaults. */
const struct residual *residual_read(struct deck_node map, void **self);

/* Derivative of s_m by coordinate a at the point r of the cell, for the edge lengths dx [1/m]. */
double residual_slope(int mode, int a, const double r[3], const double dx[3]);

#endif
