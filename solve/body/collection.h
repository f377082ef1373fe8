/* collection.h - one number a node, from all ranks to one of them and back. */
#ifndef HS_COLLECTION_H
#define HS_COLLECTION_H

#include "body.h"

struct collection;

/* Collective. */
struct collection *collection_new(const struct body *body);
void collection_free(struct collection *collection);

/* Sites of the lattice (lattice_site) of all nodes in the order of all below: [n_nodes]. */
const int64_t *collection_sites(const struct collection *collection);

/* own: of the nodes of this rank in the order of body->owned; all: of all nodes, on the rank root alone.
 * Collective. */
void collection_gather(const struct collection *collection, int root, const double *own,
                       double *all);
void collection_scatter(const struct collection *collection, int root, const double *all,
                        double *own);

#endif
