/* scattered.h - what takes another form when the particles lie on no lattice: sums over a family go
 * over the list of bonds. */
#ifndef HS_SCATTERED_H
#define HS_SCATTERED_H

#include "bonds.h"

/* body->inverse and body->unsupported from the weights as they stand, in the units of family.2 with
 * the mean volume as V.  Collective. */
void scattered_shapes(struct body *body);

/* (correspondence.1): body->H at near sites; (correspondence.2): adds the divergence of body->Q,
 * which is S K^-1 in those units, to body->f. */
void scattered_gradient(struct body *body);
void scattered_divergence(struct body *body);

#endif
