/* pins.h - held nodes in the midst of free ones, for a preconditioner whose waves do not know of them.
 *
 *   S_ij = c_i . M^-1 c_j,   lambda = S^-1 (c_i . M^-1 r),   z = M^-1 (r - sum_i lambda_i c_i)            (pins.1)
 *
 * c_i is one at the i-th held node: lambda are the forces that keep them where they are, and z is the inverse of M without
 * their rows and columns (G. H. Golub, C. F. Van Loan, Matrix computations, 4th ed. 2013, sec. 2.1.4).  A body that is
 * held at a few nodes alone moves as a whole in M, whose least stiffness that is: each such motion would be a
 * direction in which the preconditioned stiffness is a million times another. */
#ifndef HS_PINS_H
#define HS_PINS_H

#include <stdint.h>

enum { MOST_PINS = 256 };

struct pins {
    int count;
    int64_t *node;  /* [count] numbers that the owner knows */
    double *factor; /* [count count] lower triangle L of S = L L^T, row by row */
    double *force;  /* [count] lambda */
};

/* Of so many candidates at most MOST_PINS, evenly chosen.  S is still to be filled in. */
struct pins pins_new(const int64_t *candidates, int64_t count);
void pins_free(struct pins *pins);

/* S, of which factor holds the lower triangle, becomes L. */
void pins_factorise(struct pins *pins);
/* force, the values c_i . M^-1 r, becomes lambda. */
void pins_solve(struct pins *pins);

#endif
