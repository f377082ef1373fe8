/* specimen.h - the outer shape: plate or dog-bone, its grips and its gauge.
 *
 * In two dimensions it is a sheet: one layer of nodes in the plane z = 0, whose thickness size[2] has
 * nothing to do with the spacing along x and y.  Lengths that a deck has in spacings are in the edge along x, but
 * components of the size and of corners of boxes in that axis' own. */
#ifndef HS_SPECIMEN_H
#define HS_SPECIMEN_H

#include "deck.h"
#include "domain.h"
#include "sites.h"

struct section;

enum specimen_shape { SPECIMEN_PLATE, SPECIMEN_DOGBONE };

struct specimen {
    enum specimen_shape shape;
    int64_t dimensions; /* 2: a sheet; else 3 */
    double size[3];     /* m, along x (loading), y, z */
    double spacing[3];  /* m, edges of a cell; the third of a sheet is its thickness */
    int64_t count[3];
    double gauge_length;    /* m, between the gauge planes; 0: none asked for */
    double gauge_width;     /* m, dog-bone: of the parallel part, along y */
    double fillet;          /* m, dog-bone: radius between the parallel part and the heads */
    int64_t grip_layers;    /* layers of nodes in each grip; 0: none asked for */
    const char *grip_phase; /* NULL: the structure goes on under the grips */
};

/* Names of shapes, and the sections of the deck with the keys of gauge, grips and further node sets. */
extern const char *const specimen_shapes[];
extern const struct section specimen_gauge, specimen_grips, specimen_set;

/* Reads the values of these keys of domain (index 0: none; a dog-bone has a gauge) into a specimen whose shape,
 * dimensions and spacing are known.  Each of the size's components must be a whole number of that axis'
 * spacings within 1e-6, but the thickness of a sheet. */
void specimen_read(struct specimen *specimen, struct deck_node size, struct deck_node gauge,
                   struct deck_node grips);

struct sites specimen_sites(const struct specimen *specimen);

bool specimen_is_sheet(const struct specimen *specimen);

/* Volume (m^3) of a cell, which its node owns. */
double specimen_node_volume(const struct specimen *specimen);

/* The box (m) that the microstructure has to fill: the size; of a sheet the plane z = 0, so that its
 * structure is the middle section through one of three dimensions whatever the thickness. */
void specimen_extent(const struct specimen *specimen, double extent[3]);

/* Half width (m, along y) of the dog-bone at the distance x from its middle: parallel, then an arc
 * of the fillet's radius that starts tangentially, then the head. */
double specimen_half_width(const struct specimen *specimen, double x);

/* [n_nodes] 1 where a node counts for fraction, topology and statistics: outside the grips. */
uint8_t *specimen_counted(const struct specimen *specimen, const struct sites *sites);

/* Adds grip_left, grip_right, gauge_left, gauge_right and the boxes of the deck's list `sets`. */
void specimen_add_sets(const struct specimen *specimen, const struct sites *sites,
                       struct deck_node sets, struct domain *out);

/* Layers (indices along x) of the gauge planes: those nearest to -/+ half the gauge length. */
void specimen_gauge_layers(const struct specimen *specimen, int64_t layer[2]);

/* Area of the section between the gauge planes (m^2), both layers included: number of nodes times
 * a cell's section over the number of layers; of the whole body where there is no gauge. */
double specimen_section(const struct specimen *specimen, const struct sites *sites);

#endif
