/* material.h - what each phase is made of, from the deck's section "materials". */
#ifndef HS_MATERIAL_H
#define HS_MATERIAL_H

#include "deck.h"
#include "flow_curve.h"
#include "hardening.h"
#include "lattice.h"
#include "yield.h"

#include <stdbool.h>

struct body;
struct formulation;

struct material {
    const char *name; /* of the phase */
    double density;   /* kg/m^3 */
    double youngs_modulus, poissons_ratio;
    double shear_modulus, bulk_modulus; /* Pa */
    bool yields;                        /* has a hardening law */
    struct hardening hardening;
    struct yield_variation yield;
};

/* All materials of a run and what the kernels read of them.  A bond between phases a and b takes the
 * means of their moduli and of their flow stresses: pair = a * count + b. */
struct materials {
    int count;
    enum plane plane;
    const struct formulation *formulation; /* of all of them */
    struct material *items;
    struct flow_curves curves; /* [count * count] by pair */
    double *shear, *bulk;      /* [count * count] by pair, Pa */
};

/* One entry for each phase of the domain; a phase without an entry is an error, an entry without a
 * phase only a note.  Dies where the materials have not one formulation in common. */
struct materials materials_read(struct deck_node section, int n_phases, char *const phase_names[],
                                enum plane plane);
void materials_free(struct materials *materials);

/* Yield stresses that vary within a phase (yield.h), of a body of these materials. */
void materials_vary_yield(const struct materials *materials, struct body *body);

/* K, or in a plane K_2: E/(2(1 - nu)) in plane stress, E/(2(1 + nu)(1 - 2 nu)) in plane strain [Pa]. */
double material_bulk_modulus(const struct material *material, enum plane plane);

/* Fastest longitudinal wave [m/s] and largest Young's modulus [Pa]. */
double materials_wave_speed(const struct materials *materials);
double materials_stiffest(const struct materials *materials);

#endif
