/* preconditioner.h - the waves of transform.h, and the nodes that are held in their midst.
 *
 *   S_ij = c_i . M^-1 c_j,   lambda = S^-1 (c_i . M^-1 r),   z = M^-1 (r - sum_i lambda_i c_i)
 *                                                                                          (pins.1)
 *
 * c_i is one at the i-th held component that lies within the box of the free ones: lambda are the
 * forces that keep them where they are, and z is the inverse of M without their rows and columns.
 * A body that is held at a few nodes alone moves as a whole in M, whose least stiffness that is:
 * each such motion would be a direction in which the preconditioned stiffness is a million times
 * another. */
#ifndef HS_PRECONDITIONER_H
#define HS_PRECONDITIONER_H

#include "transform.h"

struct preconditioner;

/* Collective. */
struct preconditioner *preconditioner_new(const struct unknowns *unknowns,
                                          const struct symbol *symbol);
void preconditioner_free(struct preconditioner *preconditioner);

/* As of transform.h. */
bool preconditioner_is_crowded(const struct preconditioner *preconditioner);
double preconditioner_filled(const struct preconditioner *preconditioner);

/* z of (pins.1); held components become 0.  Collective. */
void preconditioner_apply(struct preconditioner *preconditioner, const double *r, float *z);

#endif
