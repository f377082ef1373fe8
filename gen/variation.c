#include "variation.h"

#include "memory.h"
#include "refinement.h"
#include "units.h"
#include "value_table.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RUNS = 100000 };

/* What the study is about, and no key of a body. */
static const char *const studies[] = {"vary", "refine", "sensitivity", "varied", NULL};

/* --- values ----------------------------------------------------------------------------------- */

static void add_value(struct variation_key *key, int *count, char *text, struct deck_node where)
{
    if (*count >= MOST_RUNS) deck_error(where, "more than %d values of %s", MOST_RUNS, key->name);
    key->texts = memory_grow(key->texts, *count, sizeof *key->texts);
    key->where = memory_grow(key->where, *count, sizeof *key->where);
    key->texts[*count] = text;
    key->where[(*count)++] = where;
}

/* As it is written in the deck. */
static char *source_of(struct deck_node node)
{
    if (deck_is_block(node))
        deck_error(node, "a value over lines of its own; write it as [...], {...} or in one line");
    const struct deck_span span = deck_span(node);
    if (span.begin == span.end) deck_error(node, "a value is missing here");
    return memory_print("%.*s", (int)(span.end - span.begin), deck_text(node.deck) + span.begin);
}

/* "1..10": its ends. */
static bool read_range(const char *text, long *first, long *last)
{
    char *end;
    errno = 0;
    *first = strtol(text, &end, 10);
    if (end == text || isspace((unsigned char)*text) || strncmp(end, "..", 2) != 0) return false;
    const char *second = end + 2;
    *last = strtol(second, &end, 10);
    return end != second && !isspace((unsigned char)*second) && !*end && errno == 0;
}

static void add_item(struct variation_key *key, int *count, struct deck_node node)
{
    long first, last;
    if (!deck_is_scalar(node) || !read_range(deck_string(node), &first, &last)) {
        add_value(key, count, source_of(node), node);
        return;
    }
    if (last < first)
        deck_error(node, "from %ld down to %ld: write the smaller one first", first, last);
    for (long value = first; value <= last; value++)
        add_value(key, count, memory_print("%ld", value), node);
}

/* A list, or a range; returns the number of values. */
static int add_values(struct variation_key *key, struct deck_node node)
{
    int count = 0;
    long first, last;
    const bool list = deck_is_list(node);
    if (!list && !(deck_is_scalar(node) && read_range(deck_string(node), &first, &last)))
        deck_error(node, "expected the values of %s: a list [..., ...], or 1..10", key->name);
    if (!list) add_item(key, &count, node);
    for (int i = 0; list && i < deck_count(node); i++) add_item(key, &count, deck_item(node, i));
    if (count == 0) deck_error(node, "%s has no values here", key->name);
    return count;
}

/* --- keys ------------------------------------------------------------------------------------- */

static struct variation_key *add_key(struct variation *variation, const char *name)
{
    variation->keys = memory_grow(variation->keys, variation->n_keys, sizeof *variation->keys);
    variation->keys[variation->n_keys] = (struct variation_key){.name = name};
    return &variation->keys[variation->n_keys++];
}

static void find_place(const struct deck_paths *paths, struct variation_key *key,
                       struct deck_node where)
{
    const struct deck_place *place = deck_paths_find(paths, where, key->name);
    if (deck_is_block(place->node))
        deck_error(place->node, "this varies, but stands over lines of its own; write it as [...], "
                                "{...} or in one line");
    key->path = place->path;
    key->node = place->node;
}

/* "name" in a group is what to call its values. */
static void set_place(const struct deck_paths *paths, struct variation *variation,
                      struct variation_key *key, struct deck_node where)
{
    if (strcmp(key->name, "name") == 0)
        key->name = variation->name;
    else
        find_place(paths, key, where);
}

static void take_count(struct variation *variation, int count, struct deck_node where)
{
    if (variation->n_keys > 1 && count != variation->count)
        deck_error(where, "%d values, expected %d: keys of '%s' vary together", count,
                   variation->count, variation->name);
    variation->count = count;
}

