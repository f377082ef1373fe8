/* domain_text.h - particles in Peridigm's text format. */
#ifndef HS_DOMAIN_TEXT_H
#define HS_DOMAIN_TEXT_H

#include "deck.h"
#include "domain.h"
#include "spool.h"

/* "x y z block volume" a line, '#' starts a comment; SI units.  A comment "blocks: 1 NAME 2 NAME ..." as
 * hsgen writes it names the phases; without it block 1 is the first material of the deck, and so on.
 * shown: name in messages. */
struct domain domain_text_read(const struct spool *input, const char *shown,
                               const struct deck *deck);

/* Puts the nodes into lattice order (z, y, x ascending) and the sets along with them. */
void domain_sort(struct domain *domain);

#endif
