/* specimen.h - the outer shape of the body: flat or round, with heads, notches, a hole, its grips
 * and its gauge.
 *
 * In two dimensions it is a sheet: one layer of nodes in the plane z = 0, whose thickness size[2]
 * has nothing to do with the spacing along x and y.  Lengths that a deck has in spacings are in the
 * edge along x, but components of the size and of corners of boxes in that axis' own.
 *
 * The body has a frame of its own, which may be turned about z against that of the lattice; both
 * have their origin in its centre. */
#ifndef HS_SPECIMEN_H
#define HS_SPECIMEN_H

#include "deck.h"
#include "domain.h"
#include "sites.h"

struct section;

enum specimen_shape { SPECIMEN_PLATE, SPECIMEN_DOGBONE, SPECIMEN_ROD, SPECIMEN_ROUND_DOGBONE };
enum specimen_volumes { VOLUMES_WHOLE, VOLUMES_CUT };

struct specimen {
    enum specimen_shape shape;
    int64_t dimensions; /* 2: a sheet; else 3 */
    double size[3];     /* m, along the body's x (loading), y, z */
    double spacing[3];  /* m, edges of a cell; the third of a sheet is its thickness */
    bool symmetry[3]; /* across these axes the middle is a plane of symmetry: the part above is made
                       */
    bool periodic[3]; /* along these axes the body goes on with its own image */
    int64_t count[3]; /* cells of the lattice, which hold the body */
    double diameter;  /* m, of a round one, heads included */
    double angle;     /* rad, about z, from the lattice's x to the body's */
    enum specimen_volumes volumes;
    double gauge_length; /* m, between the gauge planes; 0: none asked for */
    double gauge_width;  /* m, of the parallel part between heads: along y, or its diameter */
    double fillet;       /* m, radius between the parallel part and the heads */
    double notch_radius, notch_depth;     /* m, all around or on both sides, at x = 0; 0: none */
    double hole_centre[2], hole_diameter; /* m, along z, in the body's frame; 0: none */
    double grip_length;     /* m, whole layers where the body is not turned; 0: none asked for */
    const char *grip_phase; /* NULL: the structure goes on under the grips */
};

/* Names of shapes and volumes, and the sections of the deck with the keys of gauge, grips and so
 * on. */
extern const char *const specimen_shapes[];
extern const char *const specimen_volumes[];
extern const struct section specimen_gauge, specimen_grips, specimen_notch, specimen_hole,
    specimen_set;

/* Reads the keys of the section domain that are left into a specimen whose shape, dimensions,
 * spacing, diameter and angle are known; without the key `size` count and size are, too.  Along the
 * axes of a lattice that it is to fill, each of the size's components must be a whole number of
 * that axis' spacings within 1e-6, but the thickness of a sheet. */
void specimen_read(struct specimen *specimen, struct deck_node domain);

bool specimen_is_sheet(const struct specimen *specimen);
bool specimen_is_round(const struct specimen *specimen);
/* Whether it is a plain plate that lies along the lattice, which cells fill wholly. */
bool specimen_is_block(const struct specimen *specimen);

/* Volume (m^3) of a cell. */
double specimen_node_volume(const struct specimen *specimen);

/* The box (m) in the body's frame that the microstructure has to fill: the size; of a sheet the
 * plane z = 0, so that its structure is the middle section through one of three dimensions whatever
 * the thickness. */
void specimen_extent(const struct specimen *specimen, double extent[3]);

/* A place where the section is less: over 2 length of x the half width is `bottom`, then come arcs
 * of the radius that start tangentially, up to `top` or, where they are a half turn, walls along y.
 */
struct pocket {
    double length, bottom, radius, top;
};

/* Those of the parallel part between heads and of the notch, outer first; returns how many. */
int specimen_pockets(const struct specimen *specimen, struct pocket pockets[2]);

/* Half width (m, along y; of a round body its radius) at the distance x from its middle, the hole
 * apart.  It never falls away from the middle. */
double specimen_half_width(const struct specimen *specimen, double x);

/* The axes along which the sites are periodic, or half of their images. */
void specimen_repeats(const struct specimen *specimen, struct sites *sites);

/* [n_nodes] 1 where a node counts for fraction, topology and statistics: outside the grips. */
uint8_t *specimen_counted(const struct specimen *specimen, const struct sites *sites);

/* Adds grip_left, grip_right, gauge_left, gauge_right and the boxes of the deck's list `sets`. */
void specimen_add_sets(const struct specimen *specimen, const struct sites *sites,
                       struct deck_node sets, struct domain *out);

/* Layers (indices along x) of the gauge planes of a body that is not turned: those nearest to -/+
 * half the gauge length. */
void specimen_gauge_layers(const struct specimen *specimen, int64_t layer[2]);

#endif