static void read_group(const struct deck_paths *paths, struct variation *variation,
                       struct deck_node map)
{
    for (int i = 0; i < deck_count(map); i++) {
        struct variation_key *key = add_key(variation, deck_key(map, i));
        set_place(paths, variation, key, deck_key_node(map, i));
        take_count(variation, add_values(key, deck_value(map, i)), deck_value(map, i));
    }
    if (variation->n_keys == 0) deck_error(map, "'%s' has no keys here", variation->name);
}

/* A relative file is beside the deck. */
static char *beside(const char *deck, const char *file)
{
    if (*file == '/' || !strchr(deck, '/')) return memory_text(file);
    char *folder = memory_folder(deck), *path = memory_print("%s/%s", folder, file);
    free(folder);
    return path;
}

static void read_table(const struct deck_paths *paths, struct variation *variation,
                       struct deck_node file)
{
    char *path = beside(deck_name(file.deck), deck_string(file));
    struct value_table table = value_table_read(path);
    if (table.n_rows == 0) deck_error(file, "%s has headings and no values", path);
    for (int j = 0; j < table.n_columns; j++) {
        char *heading = memory_text(table.headings[j]);
        struct variation_key *key = add_key(variation, heading);
        key->heading = heading;
        int count = 0;
        set_place(paths, variation, key, file);
        for (int i = 0; i < table.n_rows; i++)
            add_value(key, &count, memory_text(table.values[i * table.n_columns + j]), file);
        variation->count = count;
    }
    value_table_free(&table);
    free(path);
}

static struct variation read_variation(const struct deck_paths *paths, struct deck_node vary, int i)
{
    const struct deck_node value = deck_value(vary, i);
    struct variation variation = {.name = deck_key(vary, i), .where = deck_key_node(vary, i)};
    if (deck_is_map(value) && deck_count(value) == 1 && deck_has(value, "csv"))
        read_table(paths, &variation, deck_get(value, "csv"));
    else if (deck_is_map(value))
        read_group(paths, &variation, value);
    else {
        struct variation_key *key = add_key(&variation, variation.name);
        find_place(paths, key, variation.where);
        variation.count = add_values(key, value);
    }
    return variation;
}

/* The spacing as it is, and each that refine asks for. */
static struct variation read_refinement(struct deck_node root, struct deck_node refine)
{
    const struct deck_node spacing = deck_get(deck_get(root, "domain"), "spacing");
    struct variation variation = {.name = "spacing", .where = refine, .role = VARIED_RESOLUTION};
    struct variation_key *key = add_key(&variation, "spacing");
    key->path = "domain.spacing";
    key->node = spacing;
    add_value(key, &variation.count, source_of(spacing), spacing);
    for (int i = 0; i < refinement_count(refine); i++)
        add_value(key, &variation.count, refinement_text(refine, i, spacing),
                  refinement_where(refine, i));
    return variation;
}

/* All keys as they are, but the last, which has one more value. */
static void add_change(struct variation *variation, const char *text, struct deck_node where)
{
    const int last = variation->n_keys - 1;
    for (int k = 0; k <= last; k++) {
        struct variation_key *key = &variation->keys[k];
        int count = variation->count;
        add_value(key, &count,
                  k == 0      ? memory_print("%s %s", variation->keys[last].name, text)
                  : k == last ? memory_text(text)
                              : source_of(key->node),
                  where);
    }
    variation->count++;
}

/* The deck as it is, and each value of each key in it. */
static struct variation read_sensitivity(const struct deck_paths *paths, struct deck_node map)
{
    struct variation variation = {.name = "sensitivity", .where = map, .role = VARIED_SENSITIVITY};
    if (!deck_is_map(map) || deck_count(map) == 0)
        deck_error(map, "expected keys and the values that they are to have instead, such as "
                        "'sensitivity: {horizon: [1.5, 2]}'");
    add_value(add_key(&variation, variation.name), &variation.count, memory_text(varied_unchanged),
              map);
    for (int i = 0; i < deck_count(map); i++) {
        struct variation_key values = {.name = deck_key(map, i)};
        const int n = add_values(&values, deck_value(map, i));
        struct variation_key *key = add_key(&variation, values.name);
        find_place(paths, key, deck_key_node(map, i));
        for (int count = 0; count < variation.count;)
            add_value(key, &count, source_of(key->node), key->node);
        for (int v = 0; v < n; v++) {
            add_change(&variation, values.texts[v], values.where[v]);
            free(values.texts[v]);
        }
        free(values.texts);
        free(values.where);
    }
    return variation;
}

