/* choices.h - what a user may choose about the evaluation of a curve.
 *
 * Each choice is a key of the deck's section "post:" and, with dashes, an option of hspost; the
 * option wins.  To add one: a member here, a row of the table in choices.c, its key in
 * deck_post_keys (lib/deck.c). */
#ifndef HS_CHOICES_H
#define HS_CHOICES_H

#include "options.h"

struct deck;

enum { CHOICE_COUNT = 13 };

struct choices {
    char *title;         /* name of the curve; NULL: the file's */
    double gauge_length; /* m; NAN: as the history says */
    double section;      /* m^2; NAN: as the history says */
    double modulus_range
        [2]; /* the slope's fit, shares of Rp0.2; NAN: as the file says, else 0.1, 0.4 */
    double modulus_rows[2];    /* the slope's fit, rows counted from 1; NAN: by range */
    double toe;                /* strain at zero stress; NAN: from the slope's fit */
    double modulus;            /* Pa, E of the plastic strain; NAN: the measured slope */
    double true_modulus;       /* Pa, replaces the measured slope (machine compliance); NAN: no */
    double hardening_range[2]; /* n and K, engineering plastic strain */
    double fit_range[2];       /* hardening laws, true plastic strain */
    double window;             /* true strain over which a slope is taken */
    double yield_drop;         /* share of ReH by which the stress must fall for a yield point */
    double fracture_share;     /* share of Rm below which the specimen counts as broken */
};

struct choices choices_default(void);

/* Takes over what the section "post:" says; dies with file:line:column at what is wrong there. */
void choices_read_deck(struct choices *choices, const struct deck *deck);

/* Fills rows[CHOICE_COUNT] so that options_read leaves the texts in texts[CHOICE_COUNT]. */
void choices_options(struct option_row rows[], const char *texts[]);

/* Takes over the texts that are not NULL; dies (exit 2) naming the option. */
void choices_read_options(struct choices *choices, const char *const texts[]);

void choices_free(struct choices *choices);

#endif
