/* transform.h - the preconditioner of the static solver: an approximate inverse of the elastic
 * stiffness.
 *
 * The stiffness of a body is nearly diagonal, component by component, in waves that suit its ends:
 * sines where the component is held, cosines where it is free (symbol.h has the diagonal).
 * Inverting that diagonal leaves a number of iterations that grows neither with the number of
 * particles nor with the length of the body.  The waves fill the box around the free components;
 * where the body does not, there is nothing outside, before and after.  Of a body that is periodic
 * along all of its axes the components are not inverted one by one but together: of a uniform one
 * that is the inverse (Green's operator of the spectral methods on the same stencil: Willot, C. R.
 * Mecanique 343 (2015) 232).  A scattered particle counts where the nearest site of a lattice of
 * its mean distance would be.  All ranks share the boxes (slabs.h): along two axes lines of numbers
 * lie whole on a rank, then they are turned, so that at the stiffness a rank has the same waves of
 * all three components, where those have one box. */
#ifndef HS_TRANSFORM_H
#define HS_TRANSFORM_H

#include "box.h"
#include "symbol.h"
#include "unknowns.h"

struct transform;

/* held: held components that lie in a box are in r and z like the others.  Collective. */
struct transform *transform_new(const struct unknowns *unknowns, const struct box box[3],
                                const struct symbol *symbol, bool held);
void transform_free(struct transform *transform);

/* Whether particles share a site: then M^-1 does not tell them apart. */
bool transform_is_crowded(const struct transform *transform);

/* Share of the places of the boxes that free nodes stand for, of the component that has the least:
 * how far the waves are those of the body. */
double transform_filled(const struct transform *transform);

/* z = M^-1 r.  Collective. */
void transform_apply(struct transform *transform, const double *r, float *z);

#endif