/* --- roles ------------------------------------------------------------------------------------ */

static void set_role(struct variations *variations, struct deck_node where, enum varied_role role)
{
    const char *name = deck_string(where);
    for (int i = 0; i < variations->count; i++) {
        struct variation *variation = &variations->items[i];
        if (strcmp(variation->name, name) != 0) continue;
        if (variation->role != VARIED_QUESTION)
            deck_error(where, "'%s' is named twice: scatter or resolution, not both", name);
        variation->role = role;
        return;
    }
    deck_error(where, "'%.60s' does not vary here", name);
}

static void set_roles(struct variations *variations, struct vary_words words)
{
    const bool list = words.scatter.index && deck_is_list(words.scatter);
    if (words.scatter.index && !list) set_role(variations, words.scatter, VARIED_SCATTER);
    for (int i = 0; list && i < deck_count(words.scatter); i++)
        set_role(variations, deck_item(words.scatter, i), VARIED_SCATTER);
    if (words.resolution.index) set_role(variations, words.resolution, VARIED_RESOLUTION);
}

static void check_pair(struct deck_node where, const struct variation_key *a,
                       const struct variation_key *b)
{
    if (a->path && b->path && a->node.index == b->node.index)
        deck_error(where, "'%s' varies already as '%s'", a->name, b->name);
    if (strcmp(a->name, b->name) == 0) deck_error(where, "two things are called '%s'", a->name);
}

/* Two keys may be one place of the deck, and one may be called as the numbers of the runs are. */
static void check_places(const struct variations *variations)
{
    for (int i = 0; i < variations->count; i++)
        for (int j = 0; j < variations->items[i].n_keys; j++) {
            const struct variation *now = &variations->items[i];
            if (strcmp(now->keys[j].name, "run") == 0)
                deck_error(now->where, "'run' is what the tables call the number of a run; call "
                                       "this something else");
            for (int k = 0; k <= i; k++)
                for (int l = 0; l < (k < i ? variations->items[k].n_keys : j); l++)
                    check_pair(now->where, &now->keys[j], &variations->items[k].keys[l]);
        }
}

/* What the keys of some variations are in one row of their values. */
struct row {
    char *text;
    int number;
};

static int by_row(const void *a, const void *b)
{
    const struct row *first = a, *second = b;
    const int order = strcmp(first->text, second->text);
    return order != 0 ? order : first->number - second->number;
}

/* Of a word, such as "0.50 mm", the one way to write it: "0.0005". */
static char *plain_word(const char *word)
{
    double value;
    if (units_read_any(word, &value)) return memory_print("%.15g", value);
    if (!*word || !strchr("+-.0123456789", *word)) return memory_text(word);
    char *unit; /* spacings */
    value = strtod(word, &unit);
    return memory_print("%.15g%s", value, unit);
}

/* The same of each word of a text. */
static char *plain(const char *text)
{
    static const char marks[] = "[]{},:", beside[] = " \t\"'";
    char *all = memory_text("");
    while (*text) {
        const size_t mark = strspn(text, marks), begin = mark + strspn(text + mark, beside);
        const size_t next = begin + strcspn(text + begin, marks);
        size_t end = next;
        while (end > begin && strchr(beside, text[end - 1])) end--;
        char *word = memory_print("%.*s", (int)(end - begin), text + begin);
        char *short_word = plain_word(word);
        all = memory_append(all, "%.*s%s", (int)mark, text, short_word);
        free(short_word);
        free(word);
        text += next;
    }
    return all;
}

