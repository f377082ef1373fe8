/* bond_search.h - finds the bonds of a body: along the half offsets of a lattice, or neighbour by
 * neighbour. */
#ifndef HS_BOND_SEARCH_H
#define HS_BOND_SEARCH_H

#include "bonds.h"

/* The bonds of a body, also known as body->bonds; freed by bonds_free.  Of scattered particles
 * makes the shape tensors, too, which are sums over the list.  Collective. */
struct bonds *bonds_new(struct body *body);

#endif
