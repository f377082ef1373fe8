/* keys.h - the deck's schema: each key is declared once, and reading, checking, defaults and manual
 * follow.
 *
 * A section of the deck is a struct section: its keys, and, where one of them chooses a variant
 * (solver.type, a hardening law, a topology), the variants with keys of their own.  A key is one
 * row: name, kind, unit, range, default, choices, a line of words, and the member of a struct that
 * it fills.
 *
 * To add a key: a member of the struct, a row of its table.  To add a section: a struct section,
 * its line in the table that the program's --keys prints (docs/deck.md and hsdeck(5) are made of
 * that by 'make docs'). */
#ifndef HS_KEYS_H
#define HS_KEYS_H

#include "deck.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum key_kind {
    KEY_NUMBER,   /* double [SI], low <= value <= high */
    KEY_LENGTH,   /* double [m]; also in spacings */
    KEY_SPACINGS, /* the same, but low, high and usual are in spacings */
    KEY_SPACING,  /* double [m] or, with a size, double[size], all alike where the deck has one
                     number; the first  is the spacing of all lengths that follow, of the variant's
                     rows too */
    KEY_INTEGER,  /* int64_t */
    KEY_CHOICE,   /* int or enum, index in names */
    KEY_FLAG,     /* bool, false or true */
    KEY_TEXT,     /* const char *, lives as long as the deck */
    KEY_SECTION,  /* a mapping whose keys (section->keys) fill the same struct */
    KEY_NODE /* struct deck_node that its owner reads, as form says (index 0: absent); section: its
                keys */
};

struct section;

struct key {
    const char *name;
    enum key_kind kind;
    size_t place;     /* offset of the member in the struct to be filled */
    const char *unit; /* SI, of a number; "1": a pure one */
    double low, high; /* range, of numbers, lengths and integers */
    int size;         /* of a list of so many numbers or lengths, double[size]; 0: one value */
    bool rising;      /* of a list: each number lies above the one before */
    bool required;    /* has no default */
    double usual;     /* the default: of a number or integer; index of a choice; 0 or 1 of a flag */
    const double *usuals;     /* [size] of a list, where its numbers have different ones */
    const char *const *names; /* of a choice, ended by NULL; of a KEY_NODE for the manual alone */
    unsigned users;           /* bit i: variant i of the section has it; 0: all have it */
    const struct section *section;
    /* For the manual, plain words without markup: */
    const char *form; /* how a KEY_NODE or KEY_TEXT is written: "[x, y, z]", "name of a phase" */
    const char *otherwise; /* a default that is no constant: "of the formulation"; "": none */
    const char *help;      /* what it is, one line */
    const char *symbol;    /* in the formula of its variant; NULL: it has none */
};

struct keys {
    int count;
    const struct key *rows;
};
#define KEYS(table)                                                                                \
    {                                                                                              \
        sizeof(table) / sizeof *(table), table                                                     \
    }

/* One choice of a section, with keys that only it has. */
struct variant {
    const char *name;
    const char *help; /* one line for the manual */
    struct keys keys;
};

struct section {
    const char *path;    /* in the manual: "solver", "materials.NAME.hardening" */
    const char *help;    /* what it is, a paragraph of plain words */
    struct keys keys;    /* without the chooser's */
    const char *chooser; /* the key that names the variant; NULL: there are none */
    const struct variant *(*variant)(int i); /* NULL beyond the last one */
    int usual;    /* variant without the chooser's key; -1: it has to be there */
    bool outside; /* the chooser stands in the mapping around, whose reader tells the variant */
};

/* The variant that the map's chooser names, or the usual one; dies where it is unknown or missing.
 */
int keys_variant(struct deck_node map, const struct section *section);

/* Checks that each key of the map belongs to the section and to this variant (0 where there are
 * none): an unknown one is told with the nearest known, one of another variant with whose it is.
 * Then fills *common from the section's rows and *own from the variant's (NULL: it has none): what
 * the map says, in range, or the default; of keys that are not this variant's the default, and all
 * defaults of a map that is not there (index 0).  spacing [m]: for lengths in spacings; 0: there
 * are none. */
void keys_read(struct deck_node map, const struct section *section, int variant, double spacing,
               void *common, void *own);

/* Reads a list of key->size numbers or lengths that a row describes, wherever it stands. */
void keys_list(const struct key *key, struct deck_node node, double spacing, double values[]);

/* Reads a list of axes, none twice, into those that are true; key: its name, for messages. */
void keys_axes(struct deck_node list, const char *key, bool axes[3]);

/* Only checks the names of the keys, for an owner that reads them itself. */
void keys_check(struct deck_node map, const struct section *section, int variant);

/* Index in names (ended by NULL) of a scalar; dies naming the nearest. */
int keys_choice(struct deck_node node, const char *const names[]);

/* The default of item k of a list, or of one number. */
double keys_usual(const struct key *key, int k);

enum keys_format { KEYS_TEXT, KEYS_MDOC, KEYS_MARKDOWN };

/* The sections as a manual: for --keys, hsdeck(5), and the tables of docs/deck.md.  sections: ended
 * by NULL. */
void keys_print(FILE *file, const struct section *const sections[], enum keys_format format);

#endif
