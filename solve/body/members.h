/* members.h - those of some nodes of the body that a rank owns. */
#ifndef HS_MEMBERS_H
#define HS_MEMBERS_H

#include "body.h"
#include "domain.h"

struct members {
    int64_t n_all; /* nodes of the whole set */
    int64_t count;
    int64_t *sites;         /* [count] box sites of the owned ones */
    double mean, low, high; /* of the whole set along the axis of the test, m */
};

/* The nodes of a set of the domain, whose particles' corners they are where corners are the nodes,
 * or, of a mesh, of its corners' domain; rank 0's (NULL elsewhere).  Dies, listing the sets there
 * are, where it has none of that name or an empty one.  Collective. */
struct members members_new(const struct body *body, const struct domain *domain, const char *name);
/* Members from ascending node numbers, given on rank 0 (elsewhere NULL and 0); at least one.
 * Collective. */
struct members members_of_nodes(const struct body *body, const int64_t *nodes, int64_t count);
/* Particles by their numbers, at the sites where they are kept, likewise. */
struct members members_of_particles(const struct body *body, const int64_t *particles,
                                    int64_t count);
/* Reference positions of the owned ones, three new lists of members->count [m]; the caller frees
 * them. */
void members_places(const struct members *members, const struct body *body, double *place[3]);
void members_free(struct members *members);

#endif
