/* value.h - a load, a motion or a field of the deck that may depend on time and place.
 *
 *   10 m/s                       a number with its unit
 *   "1e-6*t"                     an expression in x, y, z (reference position) and t, all in SI
 *   {ramp: 2 us, to: 10 m/s}     from 0 to a number, smoothly: 10 s^3 - 15 s^4 + 6 s^5, s = t/ramp
 *   [[0 s, 0 mm], [1 s, 2 mm]]   a table of time and value, linear between its rows, standing
 *                                beyond them
 *   {table: FILE}                the same, two numbers a line in SI
 *   {initial: 150 N, increment: 150 N, every: 250 steps}
 *                                raised after that many steps, or
 *   every: equilibrium           whenever the body has come to rest */
#ifndef HS_VALUE_H
#define HS_VALUE_H

#include "deck.h"
#include "expression.h"
#include "keys.h"

#include <stdint.h>

enum value_kind { VALUE_CONSTANT, VALUE_EXPRESSION, VALUE_RAMP, VALUE_STEPS, VALUE_TABLE };

/* What else than a number a quantity may be given as. */
enum { VALUE_IN_SPACE = 1, VALUE_IN_TIME = 2, VALUE_STEPPED = 4 };

struct value {
    enum value_kind kind;
    struct deck_node where;
    const char *unit;              /* SI */
    double low, high;              /* range */
    double number;                 /* constant; reached by a ramp; initial of a stepped load */
    double ramp;                   /* s */
    double increment;              /* of a stepped load */
    int64_t every;                 /* steps; 0: at equilibrium */
    int64_t raised;                /* increments so far */
    struct expression *expression; /* else NULL */
    int n_rows;                    /* of a table */
    double *times, *values;        /* [n_rows] s, rising, and SI */
};

/* Reads a value in this SI unit, within low to high; unit must be a literal.  allowed: a sum of
 * the three above; dies where the deck gives a kind, or uses a variable, that is not among them. */
struct value value_read(struct deck_node where, const char *unit, double low, double high,
                        int allowed);
void value_free(struct value *value);

/* The forms of a value that have keys of their own. */
extern const struct section section_ramp, section_steps, section_table;

/* The next time of a table's row after this one [s]; INFINITY: none. */
double value_next_row(const struct value *value, double time);

/* "250 steps": how many; where equilibrium is true the word equilibrium, too, as 0. */
int64_t value_every(struct deck_node where, bool equilibrium);

bool value_depends_on_place(const struct value *value);
bool value_depends_on_time(const struct value *value);

/* Value at a reference position [m] and time [s], a stepped one as raised so far. */
double value_at(const struct value *value, const double x[3], double time);

/* Evaluates an expression at a place [m] at the start, in the middle and at the end of a run, and
 * dies where it is not finite or out of range.  Sound in time for a stepped load: its increments
 * are numbers. */
void value_try(const struct value *value, const double x[3], double end_time);

/* Smooth rise from 0 at 0 to 1 at 1, where its first and second derivatives vanish: 10 s^3 - 15
 * s^4 + 6 s^5. */
double value_rise(double s);

/* Raises a stepped load where it is due after so many steps of the run, or, where it waits for
 * equilibrium, if there is one.  True where it has been raised.  Dies where that leads out of
 * the range. */
bool value_raise(struct value *value, int64_t steps, bool equilibrium);

#endif
