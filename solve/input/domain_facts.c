#include "domain_facts.h"

#include "die.h"
#include "memory.h"
#include "units.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const axes[] = {"x", "y", "z", NULL};

#define AT(member) offsetof(struct domain_facts, member)

static const struct key planes_keys[] = {
    {"length", KEY_NODE, .form = "LENGTH", .help = "of either grip, from the ends of the body"},
    {"planes", KEY_NODE, .form = "[LENGTH, LENGTH]",
     .help = "in place of length: what lies below the first or above the second is a grip"},
};
const struct section section_domain_grips = {
    .path = "domain.grips (from elsewhere)",
    .help = "Sets grip_left and grip_right of a body that has none.",
    .keys = KEYS(planes_keys)};

static const struct key gauge_keys[] = {
    {"length", KEY_NODE, .form = "LENGTH", .help = "between the planes, centred"},
    {"planes", KEY_NODE, .form = "[LENGTH, LENGTH]", .help = "in place of length: where they are"},
};
const struct section section_domain_gauge = {
    .path = "domain.gauge (from elsewhere)",
    .help = "Sets gauge_left and gauge_right of a body that has none.",
    .keys = KEYS(gauge_keys)};

static const struct key rows[] = {
    {"length_unit", KEY_NODE, AT(length_unit), .form = "UNIT", .otherwise = "m",
     .help = "of the file's positions, and its cube of the file's volumes: mm, um, cm, in"},
    {"axis", KEY_CHOICE, AT(axis), .names = axes,
     .help = "of the test: of grips, gauge, end_strain and the columns of the history"},
    {"dimensions", KEY_NODE, AT(dimensions), .form = "2 or 3",
     .help = "2: the particles are a sheet in one plane of z"},
    {"size", KEY_NODE, AT(size), .form = "[x, y, z], m or spacings",
     .help = "of a sheet, whose thickness is the third"},
    {"spacing", KEY_NODE, AT(spacing), .form = "LENGTH, or [x, y, z]",
     .help =
         "what a spacing means in the deck; of a text with cells that are no cubes their edges"},
    {"volumes", KEY_NODE, AT(volumes), .form = "whole or cut",
     .help = "cut: volumes of a lattice in text may be smaller than its cells"},
    {"periodic", KEY_NODE, AT(periodic), .form = "[AXIS, ...]", .otherwise = "none",
     .help = "axes along which the body repeats itself: a lattice after its cells, other particles "
             "after period"},
    {"period", KEY_NODE, AT(period), .form = "[x, y, z], LENGTH",
     .otherwise = "of a lattice that of its cells, of a mesh that of its nodes; else required",
     .help = "after which it does; along other axes of no meaning"},
    {"symmetry", KEY_NODE, AT(symmetry), .form = "[AXIS, ...]", .otherwise = "none",
     .help =
         "axes across which a lattice is the upper half of a body, whose grips and gauge are said"},
    {"grips", KEY_NODE, AT(grips), .section = &section_domain_grips, .otherwise = "none",
     .help = "where the file has no sets of these names"},
    {"gauge", KEY_NODE, AT(gauge), .section = &section_domain_gauge, .otherwise = "none",
     .help = "likewise"},
    {"section", KEY_NUMBER, AT(section), "m2", 1e-24, 1e6, .usual = 0,
     .otherwise = "of the body between the gauge planes", .help = "that stress is the force over"},
    {"node_sets", KEY_NODE, AT(node_sets), .form = "{NAME: FILE or [NUMBER, ...]}",
     .otherwise = "none",
     .help = "of particles by their numbers in the file, from 1, as Peridigm's files hold them"},
};
const struct section section_domain_facts = {
    .path = "domain (from elsewhere)",
    .help = "Of a body that hsgen has not made: what its file does not say.",
    .keys = KEYS(rows)};

/* A unit of length in m. */
static double read_unit(struct deck_node node)
{
    double unit;
    char *text = memory_print("1 %s", deck_string(node));
    const char *fault = units_read(text, "m", &unit);
    if (fault || !(unit > 0))
        deck_error(node, "'%.40s' is no unit of length, expected such as mm, um, cm, in",
                   deck_string(node));
    free(text);
    return unit;
}

