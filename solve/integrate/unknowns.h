/* unknowns.h - the displacement components that an equilibrium leaves free, as vectors.
 *
 * A vector holds three numbers for each node that the rank owns, component by component in the
 * order of body->owned; held components are zero.  Behind them rank 0 has, of a periodic body,
 * those of the mean displacement gradient whose stress is given (macroscopic.3).  Products have the
 * same bits on any number of ranks. */
#ifndef HS_UNKNOWNS_H
#define HS_UNKNOWNS_H

#include "boundary.h"

struct checkpoint;

struct unknowns {
    struct body *body;
    const struct macroscopic *macroscopic; /* NULL: the body is not periodic */
    int64_t n_nodes, length; /* of this rank; length = 3 n_nodes and those of the mean gradient */
    int n_mean, mean[COMPONENTS]; /* of all ranks: which of its components are unknown */
    uint8_t *free;                /* [length] 1, or 0 where the component is held */
};

struct unknowns unknowns_new(struct body *body, const struct boundary *boundary);
void unknowns_free(struct unknowns *unknowns);

double *vector_new(const struct unknowns *unknowns);

/* vector = scale * the fields at owned nodes; held components become 0. */
void vector_take(const struct unknowns *unknowns, double *const fields[3], double scale,
                 double *vector);
/* The free components of the fields become those of the vector. */
void vector_put(const struct unknowns *unknowns, const double *vector, double *const fields[3]);

/* The mean gradient's part of vectors, on rank 0: that of body->mean_gradient, or of a rate; and
 * back on all ranks. The second is collective. */
void vector_take_mean(const struct unknowns *unknowns, const double mean_gradient[COMPONENTS],
                      double *vector);
void vector_put_mean(const struct unknowns *unknowns, const double *vector,
                     double mean_gradient[COMPONENTS]);

/* The vector by its nodes, whatever rank has them.  Collective. */
void vector_visit(const struct unknowns *unknowns, struct checkpoint *checkpoint, const char *name,
                  double *vector);

/* y += a x */
void vector_add(const struct unknowns *unknowns, double a, const double *x, double *y);
/* y *= a */
void vector_scale(const struct unknowns *unknowns, double a, double *y);
/* rate = (x - before)/dt */
void vector_rate(const struct unknowns *unknowns, const double *x, const double *before, double dt,
                 double *rate);
/* Largest magnitude; not a number where one is not.  Collective. */
double vector_largest(const struct unknowns *unknowns, const double *x);
/* Euclidean norm.  Collective. */
double vector_norm(const struct unknowns *unknowns, const double *x);
/* x . y.  Collective. */
double vector_product(const struct unknowns *unknowns, const double *x, const double *y);
/* What the Euclidean norm is not beyond where no number is larger than this: enough for the bounds
 * of products. */
double vector_bound(const struct unknowns *unknowns, double largest);

#endif
