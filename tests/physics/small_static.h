/* small_static.h - equilibrium of a small body under dead loads, linear: by conjugate gradients on
 * the force that the body's own material gives for displacements so small that it is linear in
 * them. */
#ifndef HS_SMALL_STATIC_H
#define HS_SMALL_STATIC_H

#include "small_body.h"

/* Box fields; fill held and load, read u. */
struct small_static {
    struct small_body *small;
    double *held[3]; /* not 0: u of this component stays as it is given */
    double *load[3]; /* N/m^3 */
    double *u[3];    /* m */
};

struct small_static small_static_new(struct small_body *small);
void small_static_free(struct small_static *problem);

/* Until the residual is below tolerance times the load, or that of the given u; fails the test
 * where that takes more than the given number of steps. */
void small_static_solve(struct small_static *problem, double tolerance, int most_steps);

#endif
