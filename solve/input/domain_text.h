/* domain_text.h - particles in Peridigm's text format. */
#ifndef HS_DOMAIN_TEXT_H
#define HS_DOMAIN_TEXT_H

#include "deck.h"
#include "domain.h"
#include "spool.h"

#include <stdbool.h>

/* "x y z block volume" a line, '#' starts a comment; SI units.  A comment "blocks: 1 NAME 2 NAME ..." as
 * hsgen writes it names the phases; without it block 1 is the first material of the deck, and so on.
 * Nodes are in the order of the lines, without sets.  shown: name in messages. */
struct domain domain_text_read(const struct spool *input, const char *shown,
                               const struct deck *deck);

/* The sets that a text does not hold, from domain.grips.length and domain.gauge.length of the deck where
 * they are said: grip_left, grip_right, gauge_left, gauge_right; and the attribute section_m2.  lattice:
 * what domain_sort said.  On a lattice a gauge plane is a layer of nodes, else the nodes within half a
 * spacing of it. */
void domain_text_sets(struct domain *domain, bool lattice, const struct deck *deck);

#endif
