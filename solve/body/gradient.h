/* gradient.h - the deformation gradient of a node from the motion of its family.
 *
 *   H_i = [sum_j w V (u_j - u_i) (x) xi] K_i^-1,  F_i = 1 + H_i                  (correspondence.1)
 *
 * Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, section 18. */
#ifndef HS_GRADIENT_H
#define HS_GRADIENT_H

#include "body.h"

/* body->H at near sites from body->u, whose ghosts are up to date. */
void displacement_gradient(struct body *body);

/* The same of some of the near strips, first to end - 1: on a lattice, where the fields of
 * gradients have been made, and of nodes whose bonds are whole or owned. */
void displacement_gradient_strips(struct body *body, int64_t first, int64_t end);

#endif
