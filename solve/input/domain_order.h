/* domain_order.h - the order of particles, the same whatever order a file has them in. */
#ifndef HS_DOMAIN_ORDER_H
#define HS_DOMAIN_ORDER_H

#include "domain.h"
#include "lattice.h"

#include <stdbool.h>

/* Puts the nodes in order and the sets along with them: those of a lattice (lattice_recognise) by
 * z, y, x; others along a curve of Morton through their box, so that neighbours in space are near
 * in number, and by z, y, x within its last cell.  Returns whether they are a lattice, which is
 * then lattice.
 *
 * A lattice from elsewhere gets the attributes spacing_m and, in two dimensions, dimensions and
 * thickness_m; others mean_spacing_m.  Dies (exit 2), naming both, where two nodes coincide: closer
 * than 1e-4 domain_spacing; and where a domain of two dimensions is not in one plane. */
bool domain_sort(struct domain *domain, struct lattice *lattice);

#endif
