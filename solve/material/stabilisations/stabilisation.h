/* stabilisation.h - what resists the zero-energy modes of correspondence materials.
 *
 * A deformation gradient averaged over a family does not see motions that alternate from site to
 * site (Silling, Comput. Methods Appl. Mech. Engrg. 322 (2017) 42).  A stabilisation adds energy on
 * bonds for that part; it must yield with the material, or it acts as a strain-gradient stiffness
 * that poisons large plastic strain.  To add one: one file, its name in the list below. */
#ifndef HS_STABILISATION_H
#define HS_STABILISATION_H

#include "bonds.h"
#include "keys.h"
#include "material.h"
#include "model.h"

#include <stdbool.h>

struct stabilisation {
    struct variant words; /* name, help, and the keys that fill its parameters */
    size_t size;          /* of its parameters and state */
    /* The half offsets its bonds run along. */
    int (*bonds)(const void *self, const struct family *family, const struct offset **offsets);
    /* Allocates the bonds' state, kept strip by strip; bonds[o]: the strips along half offset o, of
     * add.  nominal: to whose nodes the bonds add their nominal axial stress where mode.record,
     * where they carry a share of it (box field). */
    void (*start)(void *self, const struct body *body, const struct materials *materials,
                  const struct strips bonds[], double *nominal);
    double (*node_share)(const void *self); /* weight of the node's own law; NULL: 1 */
    /* One of the two.  Forces go to body->f, stresses to body->S. */
    /* Bonds of a lattice whose lower end lies in the strip, along its offset number o. */
    void (*add)(void *self, struct body *body, int o, const struct strip *strip,
                struct force_mode mode, struct force_energy *energy);
    /* Bonds of the families, between scattered particles, too.  flow: current flow stress of near
     * nodes (box field). */
    void (*add_family)(void *self, struct body *body, const struct bond_strip *strip,
                       const double *flow, struct force_mode mode, struct force_energy *energy);
    /* As of struct formulation. */
    void (*visit)(void *self, const struct body *body, struct checkpoint *checkpoint);
    void (*free)(void *self);
};

/* All of them: stabilisation_NAME, each in a file of its own; the first is the default. */
#define STABILISATIONS(DO)  DO(mix), DO(capped)
#define STABILISATION(name) stabilisation_##name
extern const struct stabilisation STABILISATIONS(STABILISATION);

extern const struct section section_stabilisation;

/* The one that the deck names, "stabilisation: {law: ..., ...}", and what it has read; map.index 0:
 * the first one with its defaults, among scattered particles the first for these. */
const struct stabilisation *stabilisation_read(struct deck_node map, bool scattered, void **self);

#endif
