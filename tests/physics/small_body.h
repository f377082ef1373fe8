/* small_body.h - a body of a few hundred nodes on one rank, set up by hand: what the tests of the
 * solver's physics are made on. */
#ifndef HS_SMALL_BODY_H
#define HS_SMALL_BODY_H

#include "small_ranks.h"

#include "bonds.h"
#include "boundary.h"
#include "damage.h"
#include "laws.h"
#include "model.h"

#define SMALL_SPACING 25e-6 /* m */

/* What to build. */
struct small_case {
    int size[3];
    double horizon;            /* spacings */
    int influence;             /* 0 constant, 1 steep, ... as in family.c */
    const char *stabilisation; /* NULL: not a correspondence material */
    const char *materials;     /* a mapping; the phases are its first "A", "B", ... */
    int n_phases;              /* 0: one */
    uint8_t (*phase)(const int size[3], const int at[3]); /* NULL: a full box of phase 0 */
    enum plane plane; /* not SPACE: one layer as thick as the spacing */
    bool partial;     /* volumes */
    bool scattered;   /* through the list of neighbours, though the particles lie on a lattice */
    bool mesh;        /* of corner: as hexahedra of a mesh, in the opposite order */
    double jitter; /* each moved by up to this many spacings along each axis: of scattered ones, and
                    * of the corners of a mesh, which are then no boxes */
    const struct domain *points;    /* scattered particles of space, in place of size and phase */
    const char *surface_correction; /* NULL: none */
    const char *breaking;           /* further sections, "damage: ..., cracks: ...", or NULL */
    const char *residual;           /* of corner; NULL: the default */
    double edge[3];                 /* of a cell, in spacings; 0: 1 */
};

struct small_body {
    struct deck *deck;
    struct lattice lattice;
    struct family family;
    struct materials materials;
    struct body body;
    struct model *model;
    struct bonds *bonds;
    struct damage *damage;
    int64_t cut; /* bonds, by cracks */
};

/* Elastic, and nickel with Voce's law; both of phase A, and of phase B a stronger nickel. */
extern const char small_elastic[], small_nickel[], small_two_phases[];

extern const char small_mix[], small_capped[];

/* The body at rest.  Its address must stay. */
void small_body_new(struct small_body *small, const struct small_case *wanted);
void small_body_free(struct small_body *small);

/* The particles of a lattice. */
struct domain small_body_domain(const struct lattice *lattice);

/* The owned sites have a phase; the lattice place of one that is not scattered. */
bool small_body_has(const struct small_body *small, int64_t site);
void small_body_position(const struct small_body *small, int64_t site, int at[3]);

/* u = H X at every node. */
void small_body_deform(struct small_body *small, const double H[9]);

/* Adds amplitude (in spacings) times a number from [-1, 1) to each component of u; seeded. */
void small_body_shake(struct small_body *small, double amplitude, long seed);

/* Velocities up to about speed [m/s] that vary over the body, with a spin. */
void small_body_strike(struct small_body *small, double speed);

/* Force with these switches; nothing is summed up. */
void small_body_force(struct small_body *small, bool commit, bool frozen);

/* What is observed of a node: the number of it in node. */
int small_body_observe(struct small_body *small, int64_t site, struct node_state *node);

/* Smallest and largest equivalent plastic strain of the nodes. */
void small_body_plastic_range(struct small_body *small, double range[2]);

/* stored + stabilisation energy of the last state, elastic [J] */
double small_body_elastic_energy(struct small_body *small);

/* stored + plastic + stabilisation energy with yield, nothing committed [J]: the incremental
 * potential */
double small_body_potential(struct small_body *small);

/* Site in the middle of the box, and the nominal stress of a node, nothing committed [Pa]. */
int64_t small_body_middle(const struct small_body *small);
void small_body_stress(struct small_body *small, int64_t site, double P[9]);

/* sum over nodes of a . b, fields of three components */
double small_body_product(const struct small_body *small, double *const a[3], double *const b[3]);
/* max over nodes of the largest |a| */
double small_body_largest(const struct small_body *small, double *const a[3]);

/* A boundary that holds nothing: two empty sets. */
struct boundary small_free_boundary(void);

enum { SMALL_STATE = 16 }; /* numbers of a law at most */

/* A material point of the first phase under uniaxial stress along x: the lateral strain is found,
 * the state moves on. */
struct small_point {
    double state[SMALL_STATE];
    double H[9];
    double stress; /* P_xx, Pa */
};
struct small_point small_point_new(const struct materials *materials);
/* Its equivalent plastic strain, by the law j2. */
double small_point_plastic(const struct small_point *point);
/* F_xx = 1 + strain, P_yy = P_zz = 0 within 1e-13 of the shear modulus. */
void small_point_stretch(struct small_point *point, const struct materials *materials,
                         double strain);

#endif
