/* examples.h - decks that show how, in the program. */
#ifndef HS_EXAMPLES_H
#define HS_EXAMPLES_H

/* Prints name and first line of each deck of gen/examples. */
void examples_list(void);

/* Prints a deck; dies (exit 2) at an unknown name. */
void example_print(const char *name);

/* "plate|harmonic|...". */
extern const char *const examples_names;

#endif
