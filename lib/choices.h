/* choices.h - what a user may choose about the evaluation of a curve.
 *
 * The section "post:" of the deck; every tool reads it, so that what is wrong there stops the first
 * of them, not hspost after the run.  Each key is, with dashes, an option of hspost, too, and the
 * option wins.  To add one: a member here, a row of the table in choices.c. */
#ifndef HS_CHOICES_H
#define HS_CHOICES_H

struct deck;

enum standard { STANDARD_ISO, STANDARD_ASTM };

struct choices {
    const char *title;       /* name of the curve, as long as the deck lives; NULL: the file's */
    const char *question;    /* that the study is to answer, as long as the deck lives; NULL */
    const char *license;     /* of what a crate holds, as long as the deck lives; NULL */
    double gauge_length;     /* m; NAN: as the history says */
    double section;          /* m^2; NAN: as the history says */
    double modulus_range[2]; /* the slope's fit, shares of Rp0.2; NAN: the file's, else 0.1, 0.4 */
    double modulus_rows[2];  /* the slope's fit, rows counted from 1; NAN: by range */
    double toe;              /* strain at zero stress; NAN: from the slope's fit */
    double modulus;          /* Pa, E of the plastic strain; NAN: the measured slope */
    double true_modulus;     /* Pa, replaces the measured slope (machine compliance); NAN: no */
    double hardening_range[2]; /* n and K, engineering plastic strain */
    double fit_range[2];       /* hardening laws, true plastic strain */
    double window;             /* true strain over which a slope is taken */
    double yield_drop;         /* share of ReH by which the stress must fall for a yield point */
    enum standard standard;
    double loop_offset; /* strain at which a branch of a loop yields */
    double
        fracture_share; /* share of the highest stress below which the specimen counts as broken */
    double
        resolution_order; /* with which what a study extrapolates falls, where it does not tell */
};

extern const struct section post_section;

#endif
