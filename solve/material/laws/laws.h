/* laws.h - the constitutive laws there are, and the states they keep. */
#ifndef HS_LAWS_H
#define HS_LAWS_H

#include "law.h"

/* All of them: law_NAME, each in a file of its own.  The order is that of precedence: a bond
 * between phases of different laws obeys the one that comes first, with the mean moduli and else
 * its own phase's parameters.  So beside an elastic phase it is elastic. */
#define LAWS(DO)               DO(elastic), DO(j2), DO(mitchell)
#define CONSTITUTIVE_LAW(name) law_##name
#define LAW_NUMBER(name)       LAW_##name
extern const struct law LAWS(CONSTITUTIVE_LAW);
enum { LAWS(LAW_NUMBER), LAW_COUNT };

extern const struct law *const all_laws[LAW_COUNT];

/* Of law i: its words, for struct section; NULL beyond the last one. */
const struct variant *law_variant(int i);

/* The states of all laws, each name once: number i; NULL beyond the last one. */
const struct state *law_state(int i);
/* The number of the state of that name; -1: there is none. */
int law_state_number(const char *name);

#endif
