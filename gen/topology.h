/* topology.h - what kinds of microstructure there are.
 *
 * A kind is one file that fills this table's line: the deck's keys it knows, how it places its
 * cores, and a score for each node.  The nodes of the lowest scores become coarse. */
#ifndef HS_TOPOLOGY_H
#define HS_TOPOLOGY_H

#include "cores.h"
#include "deck.h"

/* Scores are whole numbers of SCORE_UNIT spacings, so that nodes that are equal by symmetry are
 * equal to the last bit on every machine. */
#define SCORE_UNIT 1e-6

struct findings;
struct recipe;

struct topology {
    const char *name;
    bool single_phase;
    bool cores_apart;        /* different cores are meant not to touch */
    const char *const *keys; /* of the deck, ended by NULL */
    void (*read)(struct deck_node domain, struct recipe *recipe);
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

extern const struct topology topology_harmonic;
extern const struct topology topology_random;
extern const struct topology topology_homogeneous;

extern const struct topology *const topologies[]; /* ended by NULL */

#endif
