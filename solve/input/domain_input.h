/* domain_input.h - the domain and its deck, from the pipe or from files. */
#ifndef HS_DOMAIN_INPUT_H
#define HS_DOMAIN_INPUT_H

#include "arguments.h"
#include "deck.h"
#include "domain.h"
#include "lattice.h"

/* Genesis (by its first bytes) or Peridigm text ("x y z block volume" a line, with --deck; the
 * grips and gauge planes then follow from domain.grips.length and domain.gauge.length of the deck,
 * the names of the phases from its comment "blocks:", else from the order of the deck's materials).
 * Nodes come back in the order of domain_sort.  That the particles are a sheet, its thickness, and
 * the spacing of scattered ones are taken from domain.dimensions, size and spacing of the deck
 * where the file says none.  lattice: theirs, where they lie on one, else left as it is.  Positions
 * and volumes of a file as hsgen writes them stay there (domain_next).  Dies with the place of what
 * is wrong. */
void domain_input_read(const struct arguments *arguments, struct domain *domain, struct deck **deck,
                       struct lattice *lattice);

#endif
