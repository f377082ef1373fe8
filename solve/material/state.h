/* state.h - what the law of a point remembers, known by its name in output and damage. */
#ifndef HS_STATE_H
#define HS_STATE_H

struct state {
    const char *name; /* in the deck's words: equivalent_plastic_strain */
    const char *unit; /* SI; "1": a pure number */
    int components; /* 1; of a symmetric tensor 6: xx yy zz xy yz zx; of another one 9, row by row */
    double initial;   /* of a number; of the diagonal of a tensor, the rest of which is 0 */
    const char *help; /* one line */
};

/* By which nodes degrade and break. */
#define STATE_PLASTIC_STRAIN                                                                       \
    {                                                                                              \
        "equivalent_plastic_strain", "1", 1, 0, "equivalent plastic strain"                        \
    }

#endif
