/* programme.h - a test as a person would write it, solver.programme: to a strain, unloaded to a
 * stress, reloaded, loops, cycles between strains.  It becomes a list of legs, at the ends of
 * which the grips turn. */
#ifndef HS_PROGRAMME_H
#define HS_PROGRAMME_H

#include "deck.h"
#include "keys.h"

enum leg_kind {
    LEG_TO_STRAIN,
    LEG_TO_STRESS,
    LEG_RELOAD, /* to the strain from which the last leg to a stress began */
};

struct leg {
    enum leg_kind kind;
    double target;          /* engineering strain of the gauge, or engineering stress [Pa] */
    struct deck_node where; /* its entry */
};

struct programme {
    int count; /* 0: there is none */
    struct leg *legs;
};

/* Dies where an entry is none of the five, or reloads what was not unloaded. */
struct programme programme_read(struct deck_node list);
void programme_free(struct programme *programme);

/* Strain of the farthest leg, and the way along all of them; a leg to a stress counts as 1 %
 * back. */
double programme_farthest(const struct programme *programme);
double programme_way(const struct programme *programme);

extern const struct section section_programme;

#endif
