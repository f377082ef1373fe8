/* deck.h - the study deck: a YAML file with checked getters.
 *
 * Every getter either returns a value that is right in type, unit and range or ends the program
 * with "file:line:column: what was found, what is expected" (exit 2).  Mappings are checked
 * against the list of keys that are known, so a misspelt key is an error, never a default. */
#ifndef HS_DECK_H
#define HS_DECK_H

#include <stdbool.h>
#include <stddef.h>

struct deck;

/* A place in the deck; node.index = 0 says "not there". */
struct deck_node {
    const struct deck *deck;
    int index;
};

/* "libyaml 0.2.5" */
const char *deck_library(void);

/* Parses text (at most 1 MB, nesting depth at most 32, one document, no duplicate keys, no
 * alias cycles).  name stands in messages.  Both strings are copied. */
struct deck *deck_parse(const char *text, size_t length, const char *name);

/* Reads and parses a file; "-" is standard input. */
struct deck *deck_read(const char *path);

void deck_free(struct deck *deck);

const char *deck_text(const struct deck *deck); /* as it was read, NUL-terminated */
const char *deck_name(const struct deck *deck);

struct deck_node deck_root(const struct deck *deck);

/* Dies if the mapping has a key that is not in the list (ended by NULL), naming the nearest known
 * key and listing all. */
void deck_keys(struct deck_node map, const char *const known[]);

bool deck_has(struct deck_node map, const char *key);
struct deck_node deck_get(struct deck_node map, const char *key);  /* dies when missing */
struct deck_node deck_find(struct deck_node map, const char *key); /* index 0 when missing */

bool deck_is_map(struct deck_node node);
bool deck_is_list(struct deck_node node);
bool deck_is_scalar(struct deck_node node);

/* Number with a unit, converted to SI.  unit is the SI unit expected ("m", "Pa", "kg/m3", "s",
 * "m/s", "1/s", "1" for a pure number).  A number without unit is taken as SI; a unit of another
 * dimension is an error.  low <= value <= high, both in SI. */
double deck_number(struct deck_node node, const char *unit, double low, double high);

/* A length in metres, also accepting "3 spacings" (spacing in metres). */
double deck_length(struct deck_node node, double spacing, double low, double high);

long deck_integer(struct deck_node node, long low, long high);
bool deck_bool(struct deck_node node);
const char *deck_string(struct deck_node node); /* valid as long as the deck */

/* Index of the scalar in names[0..count-1]; dies listing them. */
int deck_choice(struct deck_node node, const char *const names[], int count);

/* Lists and mappings by position. */
int deck_count(struct deck_node node);
struct deck_node deck_item(struct deck_node list, int i);
const char *deck_key(struct deck_node map, int i);
struct deck_node deck_key_node(struct deck_node map, int i); /* the key itself, for messages */
struct deck_node deck_value(struct deck_node map, int i);

/* Bytes of the deck's text in which a value stands, without an anchor before it and without what
 * follows it; of a value that an alias names, those where it is written. */
struct deck_span {
    size_t begin, end;
};
struct deck_span deck_span(struct deck_node node);

/* Whether the value is written over lines of its own: a block of keys or items, a text behind | or
 * >. */
bool deck_is_block(struct deck_node node);

/* Number of the node's line, from 1; 0 where it is not there. */
int deck_line(struct deck_node node);

/* "file:line:column: message", exit 2. */
_Noreturn void deck_error(struct deck_node where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