struct domain_facts domain_facts_read(const struct deck *deck)
{
    struct domain_facts facts = {.unit = 1};
    const struct deck_node section = deck_find(deck_root(deck), "domain");
    if (section.index == 0) return facts;
    if (deck_has(section, "specimen") || deck_has(section, "topology")) {
        facts.dimensions = deck_find(section, "dimensions");
        facts.size = deck_find(section, "size");
        facts.spacing = deck_find(section, "spacing");
        facts.volumes = deck_find(section, "volumes");
        facts.grips = deck_find(section, "grips");
        facts.gauge = deck_find(section, "gauge");
        facts.periodic = deck_find(section, "periodic");
        facts.symmetry = deck_find(section, "symmetry");
        return facts;
    }
    keys_read(section, &section_domain_facts, 0, 0, &facts, NULL);
    if (facts.grips.index) keys_check(facts.grips, &section_domain_grips, 0);
    if (facts.gauge.index) keys_check(facts.gauge, &section_domain_gauge, 0);
    facts.unit = facts.length_unit.index ? read_unit(facts.length_unit) : 1;
    return facts;
}

static void scale(double *values, int64_t count, double factor)
{
    for (int64_t i = 0; i < count; i++) values[i] *= factor;
}

void domain_facts_scale(const struct domain_facts *facts, struct domain *domain)
{
    const double unit = facts->unit;
    if (facts->length_unit.index == 0) return;
    if (attributes_number(&domain->attributes, "spacing_m", 0) > 0)
        deck_error(facts->length_unit, "the file says itself that its lengths are in m");
    struct domain *const both[2] = {domain, domain->corners};
    for (int k = 0; k < 2 && both[k]; k++) {
        scale(both[k]->x, both[k]->n_nodes, unit);
        scale(both[k]->y, both[k]->n_nodes, unit);
        scale(both[k]->z, both[k]->n_nodes, unit);
    }
    scale(domain->volume, domain->n_nodes, unit * unit * unit);
}

/* --- node sets by numbers --- */

static void choose(struct domain *domain, uint8_t *chosen, const char *name, long number)
{
    if (number < 1 || number > domain->n_nodes)
        die_user("node set '%s': node %ld, expected 1 to %lld", name, number,
                 (long long)domain->n_nodes);
    chosen[number - 1] = 1;
}

/* Numbers in a file, '#' before a comment; a first line of words is a header. */
static void read_numbers(struct deck_node where, struct domain *domain, const char *name,
                         uint8_t *chosen)
{
    enum { LONGEST_LINE = 1 << 16 };
    const char *path = deck_string(where);
    FILE *file = fopen(path, "r");
    if (!file) deck_error(where, "cannot open %s: %s", path, strerror(errno));
    char *line = memory_new(LONGEST_LINE, 1);
    for (long at = 1; fgets(line, LONGEST_LINE, file); at++) {
        if (!strchr(line, '\n') && !feof(file)) die_user("%s:%ld: line too long", path, at);
        line[strcspn(line, "#\n")] = '\0';
        char *next = line + strspn(line, " \t\r,");
        if (at == 1 && isalpha((unsigned char)*next)) continue;
        while (*next) {
            char *end;
            errno = 0;
            const long number = strtol(next, &end, 10);
            if (end == next || errno != 0 || !strchr(" \t\r,", *end))
                die_user("%s:%ld: expected numbers of nodes, found '%.40s'", path, at, next);
            choose(domain, chosen, name, number);
            next = end + strspn(end, " \t\r,");
        }
    }
    free(line);
    fclose(file);
}

void domain_facts_node_sets(const struct domain_facts *facts, struct domain *domain)
{
    const struct deck_node sets = facts->node_sets;
    for (int k = 0; sets.index && k < deck_count(sets); k++) {
        const char *name = deck_key(sets, k);
        const struct deck_node given = deck_value(sets, k);
        if (domain_set(domain, name))
            deck_error(deck_key_node(sets, k), "the file has a node set '%s' of its own", name);
        if (domain->corners)
            deck_error(deck_key_node(sets, k),
                       "node sets of numbers are of particles: in a mesh of hexahedra let the file "
                       "have them");
        uint8_t *chosen = memory_new((size_t)domain->n_nodes, 1);
        int64_t *list = memory_new((size_t)domain->n_nodes, sizeof *list), count = 0;
        for (int i = 0; deck_is_list(given) && i < deck_count(given); i++)
            choose(domain, chosen, name, deck_integer(deck_item(given, i), 1, INT32_MAX));
        if (!deck_is_list(given)) read_numbers(given, domain, name, chosen);
        for (int64_t i = 0; i < domain->n_nodes; i++)
            if (chosen[i]) list[count++] = i;
        domain_add_set(domain, name, count, list);
        free(list);
        free(chosen);
    }
}
