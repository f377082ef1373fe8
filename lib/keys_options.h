/* keys_options.h - keys of the deck as options of the command line: --modulus-range A:B of
 * modulus_range. */
#ifndef HS_KEYS_OPTIONS_H
#define HS_KEYS_OPTIONS_H

#include "keys.h"
#include "options.h"

/* Fills rows[keys->count], numbers and texts alone, so that options_read leaves what was given in
 * texts[keys->count]; keys_options_free frees the words of these rows. */
void keys_options(const struct keys *keys, struct option_row rows[], const char *texts[]);
void keys_options_free(const struct keys *keys, struct option_row rows[]);

/* Puts the texts that are not NULL in place; dies (exit 2) naming the option. */
void keys_read_options(const struct keys *keys, const char *const texts[], void *out);

#endif
