/* fraction.h - which nodes become coarse: those of the lowest scores, as many as the fraction asks.
 *
 * All nodes own the same volume, so that the fraction by number is the fraction by volume. */
#ifndef HS_FRACTION_H
#define HS_FRACTION_H

#include <stdbool.h>
#include <stdint.h>

/* A node is coarse when its score is below the threshold, or equal to it and its hash (of the
 * seed and its site, see fraction_is_coarse) is at most `tie`. */
struct threshold {
    int64_t score;
    uint64_t tie;
    int64_t counted; /* nodes that were ranked */
    int64_t coarse;  /* of them, coarse */
    int64_t split;   /* nodes of equal score of which only a part became coarse; 0: none split */
    double below;    /* geometric: nearest attainable coarse fractions on either side */
    double above;
    long seed;
};

/* Rank selection: coarse = the whole number nearest to coarse_fraction times the counted nodes, so
 * that the error is at most half a node's volume.  score, site: [n_nodes]; counted: [n_nodes]. */
struct threshold fraction_exact(int64_t n_nodes, const int64_t *score, const int64_t *site,
                                const uint8_t *counted, double coarse_fraction, long seed);

/* Nodes of equal score stay together, as for a sphere of one diameter: bisection on the score until
 * the bracket holds no node; the nearer attainable fraction is taken. */
struct threshold fraction_geometric(int64_t n_nodes, const int64_t *score, const uint8_t *counted,
                                    double coarse_fraction);

bool fraction_is_coarse(const struct threshold *threshold, int64_t score, int64_t site);

#endif
