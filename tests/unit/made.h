/* made.h - a specimen made as hsgen makes it. */
#ifndef HS_MADE_H
#define HS_MADE_H

#include "dies.h"

#include "assemble.h"
#include "fill.h"
#include "memory.h"
#include "statistics.h"
#include "topology.h"

#include <stdlib.h>

struct made {
    struct deck *deck;
    struct recipe recipe;
    struct sites sites;
    struct cores cores;
    struct structure structure;
    struct findings findings;
    struct domain domain; /* where it is asked for */
};

/* keys: further ones of the section domain, on one line. */
static inline struct deck *domain_deck(const char *specimen, const char *keys)
{
    char *text = memory_print("domain: {specimen: %s, %s}", specimen, keys);
    struct deck *deck = deck_parse(text, strlen(text), "test");
    free(text);
    return deck;
}

/* From its recipe and cores. */
static inline void made_fill(struct made *made)
{
    made->sites = fill_sites(&made->recipe.specimen);
    made->structure = structure_new(&made->recipe, &made->sites, &made->cores);
    made->findings = findings_of(&made->recipe, &made->structure, &made->cores);
}

/* Takes the deck over. */
static inline struct made *made_new(struct deck *deck)
{
    struct made *made = memory_new(1, sizeof *made);
    made->deck = deck;
    made->recipe = recipe_read(deck);
    made->cores = recipe_cores(&made->recipe);
    made_fill(made);
    return made;
}

static inline struct made *made_with_domain(struct deck *deck)
{
    struct made *made = made_new(deck);
    made->domain = assemble_domain(&made->recipe, &made->structure, &made->findings, NULL);
    return made;
}

static inline void made_free(struct made *made)
{
    domain_free(&made->domain);
    structure_free(&made->structure);
    cores_free(&made->cores);
    sites_free(&made->sites);
    deck_free(made->deck);
    free(made);
}

#endif
