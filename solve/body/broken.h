/* broken.h - which bonds of a lattice are broken or cut, looked up from a node.
 *
 * A broken bond has weight 0 in the list of bonds (bonds.h).  What walks over families instead of
 * bonds, the shape tensor, the deformation gradient and the divergence of stress, asks here.  A
 * body that is whole has no such record and pays nothing; of one that has, only nodes with a broken
 * bond are summed up bond by bond.  All ranks know the bonds of the nodes that they own; the
 * gradients of their ghosts come from the owners.
 *
 *   F_i = (1 + H_i) A_i,  H_i over the remaining bonds                                   (broken.1)
 *
 * A_i is 1 until the family of i changes amid a motion that is not uniform: then the remaining
 * bonds see another gradient than those before, and A_i becomes what keeps F_i as it was.  A strain
 * that jumped because a neighbour has gone would create energy from nothing, and flow, and break
 * the next. */
#ifndef HS_BROKEN_H
#define HS_BROKEN_H

#include "body.h"

#include <stdbool.h>

struct bonds;
struct bond_strip;
struct checkpoint;

struct broken {
    int words;      /* a site */
    uint64_t *bits; /* [n_sites * words] bit o: the bond along half offset o from this lower end */
    uint8_t *touched; /* [n_sites] 1: an end of a broken bond; 2: not yet in the shape tensor */
    double *keep[9];  /* box fields: A_i at touched nodes, row by row */
    double *whole;    /* box field: trace of K^-1 before any bond broke */
    double *lost;     /* box field, 1 at near nodes that have no deformation gradient any more */
    double n_lost;    /* nodes of the whole body without a deformation gradient */
};

void broken_free(struct broken *broken);

/* Bond k of the strip breaks; body->broken appears with the first one. */
void broken_add(struct body *body, struct bonds *bonds, struct bond_strip *strip, int k);

/* Shape tensors of the nodes that have lost bonds since the last call.  A node whose remaining
 * family does not span space, or has a K^-1 ten times that of the whole one, or sees a volume of
 * less than a fifth or more than five times that before, has an inverse of zero and counts as lost.
 * keep: body->H belongs to u, and F stays (broken.1).  To be called where any rank has broken a
 * bond.  Collective. */
void broken_shapes(struct body *body, bool keep);

/* Over the remaining bonds of the nodes from site on that have a broken one: sums[i] = sum of w
 * xi_b field_j, xi in spacings; the other sums stay. */
void broken_sums(const struct body *body, int64_t site, int count, const double *field, int b,
                 double *sums);

/* H of the nodes from site on that have a broken bond, found by (correspondence.1), becomes F - 1.
 */
void broken_keep_gradient(struct body *body, int64_t site, int count);
/* And their stress, conjugate to F, becomes conjugate to H. */
void broken_keep_stress(struct body *body, int64_t site, int count);

/* Which bonds are broken, and what the body remembers of it; those that are read break. Collective.
 */
void broken_visit(struct body *body, struct bonds *bonds, struct checkpoint *checkpoint);

static inline bool broken_bond(const struct broken *broken, int64_t lower, int o)
{
    return broken->bits[lower * broken->words + o / 64] >> (o % 64) & 1;
}

/* Whether the node of a site has lost its deformation gradient. */
static inline bool broken_lost(const struct broken *broken, int64_t site)
{
    return broken->lost[site] > 0;
}

#endif
