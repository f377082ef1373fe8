#include "sections.h"

#include "keys.h"
#include "varied.h"

#define SECTION(name, words)                                                                       \
    {                                                                                              \
#name, KEY_NODE, offsetof(struct sections, name), .help = words                            \
    }
#define LIST(name, words)                                                                          \
    {                                                                                              \
#name, KEY_NODE, offsetof(struct sections, name), .form = "list of mappings",              \
                                                          .help = words                            \
    }

static const struct key rows[] = {
    {"title", KEY_TEXT, offsetof(struct sections, title),
     .help = "name of the study, for all programs"},
    SECTION(domain, "hsgen: the specimen and its structure"),
    SECTION(materials, "hssolve: one mapping a phase, under its name"),
    LIST(damage, "hssolve: laws by which bonds break and nodes fail"),
    LIST(cracks, "hssolve: cracks that are there from the start"),
    LIST(boundary, "hssolve: what holds and loads the body"),
    LIST(initial, "hssolve: displacements and velocities at the start"),
    LIST(macroscopic, "hssolve: how a periodic body is deformed as a whole"),
    SECTION(solver, "hssolve: how the run advances, and to where"),
    SECTION(output, "hssolve: histories, quantities and fields"),
    SECTION(post, "hspost: how a curve is evaluated"),
    {"vary", KEY_NODE, offsetof(struct sections, vary), .section = &vary_section,
     .help = "hsgen --study: what varies from deck to deck"},
    {"refine", KEY_NODE, offsetof(struct sections, refine), .form = "number or list of numbers",
     .help = "hsgen --study: the same body also at the spacing divided by so much, 2 to 16, and "
             "what the spacing adds to the curve; two numbers show the order, too"},
    {"sensitivity", KEY_NODE, offsetof(struct sections, sensitivity),
     .form = "{KEY: [VALUE, ...], ...}",
     .help = "hsgen --study: the same body also with each of these values, one key changed at a "
             "time, and what that changes of the properties: {horizon: [1.5, 2], share: [0.05, "
             "0.2]}"},
    {"varied", KEY_NODE, offsetof(struct sections, varied), .section = &varied_section,
     .help = "hspost: what varied"},
};

const struct section deck_section = {
    .path = "deck",
    .help = "The sections of a study. Each program reads those it owns and passes over the others.",
    .keys = KEYS(rows),
};

struct sections sections_read(const struct deck *deck)
{
    struct sections sections;
    keys_read(deck_root(deck), &deck_section, 0, 0, &sections, NULL);
    keys_read(sections.post, &post_section, 0, 0, &sections.choices, NULL);
    if (!sections.choices.title) sections.choices.title = sections.title;
    return sections;
}

struct choices choices_read(const struct deck *deck)
{
    struct choices choices;
    if (deck) return sections_read(deck).choices;
    keys_read((struct deck_node){0}, &post_section, 0, 0, &choices, NULL);
    return choices;
}
