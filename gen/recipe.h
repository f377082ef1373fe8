/* recipe.h - the deck's domain section, checked and in SI units. */
#ifndef HS_RECIPE_H
#define HS_RECIPE_H

#include "cores.h"
#include "specimen.h"

#include <stdbool.h>

enum { PHASE_CG, PHASE_UFG, PHASE_GRIP };

/* The largest core distance or diameter, in spacings: scores stay exact whole numbers. */
#define LONGEST_DISTANCE 1e4

struct topology;

struct recipe {
    struct specimen specimen;
    const struct topology *topology;
    const char *phase_names[3]; /* cg, ufg, a third one of the grips or NULL */
    int n_phases;
    int grip_phase;         /* -1: the structure goes on under the grips */
    const char *cores_file; /* NULL: the cores are made here */
    enum core_lattice lattice;
    enum core_shape shape;
    double distance; /* m, harmonic: nearest neighbours; cells: mean size */
    double diameter; /* m, of random spheres */
    double jitter;
    double ufg_fraction;
    int geometric;        /* 1: whole cores, the nearest fraction that this allows */
    double minimum_shell; /* spacings */
    bool override;
    int64_t seed;
    struct deck_node symmetry, size, periodic, gauge, grips, notch, hole,
        sets; /* as the deck has them; index 0: none */
};

/* Reads the section `domain`; dies at the first thing that is wrong. */
struct recipe recipe_read(const struct deck *deck);

/* The box (m) that the microstructure fills. */
struct cores_box recipe_box(const struct recipe *recipe);

/* The cores, made or read; nothing in them where the structure has one phase.  The deck's size must
 * not be larger than that of the file, and along periodic axes the same. */
struct cores recipe_cores(struct recipe *recipe);

#endif
