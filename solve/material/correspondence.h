/* correspondence.h - non-ordinary state-based peridynamics: a classical law at every node.
 *
 *   H_i = [sum_j w V (u_j - u_i) (x) xi] K_i^-1,  F_i = 1 + H_i                   (correspondence.1)
 *   f_i = sum_j w V (Q_i + Q_j) xi,  Q = S K^-1,  S = P(F) + stabilisation        (correspondence.2)
 *
 * Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, section 18; total Lagrangian.  The
 * shape tensor normalises families cut by a surface, so an affine motion gives its exact gradient there
 * too, without any surface correction. */
#ifndef HS_CORRESPONDENCE_H
#define HS_CORRESPONDENCE_H

#include "body.h"
#include "j2.h"
#include "material.h"
#include "stabilisation.h"

struct correspondence;

/* stabilisation and its parameters (self) are owned by the result. */
struct correspondence *correspondence_new(const struct body *body,
                                          const struct materials *materials,
                                          const struct stabilisation *stabilisation, void *self);
void correspondence_free(struct correspondence *model);

/* Internal force density body->f at owned nodes from body->u; brings the ghosts of u up to date.
 * energy may be NULL where mode.energy is false.  Collective. */
void correspondence_force(struct correspondence *model, struct body *body, struct force_mode mode,
                          struct force_energy *energy);

/* The node law's stress of a strip of nodes as they stand (nothing committed): P and H in j2. */
void correspondence_stress(struct correspondence *model, const struct body *body,
                           const struct strip *strip, struct j2_strip *j2);

/* The strips that the functions below take: all owned nodes, and ghosts where the stabilisation needs
 * them (see the flags of the grid). */
const struct strips *correspondence_strips(const struct correspondence *model);

/* Equivalent plastic strain of the points of a strip: [strip->count]. */
const double *correspondence_plastic_strain(const struct correspondence *model,
                                            const struct strip *strip);

#endif
