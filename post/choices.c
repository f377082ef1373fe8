#include "choices.h"

#include "deck.h"
#include "die.h"
#include "memory.h"
#include "units.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum kind { TEXT, NUMBER, RANGE };

struct choice {
    const char *option, *key, *argument, *help;
    enum kind kind;
    const char *unit;
    double low, high;
    size_t place;
};

#define PLACE(member) offsetof(struct choices, member)

static const struct choice table[] = {
    {"title", "title", "TEXT", "name of the curve", TEXT, "", 0, 0, PLACE(title)},
    {"gauge-length", "gauge_length", "LENGTH", "initial gauge length instead of the history's",
     NUMBER, "m", 1e-12, 1e3, PLACE(gauge_length)},
    {"section", "section", "AREA", "initial section instead of the history's", NUMBER, "m2", 1e-24,
     1e6, PLACE(section)},
    {"modulus-range", "modulus_range", "A:B", "fit of the slope, shares of Rp0.2 (0.1:0.4)", RANGE,
     "1", 0, 1, PLACE(modulus_range)},
    {"modulus-rows", "modulus_rows", "A:B", "fit of the slope, rows counted from 1", RANGE, "1", 1,
     1e12, PLACE(modulus_rows)},
    {"toe", "toe", "STRAIN", "strain at zero stress instead of the fit's", NUMBER, "1", -1, 1,
     PLACE(toe)},
    {"modulus", "modulus", "STRESS", "E in plastic strain instead of the measured slope", NUMBER,
     "Pa", 1, 1e15, PLACE(modulus)},
    {"true-modulus", "true_modulus", "STRESS", "replace the slope by this: machine compliance",
     NUMBER, "Pa", 1, 1e15, PLACE(true_modulus)},
    {"hardening-range", "hardening_range", "A:B", "plastic strain for n and K (0.02:0.2)", RANGE,
     "1", 0, 10, PLACE(hardening_range)},
    {"fit-range", "fit_range", "A:B", "true plastic strain for the laws (0.002:10)", RANGE, "1", 0,
     10, PLACE(fit_range)},
    {"window", "window", "STRAIN", "width over which slopes are taken (0.01)", NUMBER, "1", 1e-9, 1,
     PLACE(window)},
    {"yield-drop", "yield_drop", "SHARE", "fall that makes an upper yield point (0.02)", NUMBER,
     "1", 0, 1, PLACE(yield_drop)},
    {"fracture-share", "fracture_share", "SHARE", "of Rm; below it is broken (0.1)", NUMBER, "1", 0,
     1, PLACE(fracture_share)},
};
_Static_assert(sizeof table / sizeof *table == CHOICE_COUNT, "one row a choice");
_Static_assert((int)CHOICE_COUNT == (int)DECK_POST_KEYS, "one key of the deck a choice");

struct choices choices_default(void)
{
    return (struct choices){
        .gauge_length = NAN,
        .section = NAN,
        .modulus_range = {NAN, NAN},
        .modulus_rows = {NAN, NAN},
        .toe = NAN,
        .modulus = NAN,
        .true_modulus = NAN,
        .hardening_range = {0.02, 0.20},
        .fit_range = {0.002, 10},
        .window = 0.01,
        .yield_drop = 0.02,
        .fracture_share = 0.1,
    };
}

static void set_title(struct choices *choices, const char *title)
{
    free(choices->title);
    choices->title = memory_text(title);
}

static double *number_of(struct choices *choices, const struct choice *choice)
{
    return (double *)(void *)((char *)choices + choice->place);
}

static void read_node(struct choices *choices, const struct choice *choice, struct deck_node node)
{
    double *values = number_of(choices, choice);
    if (choice->kind == TEXT) {
        set_title(choices, deck_string(node));
    } else if (choice->kind == NUMBER) {
        *values = deck_number(node, choice->unit, choice->low, choice->high);
    } else {
        if (!deck_is_list(node) || deck_count(node) != 2)
            deck_error(node, "%s: expected [low, high]", choice->key);
        for (int i = 0; i < 2; i++)
            values[i] = deck_number(deck_item(node, i), choice->unit, choice->low, choice->high);
        if (values[0] >= values[1]) deck_error(node, "%s: low must be below high", choice->key);
    }
}

void choices_read_deck(struct choices *choices, const struct deck *deck)
{
    deck_check_sections(deck);
    struct deck_node title = deck_find(deck_root(deck), "title");
    if (title.index) set_title(choices, deck_string(title));
    struct deck_node post = deck_find(deck_root(deck), "post");
    if (!post.index) return;

    for (int i = 0; i < CHOICE_COUNT; i++) {
        struct deck_node node = deck_find(post, table[i].key);
        if (node.index) read_node(choices, &table[i], node);
    }
}

void choices_options(struct option_row rows[], const char *texts[])
{
    for (int i = 0; i < CHOICE_COUNT; i++)
        rows[i] = (struct option_row){.name = table[i].option,
                                      .argument = table[i].argument,
                                      .help = table[i].help,
                                      .value = &texts[i]};
}

static double read_text(const struct choice *choice, const char *text)
{
    double value;
    const char *wrong = units_read(text, choice->unit, &value);
    if (wrong) die_user("--%s: %s", choice->option, wrong);
    if (!(value >= choice->low && value <= choice->high))
        die_user("--%s: %s is out of range, expected %g to %g %s", choice->option, text,
                 choice->low, choice->high, choice->unit);
    return value;
}

static void read_range(const struct choice *choice, const char *text, double values[2])
{
    char *low = memory_text(text), *colon = strchr(low, ':');
    if (!colon) die_user("--%s: '%s', expected %s", choice->option, text, choice->argument);
    *colon = '\0';
    values[0] = read_text(choice, low);
    values[1] = read_text(choice, colon + 1);
    if (values[0] >= values[1])
        die_user("--%s: '%s', the first must be below the second", choice->option, text);
    free(low);
}

void choices_read_options(struct choices *choices, const char *const texts[])
{
    for (int i = 0; i < CHOICE_COUNT; i++) {
        if (!texts[i]) continue;
        double *values = number_of(choices, &table[i]);
        if (table[i].kind == TEXT)
            set_title(choices, texts[i]);
        else if (table[i].kind == NUMBER)
            *values = read_text(&table[i], texts[i]);
        else
            read_range(&table[i], texts[i], values);
    }
}

void choices_free(struct choices *choices)
{
    free(choices->title);
    choices->title = NULL;
}
