/* recipe.h - the deck's domain section, checked and in SI units. */
#ifndef HS_RECIPE_H
#define HS_RECIPE_H

#include "cores.h"
#include "image_labels.h"
#include "specimen.h"
#include "voxels.h"

#include <stdbool.h>

enum { PHASE_CG, PHASE_UFG, PHASE_GRIP };

/* The largest core distance or diameter, in spacings: scores stay exact whole numbers. */
#define LONGEST_DISTANCE 1e4

struct topology;

/* The deck's words on an image. */
struct measured {
    const char *file, *array, *grains;
    struct image_words words;
    struct deck_node voxel, raw, crop, mirror;
    double thickness; /* m; NaN: not said */
    enum voxels_rule rule;
    const char *format; /* of the file */
};

struct recipe {
    struct specimen specimen;
    const struct topology *topology;
    const char *phase_names[VOXEL_PHASES]; /* cg and ufg, or an image's, and one of the grips */
    int n_phases;
    int grip_phase;         /* -1: the structure goes on under the grips */
    const char *cores_file; /* NULL: the cores are made here */
    enum core_lattice lattice;
    enum core_shape shape;
    double distance; /* m, harmonic: nearest neighbours; cells: mean size */
    double diameter; /* m, of random spheres */
    double jitter;
    double offset[3]; /* m, of the lattice of cores */
    double ufg_fraction;
    int geometric;        /* 1: whole cores, the nearest fraction that this allows */
    double minimum_shell; /* spacings */
    bool override;
    unsigned require; /* REQUIRE_... */
    int64_t seed;
    struct measured measured;
    struct voxels voxels; /* of an image, else empty */
    struct deck_node require_list, symmetry, size, periodic, gauge, grips, notch, hole,
        sets; /* as the deck has them; index 0: none */
};

/* Reads the section `domain`; dies at the first thing that is wrong. */
struct recipe recipe_read(const struct deck *deck);
void recipe_free(struct recipe *recipe);

/* The sites of the lattice that get a node: those in the body, and not where an image is empty. */
struct sites recipe_sites(const struct recipe *recipe);

/* What of the image the node on a site gets; VOXEL_OUTSIDE where there is no image. */
struct voxel recipe_voxel(const struct recipe *recipe, const double position[3]);

/* The box (m) that the microstructure fills. */
struct cores_box recipe_box(const struct recipe *recipe);

/* The cores, made or read; nothing in them where the structure has one phase.  The deck's size must
 * not be larger than that of the file, and along periodic axes the same. */
struct cores recipe_cores(struct recipe *recipe);

#endif
