/* one_point.h - a material point on its own, for the tests of the radial return. */
#ifndef HS_ONE_POINT_H
#define HS_ONE_POINT_H

#include "check.h"

#include "deck.h"
#include "flow_curve.h"
#include "laws.h"

#include <stdlib.h>
#include <string.h>

static inline struct hardening read_law(const char *text)
{
    struct deck *deck = deck_parse(text, strlen(text), "test");
    struct hardening law = hardening_read(deck_root(deck));
    deck_free(deck);
    return law;
}

/* Of law_j2's state: where p is, and how many numbers there are. */
enum { J2_PLASTIC = 6, J2_STATE = 8 };

/* One point of a material. */
struct point {
    struct hardening law;
    double *curves;
    struct points strip; /* point 0 */
    double state[J2_STATE];
};

static inline void point_new(struct point *point, const char *law, double youngs_modulus,
                             double poissons_ratio)
{
    *point = (struct point){.law = read_law(law)};
    const struct hardening *const laws_of[] = {&point->law};
    point->curves = flow_curves_new(1, laws_of, laws_of);
    point->strip.count = 1;
    assert_int_equal(law_components(&law_j2), J2_STATE);
    law_start(&law_j2, point->curves, &point->strip, point->state, 1);
    point->strip.mu[0] = youngs_modulus / (2 * (1 + poissons_ratio));
    point->strip.bulk[0] = youngs_modulus / (3 * (1 - 2 * poissons_ratio));
}

static inline void point_free(struct point *point)
{
    free(point->curves);
    hardening_free(&point->law);
}

static inline void deform(struct point *point, const double H[9], bool commit)
{
    for (int k = 0; k < TENSOR; k++) point->strip.H[k][0] = H[k];
    law_j2.update(point->curves, &point->strip, point->state, 1,
                  (struct step){.commit = commit, .energy = true});
}

static inline void stretch(struct point *point, double lambda)
{
    deform(point, (const double[9]){lambda - 1}, true);
}

#endif
