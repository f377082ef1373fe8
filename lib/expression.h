/* expression.h - formulas in the deck, such as "1e-6*t" or "x > 0.01 && y < 0" (muParser).
 *
 * Parsed once, evaluated often.  What can be wrong is told at loading, with the place in the deck:
 * syntax, unknown names, a bare "=", two values ("3,6*x"), "0 < x < 1" (which would compare the
 * outcome of the first comparison with 1), too long (1000 bytes) or nested too deep (50).  Numbers
 * have a point in every locale.  The same text, values and machine code give the same bits: nothing
 * is drawn, nothing runs in parallel.  Known beside the variables: pi; sin cos tan asin acos atan
 * sinh cosh tanh exp ln log (natural, both) log10 sqrt cbrt abs sign (-1, 0, 1) step (0 below 0,
 * then 1) floor ceil erf; atan2 pow hypot of two; min max of any number; + - * / ^ (to the right:
 * 2^3^2 = 512, -2^2 = -4), comparisons, && || !, c ? a : b. */
#ifndef HS_EXPRESSION_H
#define HS_EXPRESSION_H

#include "deck.h"

enum { EXPRESSION_VARIABLES = 8 }; /* at most */

struct expression;

/* Parses the scalar at this place, a formula in the given variables (their names are copied).  The
 * deck must outlive the expression.  Dies (exit 2) with what is wrong and what is known. */
struct expression *expression_new(struct deck_node where, const char *const variables[], int count);
void expression_free(struct expression *expression);

/* Whether variable number i stands in the expression. */
bool expression_uses(const struct expression *expression, int i);

/* Value at variables[count], in the order of expression_new; not thread-safe on one expression. */
double expression_value(struct expression *expression, const double *variables);

/* The same, after which a value that is not finite or not within low to high dies with the place,
 * the text and the variables.  unit: of the value, for the message, "1" for none. */
double expression_try(struct expression *expression, const double *variables, const char *unit,
                      double low, double high);

#endif
