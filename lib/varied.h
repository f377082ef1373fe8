/* varied.h - how a study of many decks is written: the section vary, which hsgen --study expands,
 * and the section varied that each deck then has. */
#ifndef HS_VARIED_H
#define HS_VARIED_H

#include "deck.h"
#include "keys.h"

enum varied_role {
    VARIED_QUESTION,    /* what the study asks about */
    VARIED_SCATTER,     /* means and deviations are taken over it: seeds */
    VARIED_RESOLUTION,  /* what its values go to is asked: the spacing */
    VARIED_SENSITIVITY, /* what depends on it is asked, of one key at a time */
};

/* The words of vary that are no keys of the deck; the nodes have the index 0 where they are not
 * there. */
struct vary_words {
    struct deck_node scatter, resolution;
    int combine; /* enum vary_combine */
};
enum vary_combine { VARY_CROSSED, VARY_ZIPPED };
extern const struct section vary_section;
struct vary_words vary_words_read(struct deck_node vary);
bool vary_is_word(const char *key);

/* Where nothing is changed of what a sensitivity is asked to. */
extern const char varied_unchanged[];

/* One thing that varied, and its value in this deck. */
struct varied_item {
    char *name, *value;
    enum varied_role role;
};

struct varied {
    int count;
    struct varied_item *items;
};

extern const struct section varied_section;

/* Index 0: nothing varied.  The caller frees it; it outlives the deck. */
struct varied varied_read(struct deck_node section);
void varied_free(struct varied *varied);

/* The section in one line that varied_read takes, without the end of the line; the caller frees it.
 */
char *varied_print(const struct varied *varied);

/* A text in double quotes of YAML; the caller frees it. */
char *varied_quote(const char *text);

#endif
