#include "domain_input.h"

#include "die.h"
#include "domain_order.h"
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

/* A key of the deck's domain section; index 0 where there is none. */
static struct deck_node said_of_domain(const struct deck *deck, const char *key)
{
    struct deck_node section = deck_find(deck_root(deck), "domain");
    return section.index == 0 ? section : deck_find(section, key);
}

/* What a file from elsewhere does not say and the deck's domain section does: that the particles are a
 * sheet, and its thickness. */
static void take_dimensions(struct domain *domain, const struct deck *deck)
{
    struct attributes *facts = &domain->attributes;
    struct deck_node dimensions = said_of_domain(deck, "dimensions");
    if (attributes_number(facts, "spacing_m", 0) > 0 || dimensions.index == 0) return;
    const long said = deck_integer(dimensions, 2, 3);
    attributes_set_number(facts, "dimensions", (double)said);
    if (said == 3) return;
    struct deck_node size = said_of_domain(deck, "size");
    struct deck_node spacing = said_of_domain(deck, "spacing");
    if (size.index == 0 || !deck_is_list(size) || deck_count(size) != 3)
        deck_error(size.index == 0 ? dimensions : size,
                   "size is a list of three lengths; the third is the sheet's thickness");
    const double length = spacing.index ? deck_number(spacing, "m", 1e-12, 1e3) : 0;
    attributes_set_number(facts, "thickness_m",
                          deck_length(deck_item(size, 2), length, 1e-12, 1e3));
}

/* Of scattered particles the deck may say what a spacing is to mean. */
static void take_spacing(struct domain *domain, const struct deck *deck)
{
    struct deck_node spacing = said_of_domain(deck, "spacing");
    if (spacing.index != 0)
        attributes_set_number(&domain->attributes, "mean_spacing_m",
                              deck_number(spacing, "m", 1e-12, 1e3));
}

static struct deck *deck_inside(const struct domain *domain, const char *shown)
{
    const char *text = attributes_text(&domain->attributes, "deck");
    const char *name = attributes_text(&domain->attributes, "deck_name");
    if (!text) die_user("%s has no deck inside: give it with --deck", shown);
    return deck_parse(text, strlen(text), name ? name : "deck");
}

void domain_input_read(const struct arguments *a, struct domain *domain, struct deck **deck)
{
    struct spool input = spool_input(a->input);
    bool piped = !a->input || strncmp(a->input, "/proc/", strlen("/proc/")) == 0;
    const char *shown = piped ? "standard input" : a->input;
    const bool text = !is_netcdf(input.path) && is_text(input.path);
    *deck = a->deck ? deck_read(a->deck) : NULL;
    if (text && !*deck)
        die_user("%s is text: a deck goes through hsgen first; particles in Peridigm's text format "
                 "need the deck beside them (--deck)",
                 shown);
    *domain = text ? domain_text_read(&input, shown, *deck) : exodus_read_domain(&input);
    spool_close(&input);
    if (!*deck) *deck = deck_inside(domain, shown);
    take_dimensions(domain, *deck);
    const bool lattice = domain_sort(domain);
    if (!lattice) take_spacing(domain, *deck);
    if (text) domain_text_sets(domain, lattice, *deck);
}
