/* translation.h - a deck of another program on its way to ours: what of it has been read, its
 * units, and what is said of the rest. */
#ifndef HS_TRANSLATION_H
#define HS_TRANSLATION_H

#include "deck.h"

#include <stdbool.h>
#include <stdio.h>

struct translation {
    struct deck *deck;
    struct deck_node root;
    bool *taken;               /* by the index of a value */
    const char *unit[3];       /* of length, mass and time, as the user says them */
    double length, mass, time; /* in m, kg, s */
    FILE *out;
};

/* units: "LENGTH,MASS,TIME" such as "cm,g,s", NULL: SI.  Dies where that is none. */
struct translation translation_new(struct deck *deck, struct deck_node root, const char *units,
                                   FILE *out);
void translation_free(struct translation *translation);

/* The value of a key, which counts as read; index 0 where there is none. */
struct deck_node take(struct translation *t, struct deck_node map, const char *key);
/* The same of a text, NULL where there is none. */
const char *take_text(struct translation *t, struct deck_node map, const char *key);
/* The same of a number in the deck's own units, times the factor that makes it SI; false where
 * there is none. */
bool take_number(struct translation *t, struct deck_node map, const char *key, double factor,
                 double *number);

/* "deck:line: 'key': why", a warning. */
void cannot_take(struct translation *t, struct deck_node value, const char *key, const char *why);

/* Says line by line what has not been read.  why: pairs of keys and reasons, ended by NULL; others
 * have no counterpart. */
void say_what_is_left(struct translation *t, const char *const why[]);

/* A value of the deck, a number or an expression in x, y, z, t, times a factor, with the variables
 * in its own units: as our decks write it, quoted.  NULL where it is no expression but a programme
 * of statements. */
char *translate_expression(const struct translation *t, const char *text, double factor);

/* A name between quotes, as YAML has it. */
char *quoted(const char *name);

#endif
