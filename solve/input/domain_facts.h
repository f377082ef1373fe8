/* domain_facts.h - what the deck says of a body that comes from elsewhere and brings no facts of
 * its own. */
#ifndef HS_DOMAIN_FACTS_H
#define HS_DOMAIN_FACTS_H

#include "deck.h"
#include "domain.h"
#include "keys.h"

#include <stdbool.h>

/* The deck's section domain as hssolve reads it; of hsgen's own, which says how the body is made,
 * the keys that both have. */
struct domain_facts {
    double unit;    /* of the file's lengths, m */
    int axis;       /* of the test */
    double section; /* m^2 between the gauge planes; 0: that of the body */
    struct deck_node length_unit, dimensions, size, spacing, volumes, grips, gauge, node_sets,
        periodic, period, symmetry;
};

extern const struct section section_domain_facts, section_domain_grips, section_domain_gauge;

/* Dies where a key is not known, or a value is not right. */
struct domain_facts domain_facts_read(const struct deck *deck);

/* Positions, volumes and the nodes of a mesh become SI; dies where the file says itself that it is.
 */
void domain_facts_scale(const struct domain_facts *facts, struct domain *domain);

/* Sets of node numbers, from 1 in the file's order, in files of their own or in the deck. */
void domain_facts_node_sets(const struct domain_facts *facts, struct domain *domain);

/* Grips and gauge planes where the deck has them and the file has not: grip_left, grip_right,
 * gauge_left, gauge_right, of a mesh's nodes, too; and the attribute section_m2.  lattice: what
 * domain_sort said.  On a lattice a gauge plane is a layer of nodes, else the nodes within half a
 * spacing of it.  Of a part of a symmetric body grips and gauge are those of the whole, and what is
 * left is in the image. */
void domain_facts_planes(const struct domain_facts *facts, bool lattice, struct domain *domain);

#endif
