/* fraction.h - which nodes become coarse: those of the lowest scores, as many as the fraction by
 * volume asks. */
#ifndef HS_FRACTION_H
#define HS_FRACTION_H

#include <stdbool.h>
#include <stdint.h>

/* Nodes to be ranked. */
struct ranks {
    int64_t n_nodes;
    const int64_t *score;   /* [n_nodes] */
    const int64_t *site;    /* [n_nodes], for the ties of an exact match */
    const uint8_t *counted; /* [n_nodes] 0: not ranked */
    const double
        *weight; /* [n_nodes] volumes; NULL: all own the same, and the fraction is that by number */
};

/* A node is coarse when its score is below the threshold, or equal to it and its hash (of the
 * seed and its site, see fraction_is_coarse) is at most `tie`. */
struct threshold {
    int64_t score;
    uint64_t tie;
    int64_t counted; /* nodes that were ranked */
    int64_t coarse;  /* of them, coarse */
    double share;    /* of their weight, coarse */
    int64_t split;   /* nodes of equal score of which only a part became coarse; 0: none split */
    double below;    /* geometric: nearest attainable coarse fractions on either side */
    double above;
    long seed;
};

/* Rank selection: the coarse weight is the nearest one to coarse_fraction of all that can be had
 * node by node, so that the error is at most half a node's volume. */
struct threshold fraction_exact(const struct ranks *ranks, double coarse_fraction, long seed);

/* Nodes of equal score stay together, as for a sphere of one diameter: bisection on the score until
 * the bracket holds no node; the nearer attainable fraction is taken. */
struct threshold fraction_geometric(const struct ranks *ranks, double coarse_fraction);

bool fraction_is_coarse(const struct threshold *threshold, int64_t score, int64_t site);

#endif
