/* sections.h - the deck's top level.
 *
 * Each tool reads the sections that it owns and passes over the others, but none passes over a
 * section that no tool knows, nor over a mistake in post. */
#ifndef HS_SECTIONS_H
#define HS_SECTIONS_H

#include "choices.h"
#include "deck.h"

/* A section that the deck does not have has the index 0. */
struct sections {
    const char *title; /* NULL: none */
    struct deck_node domain, materials, damage, cracks, boundary, initial, macroscopic, solver,
        output, post;
    struct deck_node vary, refine, sensitivity, varied;
    struct choices choices; /* what post says, its title where it has none; else the defaults */
};

extern const struct section deck_section;

/* Dies at an unknown section, and at a wrong key or value of post. */
struct sections sections_read(const struct deck *deck);

/* What the deck says of post; deck = NULL: the defaults. */
struct choices choices_read(const struct deck *deck);

#endif
