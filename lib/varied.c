#include "varied.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static const char *const combinations[] = {"crossed", "zipped", NULL};

#define WORD(member) .place = offsetof(struct vary_words, member)

static const struct key vary_rows[] = {
    {"NAME", KEY_NODE, WORD(scatter),
     .form = "[VALUE, ...], 1..10, {KEY: [VALUE, ...], ...} or {csv: FILE}",
     .help = "the values of a key, by its path (domain.ufg_fraction, boundary.2.velocity) or as "
             "much of its end as is "
             "enough (ufg_fraction); whole numbers from one to another; or, under a name of their "
             "own, keys that vary "
             "together, value by value, with 'name: [...]' for what to call these, also from a "
             "table whose headings are the "
             "keys"},
    {"scatter", KEY_NODE, WORD(scatter), .form = "NAME or [NAME, ...]", .otherwise = "none",
     .help = "over what hspost takes means and deviations: seeds"},
    {"resolution", KEY_NODE, WORD(resolution), .form = "NAME", .otherwise = "none",
     .help = "of what hspost extrapolates to zero: the spacing, at which the body stays the same, "
             "cores and lengths in "
             "spacings too, or an equal measure of fineness"},
    {"combine", KEY_CHOICE, WORD(combine), .names = combinations,
     .help = "each value of one with each of the other, or the first with the first and so on"},
};

const struct section vary_section = {
    .path = "deck.vary",
    .help = "A study of many decks: hsgen --study DECK -o FOLDER writes each, and how to run them. "
            " What varies has to stand "
            "in the deck, with any value.",
    .keys = KEYS(vary_rows),
};

bool vary_is_word(const char *key)
{
    for (int i = 1; i < vary_section.keys.count; i++)
        if (strcmp(vary_rows[i].name, key) == 0) return true;
    return false;
}

struct vary_words vary_words_read(struct deck_node vary)
{
    struct vary_words words = {0};
    if (vary.index == 0) return words;
    words.scatter = deck_find(vary, "scatter");
    words.resolution = deck_find(vary, "resolution");
    const struct deck_node combine = deck_find(vary, "combine");
    if (combine.index) words.combine = keys_choice(combine, combinations);
    return words;
}

/* --- varied ----------------------------------------------------------------------------------- */

const char varied_unchanged[] = "none";

/* Where the keys of the section stand in the deck. */
struct places {
    struct deck_node values, scatter, resolution, sensitivity;
};

static const struct key varied_rows[] = {
    {"values", KEY_NODE, offsetof(struct places, values), .form = "{NAME: VALUE, ...}",
     .required = true, .help = "what varied, and its value here"},
    {"scatter", KEY_NODE, offsetof(struct places, scatter), .form = "[NAME, ...]",
     .help = "over what means are taken"},
    {"resolution", KEY_NODE, offsetof(struct places, resolution), .form = "NAME",
     .help = "of what is extrapolated to zero"},
    {"sensitivity", KEY_NODE, offsetof(struct places, sensitivity), .form = "[NAME, ...]",
     .help = "what is changed, one at a time: the first names what"},
};

const struct section varied_section = {
    .path = "deck.varied",
    .help = "What hsgen --study leaves of vary in each deck; hspost makes columns of it.",
    .keys = KEYS(varied_rows),
};

static struct varied_item *find(struct varied *varied, struct deck_node where)
{
    const char *name = deck_string(where);
    for (int i = 0; i < varied->count; i++)
        if (strcmp(varied->items[i].name, name) == 0) return &varied->items[i];
    deck_error(where, "'%.60s' is none of the values that varied", name);
}

static void set_role(struct varied *varied, struct deck_node names, enum varied_role role)
{
    for (int i = 0; names.index && i < deck_count(names); i++)
        find(varied, deck_item(names, i))->role = role;
}

struct varied varied_read(struct deck_node section)
{
    struct varied varied = {0};
    struct places places;
    if (section.index == 0) return varied;
    keys_read(section, &varied_section, 0, 0, &places, NULL);
    varied.count = deck_count(places.values);
    varied.items = memory_new((size_t)varied.count, sizeof *varied.items);
    for (int i = 0; i < varied.count; i++)
        varied.items[i] = (struct varied_item){
            memory_text(deck_key(places.values, i)),
            memory_text(deck_string(deck_value(places.values, i))), VARIED_QUESTION};
    set_role(&varied, places.scatter, VARIED_SCATTER);
    set_role(&varied, places.sensitivity, VARIED_SENSITIVITY);
    if (places.resolution.index) find(&varied, places.resolution)->role = VARIED_RESOLUTION;
    return varied;
}

void varied_free(struct varied *varied)
{
    for (int i = 0; i < varied->count; i++) {
        free(varied->items[i].name);
        free(varied->items[i].value);
    }
    free(varied->items);
    *varied = (struct varied){0};
}

char *varied_quote(const char *text)
{
    char *quoted = memory_new(4 * strlen(text) + 3, 1), *end = quoted;
    *end++ = '"';
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') *end++ = '\\';
        if (c < 0x20) {
            static const char digits[] = "0123456789abcdef";
            end = stpcpy(end, "\\x");
            *end++ = digits[c >> 4];
            *end++ = digits[c & 15];
        } else
            *end++ = *text;
    }
    *end = '"';
    return quoted;
}

static void append_quoted(char **text, const char *before, const char *words)
{
    char *quoted = varied_quote(words);
    *text = memory_append(*text, "%s%s", before, quoted);
    free(quoted);
}

/* ", NAME: [...]" with what has the role; nothing where nothing has. */
static void append_role(char **text, const struct varied *varied, enum varied_role role,
                        const char *name)
{
    char *before = memory_print(", %s: [", name);
    int count = 0;
    for (int i = 0; i < varied->count; i++)
        if (varied->items[i].role == role)
            append_quoted(text, count++ ? ", " : before, varied->items[i].name);
    if (count) *text = memory_append(*text, "]");
    free(before);
}

char *varied_print(const struct varied *varied)
{
    char *text = memory_text("varied: {values: {");
    for (int i = 0; i < varied->count; i++) {
        append_quoted(&text, i ? ", " : "", varied->items[i].name);
        append_quoted(&text, ": ", varied->items[i].value);
    }
    text = memory_append(text, "}");
    append_role(&text, varied, VARIED_SCATTER, "scatter");
    append_role(&text, varied, VARIED_SENSITIVITY, "sensitivity");
    for (int i = 0; i < varied->count; i++)
        if (varied->items[i].role == VARIED_RESOLUTION)
            append_quoted(&text, ", resolution: ", varied->items[i].name);
    return memory_append(text, "}");
}