/* Two runs of one deck would be read as two of a scatter of 0. */
static void refuse_twice(const struct variation *items, int count)
{
    const int n = items->count;
    struct row *rows = memory_new((size_t)n, sizeof *rows);
    for (int i = 0; i < n; i++) {
        rows[i] = (struct row){memory_text(""), i};
        for (int v = 0; v < count; v++)
            for (int k = items[v].role == VARIED_SENSITIVITY; k < items[v].n_keys; k++) {
                char *value = plain(items[v].keys[k].texts[i]);
                rows[i].text = memory_append(rows[i].text, "%s\n", value);
                free(value);
            }
    }
    qsort(rows, (size_t)n, sizeof *rows, by_row);
    for (int i = 1; i < n; i++) {
        const struct variation_key *key = &items->keys[0];
        const int again = rows[i].number;
        if (strcmp(rows[i - 1].text, rows[i].text) == 0)
            deck_error(key->where[again], "%s %s is there twice (values %d and %d), expected once",
                       key->name, key->texts[again], rows[i - 1].number + 1, again + 1);
    }
    for (int i = 0; i < n; i++) free(rows[i].text);
    free(rows);
}

static void refuse_duplicates(const struct variations *variations)
{
    if (variations->zipped) refuse_twice(variations->items, variations->count);
    for (int i = 0; !variations->zipped && i < variations->count; i++)
        refuse_twice(&variations->items[i], 1);
}

static void count_runs(struct variations *variations)
{
    variations->runs = variations->zipped ? variations->items[0].count : 1;
    for (int i = 0; i < variations->count; i++) {
        const struct variation *variation = &variations->items[i];
        if (variations->zipped && variation->count != variations->runs)
            deck_error(variation->where,
                       "%d values, expected %d as of '%s': 'combine: zipped' takes the first with "
                       "the first and so on",
                       variation->count, variations->items[0].count, variations->items[0].name);
        if (!variations->zipped) variations->runs *= variation->count;
        if (variations->runs > MOST_RUNS)
            deck_error(variation->where, "more than %d decks; make several studies of it",
                       MOST_RUNS);
    }
}

static void add_variation(struct variations *variations, struct variation variation)
{
    variations->items =
        memory_grow(variations->items, variations->count, sizeof *variations->items);
    variations->items[variations->count++] = variation;
}

struct variations variations_read(const struct deck *deck)
{
    struct variations variations = {.paths = deck_paths_list(deck, studies)};
    const struct deck_node root = deck_root(deck), vary = deck_find(root, "vary");
    const struct deck_node refine = deck_find(root, "refine");
    const struct deck_node sensitivity = deck_find(root, "sensitivity");
    const struct vary_words words = vary_words_read(vary);
    variations.zipped = words.combine == VARY_ZIPPED;
    for (int i = 0; vary.index && i < deck_count(vary); i++) {
        if (vary_is_word(deck_key(vary, i))) continue;
        add_variation(&variations, read_variation(&variations.paths, vary, i));
    }
    if (refine.index && (words.resolution.index || variations.zipped))
        deck_error(refine, "'refine' is a resolution of its own, crossed with all else: leave out "
                           "'resolution' and 'combine'");
    if (sensitivity.index && variations.zipped)
        deck_error(sensitivity, "'sensitivity' is crossed with all else: leave out 'combine'");
    if (sensitivity.index)
        add_variation(&variations, read_sensitivity(&variations.paths, sensitivity));
    if (refine.index) add_variation(&variations, read_refinement(root, refine));
    if (variations.count == 0)
        deck_error(vary, "nothing varies here; a study has a section 'vary' with keys and their "
                         "values, such as 'vary: {seed: 1..5}', or 'refine: 2'");
    set_roles(&variations, words);
    check_places(&variations);
    count_runs(&variations);
    refuse_duplicates(&variations);
    return variations;
}

void variations_free(struct variations *variations)
{
    for (int i = 0; i < variations->count; i++) {
        struct variation *variation = &variations->items[i];
        for (int j = 0; j < variation->n_keys; j++) {
            for (int v = 0; v < variation->count; v++) free(variation->keys[j].texts[v]);
            free(variation->keys[j].heading);
            free(variation->keys[j].texts);
            free(variation->keys[j].where);
        }
        free(variation->keys);
    }
    free(variations->items);
    deck_paths_free(&variations->paths);
    *variations = (struct variations){0};
}

int variations_index(const struct variations *variations, int64_t run, int k)
{
    if (variations->zipped) return (int)run;
    for (int i = variations->count - 1; i > k; i--) run /= variations->items[i].count;
    return (int)(run % variations->items[k].count);
}
