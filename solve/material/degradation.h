/* degradation.h - points whose stress is degraded, and what they have dissipated.
 *
 *   P = c P~,  stored energy c psi~                                                 (degradation.1)
 *   dissipated: the integral of c dw~ - psi~ dc                                     (degradation.2)
 *
 * c = 1 - D is the integrity of the node or bond (integrity.h), a tilde stands for the sound
 * material, which flows and dissipates w~ as if nothing had happened: the effective stress of
 * Kachanov (1958), by Lemaitre, J. Eng. Mater. Technol. 107 (1985) 83.  psi~ is the energy that a
 * growth of D releases.  From one commit to the next the means of c and of psi~ stand for them: so
 * does the work that a step does, to second order. */
#ifndef HS_DEGRADATION_H
#define HS_DEGRADATION_H

#include "grid.h"
#include "law.h"

/* A point's record: c and psi~ at the last commit, and what it has dissipated less than the sound
 * material would have [J/m^3]; element k of it k strides behind the first. */
enum { LAST_INTEGRITY, LAST_STORED, WITHHELD, DEGRADATION };

/* Records of sound points, kept as their states are; freed with free(). */
double *degradation_new(const struct strips *strips);

/* Moves the records of count points on, at a commit: integrity, that of each point now;
 * dissipating, what the sound material has dissipated in the step, and stored, its energy now
 * [J/m^3]. */
void degradation_book(int count, const double *integrity, const double *dissipating,
                      const double *stored, double *record, int64_t stride);

/* Points of the integrities integrity[count] after the update of any law, with its energies: P,
 * stored and dissipated become those above; at a commit the records move on. */
void degradation_apply(struct points *points, bool commit, const double *integrity, double *record,
                       int64_t stride);

#endif
