/* topology.h - what kinds of microstructure there are.
 *
 * A kind is one file that fills this table's line: the deck's keys it knows, how it places its
 * cores, and a score for each node.  The nodes of the lowest scores become coarse. */
#ifndef HS_TOPOLOGY_H
#define HS_TOPOLOGY_H

#include "cores.h"
#include "keys.h"

/* Scores are whole numbers of SCORE_UNIT spacings, so that nodes that are equal by symmetry are
 * equal to the last bit on every machine. */
#define SCORE_UNIT 1e-6

struct findings;
struct recipe;

struct topology {
    struct variant deck; /* its name, and the keys that only it has, which fill the recipe */
    bool no_cores;       /* phases are not found by ranking nodes about cores */
    bool cores_apart;    /* different cores are meant not to touch */
    unsigned requires;   /* REQUIRE_... (requirements.h) of a deck that does not say */
    /* Checks what the rows of the keys cannot say; NULL: nothing. */
    void (*check)(struct deck_node domain, struct recipe *recipe);
    /* Finds size and phases of the body, and its spacing where the deck has none, before the rest
     * of it is read; NULL: they are in the deck. */
    void (*measure)(struct deck_node domain, struct recipe *recipe);
    struct cores (*place)(const struct recipe *recipe);
    /* Score of a point (m) and the core it belongs to. */
    int64_t (*score)(const struct recipe *recipe, const struct cores *cores, const double point[3],
                     int32_t *core);
    /* NULL where the structure is what its name says, else what is wrong and what would help;
     * the caller frees it. */
    char *(*fault)(const struct recipe *recipe, const struct findings *findings);
    /* The structure in words; the caller frees it. */
    char *(*describe)(const struct recipe *recipe, const struct findings *findings);
};

/* All of them: topology_NAME, each in a file of its own; the first has one phase, the second as
 * many as it finds, the others two. */
#define TOPOLOGIES(DO) DO(homogeneous), DO(image), DO(harmonic), DO(random)
#define TOPOLOGY(name) topology_##name
extern const struct topology TOPOLOGIES(TOPOLOGY);

/* The section domain: what all topologies share, and each as a variant. */
extern const struct section domain_section;

#endif
