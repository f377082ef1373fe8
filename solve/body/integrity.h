/* integrity.h - the share of its stress that a degraded node, or a bond between two, still carries.
 *
 * The integrity c of a node is 1 minus its damage: 1 of a sound one, 0 of one that is about to go.
 * A bond that has a stress or force of its own has an integrity combined from those of its ends.
 * The field moves on between the evaluations of the force (damage.h), which read it alone.  A body
 * in which nothing can degrade has no such record and pays nothing; before anything has, one look
 * at a flag. */
#ifndef HS_INTEGRITY_H
#define HS_INTEGRITY_H

#include "bonds.h"

#include <stdbool.h>

/* How two numbers become one; 0 and 0 become 0 in each way. */
enum combination { COMBINE_SMALLER, COMBINE_LARGER, COMBINE_MEAN, COMBINE_HARMONIC, COMBINATIONS };
double combine(enum combination combination, double a, double b);

struct integrity {
    bool whole;   /* nothing has degraded yet, on any rank */
    double *node; /* box field: c */
    int n_phases;
    enum combination *bonds; /* [n_phases^2] between two phases */
};

/* Of a body all of which is sound; bonds is copied. */
struct integrity *integrity_new(const struct body *body, int n_phases,
                                const enum combination bonds[]);
void integrity_free(struct integrity *integrity);

/* Integrities of the nodes from site on, or of the bonds of a view, of which lattice strips need i,
 * j and count alone; NULL where all are sound.  buffer: [LANES], for those of bonds. */
const double *integrity_of_nodes(const struct body *body, int64_t site, int count);
const double *integrity_of_bonds(const struct body *body, const struct bond_view *view,
                                 double *buffer);

#endif
