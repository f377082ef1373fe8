/* yield.h - a yield stress that varies within a phase: a flaw that starts a neck, a scatter from node to node.
 *
 *   sigma_y(p) = law(p) + (k - 1) law(0),  k = (1 - r exp(-|x - c|^2/R^2)) (1 + d g)          (yield.1)
 *
 * The hardening beyond yield stays the law's.  r, c, R: the flaw's reduction, centre and radius; d: the scatter's
 * deviation, g a number of the normal distribution, cut at three, that follows from the seed, the phase's name
 * and the node alone. */
#ifndef HS_YIELD_H
#define HS_YIELD_H

#include "deck.h"

#include <stdbool.h>

struct body;

/* What a material's deck says of it. */
struct yield_variation {
    bool flawed, scattered;
    double centre[3], radius, reduction;
    double deviation;
    long seed;
};

/* The keys "flaw" and "yield_scatter" of a material. */
struct yield_variation yield_read(struct deck_node material);

/* Fills body->yield_shift, (k - 1) law(0) [Pa], at the sites of a phase of that name; stress: law(0).  Leaves it NULL where
 * no phase varies. */
void yield_vary(struct body *body, int phase, const struct yield_variation *yield, const char *name,
                double stress);

#endif
