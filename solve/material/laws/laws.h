/* laws.h - the constitutive laws there are.  To add one: its file, and its line here.
 *
 * The order is that of precedence: a bond between phases of different laws obeys the one that comes first, with the
 * mean moduli and else its own phase's parameters.  So beside an elastic phase it is elastic. */
#ifndef HS_LAWS_H
#define HS_LAWS_H

#include "law.h"

/* clang-format off */
#define LAWS \
    LAW(elastic) \
    LAW(j2)
/* clang-format on */

#define LAW(name) extern const struct law law_##name;
LAWS
#undef LAW

/* All of them, ended by NULL. */
extern const struct law *const laws[];

/* The chooser "law" of a material, and the keys of each. */
extern const struct section section_laws;

#endif
