/* degradation.h - points of which a share of the stress is left, and what they have dissipated.
 *
 *   P = c P~,  stored energy c psi~                                                  (degradation.1)
 *   dissipated: the integral of c sigma_y dp - psi~ dc                               (degradation.2)
 *
 * c = 1 - D is the integrity of the node or bond (integrity.h), a tilde stands for the sound material, which flows as
 * if nothing had happened: the effective stress of Kachanov (1958), by Lemaitre, J. Eng. Mater. Technol. 107
 * (1985) 83.  psi~ is the energy that a growth of D releases.  From one commit to the next the means of c and of
 * psi~ stand for them: so does the work that a step does, to second order. */
#ifndef HS_DEGRADATION_H
#define HS_DEGRADATION_H

#include "grid.h"
#include "j2.h"

/* A point's record: c and psi~ at the last commit, and what it has dissipated less than the sound material would
 * have [J/m^3]; element k of it k strides behind the first. */
enum { LAST_INTEGRITY, LAST_STORED, WITHHELD, DEGRADATION };

/* Records of sound points, kept as their states are; freed with free(). */
double *degradation_new(const struct strips *strips);

/* Moves the records of count points on, at a commit: left, their integrities of now; work, their plastic work before;
 * plastic and stored, work and energy of the sound material now [J/m^3]. */
void degradation_book(int count, const double *left, const double *work, const double *plastic,
                      const double *stored, double *record, int64_t stride);

/* j2_update of points of the integrities left[count], with P, stored and plastic (what is dissipated) as above;
 * left NULL: all are sound, and record is not looked at. */
void degradation_update(struct j2_strip *strip, double *state, int64_t stride, const double *table,
                        struct j2_mode mode, const double *left, double *record);

#endif
