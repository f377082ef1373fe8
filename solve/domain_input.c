#include "domain_input.h"

#include "die.h"
#include "domain_text.h"
#include "exodus.h"
#include "memory.h"
#include "spool.h"

#include <stdio.h>
#include <string.h>

static int is_netcdf(const char *path)
{
    unsigned char bytes[4] = {0};
    FILE *file = fopen(path, "rb");
    if (!file) die_user("cannot open the domain");
    size_t got = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    if (got < sizeof bytes) return 0;
    return memcmp(bytes, "CDF", 3) == 0 || memcmp(bytes, "\211HDF", 4) == 0;
}

/* Text has no bytes below space but tab and line ends. */
static int is_text(const char *path)
{
    unsigned char bytes[512];
    FILE *file = fopen(path, "rb");
    if (!file) return 0;
    size_t got = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    for (size_t i = 0; i < got; i++)
        if (bytes[i] < ' ' && bytes[i] != '\n' && bytes[i] != '\r' && bytes[i] != '\t') return 0;
    return got > 0;
}

void domain_input_read(const struct arguments *a, struct domain *domain, struct deck **deck)
{
    struct spool input = spool_input(a->input);
    bool piped = !a->input || strncmp(a->input, "/proc/", strlen("/proc/")) == 0;
    const char *shown = piped ? "standard input" : a->input;
    *deck = a->deck ? deck_read(a->deck) : NULL;
    if (!is_netcdf(input.path) && is_text(input.path)) {
        if (!*deck)
            die_user(
                "%s is text: a deck goes through hsgen first; particles in Peridigm's text format "
                "need the deck beside them (--deck)",
                shown);
        *domain = domain_text_read(&input, shown, *deck);
    } else {
        *domain = exodus_read_domain(&input);
        domain_sort(domain);
    }
    spool_close(&input);
    if (*deck) return;
    const char *text = attributes_text(&domain->attributes, "deck");
    const char *name = attributes_text(&domain->attributes, "deck_name");
    if (!text) die_user("%s has no deck inside: give it with --deck", shown);
    *deck = deck_parse(text, strlen(text), name ? name : "deck");
}
