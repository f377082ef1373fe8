/* yield.h - a yield stress that varies within a phase: a flaw that starts a neck, a scatter from
 * node to node.
 *
 *   sigma_y(p) = law(p) + (k - 1) law(0),  k = (1 - r exp(-|x - c|^2/R^2)) (1 + d g)      (yield.1)
 *
 * The hardening beyond yield stays the law's.  r, c, R: the flaw's reduction, centre and radius; d:
 * the scatter's deviation, g a number of the normal distribution, cut at three, that follows from
 * the seed, the phase's name and the node alone.  In a periodic body x - c is that of the flaw's
 * nearest image. */
#ifndef HS_YIELD_H
#define HS_YIELD_H

#include "hardening.h"
#include "keys.h"

struct body;
struct materials;

/* Parameters of a law that yields. */
struct yield {
    struct deck_node material, node; /* where the deck has it; what it says of hardening */
    struct hardening hardening;
    double centre[3], radius, reduction; /* of the flaw [m]; radius 0: none */
    double deviation;                    /* of the scatter; 0: none */
    int64_t seed;
};

/* For struct law: the keys hardening, flaw and yield_scatter, the rest of their reading, and what
 * it holds. */
enum { YIELD_KEYS = 3 };
extern const struct key yield_keys[YIELD_KEYS];
void yield_read(struct deck_node material, void *yield);
void yield_release(void *yield);
const struct yield *yield_of(const void *yield);

/* Strain at which the first of the phases yields in tension, flaws and scatter aside; INFINITY:
 * none does. */
double yield_first_strain(const struct materials *materials);

/* Flow stress [Pa] of the strongest of the phases at a plastic strain, flaws and scatter aside, and
 * which it is; INFINITY where one of them never yields. */
double yield_strongest(const struct materials *materials, double p, int *phase);

/* For struct law: flow curves by pair, the table of flow_curve.h; of a pair without parameters one
 * that nothing reaches. */
void *yield_pairs(int count, const void *const first[], const void *const second[]);

/* Fills body->yield_shift, (k - 1) law(0) [Pa], at all sites of the box; leaves it NULL where no
 * material varies.  Dies at a flaw that a plane of symmetry would make several of, and warns of a
 * scatter that is one's own image. */
void yield_start(struct body *body, const struct materials *materials);

#endif
