/* peridigm_deck.h - a deck of Peridigm (YAML or XML) becomes one of ours. */
#ifndef HS_PERIDIGM_DECK_H
#define HS_PERIDIGM_DECK_H

#include "translation.h"

/* Reads the deck (NULL, "-": standard input) and writes ours to a name (NULL, "-": standard
 * output).  units: see translation_new.  What has no counterpart is said line by line; dies (exit
 * 2) where the body, a material, or where the run ends cannot be told. */
void peridigm_deck_translate(const char *deck, const char *units, const char *output);

/* Parts of it, each a section of our deck. */
struct peridigm_block {
    const char *phase, *material, *damage; /* names; damage NULL: none */
    char *words;                           /* that phase is a part of */
    double horizon;                        /* m; 0: not said */
    struct deck_node where;
};
struct peridigm_blocks {
    int count;
    struct peridigm_block *items;
};
struct peridigm_blocks peridigm_blocks_read(struct translation *t);
/* The sections materials and damage; whether the ordinary formulation is among them, whose
 * influence Peridigm has constant. */
bool peridigm_materials(struct translation *t, const struct peridigm_blocks *blocks);
void peridigm_boundary(struct translation *t);
/* The axis along which alone nodes are moved, 0, 1 or 2; 0 where there are more. */
int peridigm_axis(struct translation *t);
/* The node sets that the boundary conditions name, for section domain. */
void peridigm_node_sets(struct translation *t);
void peridigm_output(struct translation *t);

#endif
