/* bond_search.h - finds the bonds of a body: along the half offsets of a lattice, or neighbour by neighbour. */
#ifndef HS_BOND_SEARCH_H
#define HS_BOND_SEARCH_H

#include "bonds.h"

/* Of a body, which keeps them as body->bonds; frees nothing of it.  Of scattered particles also the shape tensors,
 * which are sums over the list.  Collective. */
struct bonds *bonds_new(struct body *body);

#endif
