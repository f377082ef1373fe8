/* material.h - what each phase is made of. */
#ifndef HS_MATERIAL_H
#define HS_MATERIAL_H

#include "body.h"

struct formulation;
struct law;

struct material {
    const char *name; /* of the phase */
    double density;   /* kg/m^3 */
    double youngs_modulus, poissons_ratio;
    double shear_modulus, bulk_modulus; /* Pa */
    const struct law *law;
    void *parameters; /* of the law */
};

/* A law that some phase obeys. */
struct law_in_use {
    const struct law *law;
    void *pairs;    /* what its update reads, by pair; NULL: nothing */
    int *component; /* of each state (laws.h): its component among the law's; -1: not one of them */
};

/* All materials of a run and what the kernels read of them.  A bond between phases a and b takes
 * the means of their moduli: pair = a * count + b. */
struct materials {
    int count;
    enum plane plane;
    const struct formulation *formulation; /* of all phases */
    struct material *items;
    double *shear, *bulk; /* [count * count] by pair, Pa */
    int n_laws;
    struct law_in_use *laws;
    int *law_of; /* [count * count] by pair, which of laws */
};

void materials_free(struct materials *materials);

/* What the update of a law reads; NULL: no phase obeys it, or it needs nothing. */
const void *materials_pairs(const struct materials *materials, const struct law *law);

/* K, or in a plane K_2: E/(2(1 - nu)) in plane stress, E/(2(1 + nu)(1 - 2 nu)) in plane strain
 * [Pa]. */
double material_bulk_modulus(const struct material *material, enum plane plane);

/* Of a node [kg/m^3]. */
static inline double materials_density(const struct materials *materials, const struct body *body,
                                       int64_t site)
{
    return body->densities ? body->densities[site]
                           : materials->items[body->grid.phase[site]].density;
}

/* Fastest longitudinal wave [m/s] and largest Young's modulus [Pa]. */
double materials_wave_speed(const struct materials *materials);
double materials_stiffest(const struct materials *materials);

#endif
