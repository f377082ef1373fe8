#include "expansion.h"

#include "memory.h"
#include "recipe.h"
#include "refinement.h"

#include <stdlib.h>
#include <string.h>

/* --- values ----------------------------------------------------------------------------------- */

static int index_of(const struct expansion *expansion, int64_t run, int k)
{
    return variations_index(&expansion->variations, run, k);
}

static const char *text_of(const struct expansion *expansion, int64_t run, int k, int key)
{
    return expansion->variations.items[k].keys[key].texts[index_of(expansion, run, k)];
}

/* Without quotes around it. */
static char *shown(const char *text)
{
    const size_t n = strlen(text);
    const bool quoted = n > 1 && (*text == '"' || *text == '\'') && text[n - 1] == *text;
    return memory_print("%.*s", (int)(quoted ? n - 2 : n), text + quoted);
}

struct varied expansion_varied(const struct expansion *expansion, int64_t run)
{
    struct varied varied = {0};
    for (int k = 0; k < expansion->variations.count; k++) {
        const struct variation *variation = &expansion->variations.items[k];
        for (int j = 0; j < variation->n_keys; j++) {
            varied.items = memory_grow(varied.items, varied.count, sizeof *varied.items);
            varied.items[varied.count++] =
                (struct varied_item){memory_text(variation->keys[j].name),
                                     shown(text_of(expansion, run, k, j)), variation->role};
        }
    }
    return varied;
}

/* --- the spacing ------------------------------------------------------------------------------ */

static double spacing_of(const struct expansion *expansion, int i)
{
    const struct variation_key *key =
        &expansion->variations.items[expansion->resolution].keys[expansion->spacing_key];
    return refinement_spacing(key->texts[i], key->where[i]);
}

static void find_resolution(struct expansion *expansion)
{
    expansion->resolution = -1;
    for (int k = 0; k < expansion->variations.count; k++) {
        const struct variation *variation = &expansion->variations.items[k];
        for (int j = 0; variation->role == VARIED_RESOLUTION && j < variation->n_keys; j++) {
            const char *path = variation->keys[j].path;
            if (!path || strcmp(path, "domain.spacing") != 0) continue;
            expansion->resolution = k;
            expansion->spacing_key = j;
        }
    }
    if (expansion->resolution < 0) return;
    for (int i = 0; i < expansion->variations.items[expansion->resolution].count; i++)
        if (spacing_of(expansion, i) > spacing_of(expansion, expansion->coarsest))
            expansion->coarsest = i;
    expansion->has_cores = refinement_has_cores(expansion->deck);
    if (expansion->has_cores && expansion->variations.zipped)
        deck_error(expansion->variations.items[expansion->resolution].where,
                   "zipped, no run at another spacing has the same body, whose cores this one "
                   "would take: cross them, or name a file of cores in domain");
}

struct expansion expansion_of(const struct deck *deck)
{
    struct expansion expansion = {.deck = deck, .variations = variations_read(deck)};
    find_resolution(&expansion);
    return expansion;
}

void expansion_free(struct expansion *expansion)
{
    variations_free(&expansion->variations);
}

int64_t expansion_maker(const struct expansion *expansion, int64_t run)
{
    if (!expansion->has_cores) return run;
    int64_t stride = 1;
    for (int k = expansion->variations.count - 1; k > expansion->resolution; k--)
        stride *= expansion->variations.items[k].count;
    return run + (expansion->coarsest - index_of(expansion, run, expansion->resolution)) * stride;
}

/* By how much finer than the deck's own spacing. */
static double factor_of(const struct expansion *expansion, int64_t run)
{
    if (expansion->resolution < 0) return 1;
    const struct deck_node own =
        expansion->variations.items[expansion->resolution].keys[expansion->spacing_key].node;
    const double now = spacing_of(expansion, index_of(expansion, run, expansion->resolution));
    const struct deck_node first = deck_is_list(own) ? deck_item(own, 0) : own;
    return refinement_spacing(deck_string(first), first) / now;
}

/* --- the text --------------------------------------------------------------------------------- */

/* Lies in one of the first count replacements. */
static bool is_edited(const struct text_edits *edits, int count, struct deck_span span)
{
    for (int i = 0; i < count; i++)
        if (edits->items[i].begin <= span.begin && span.end <= edits->items[i].end) return true;
    return false;
}

static void edit_values(const struct expansion *expansion, int64_t run, const char *cores,
                        struct text_edits *edits)
{
    const struct variations *variations = &expansion->variations;
    const double factor = factor_of(expansion, run);
    struct deck_node *varying = NULL;
    int count = 0;
    for (int k = 0; k < variations->count; k++)
        for (int j = 0; j < variations->items[k].n_keys; j++) {
            if (!variations->items[k].keys[j].path) continue;
            varying = memory_grow(varying, count, sizeof *varying);
            varying[count++] = variations->items[k].keys[j].node;
        }
    refinement_edit(expansion->deck, &variations->paths, varying, count, factor, cores, edits);
    free(varying);
    /* Of these, a key that the file of cores stands for. */
    const int before = edits->count;
    for (int k = 0; k < variations->count; k++)
        for (int j = 0; j < variations->items[k].n_keys; j++) {
            const struct variation_key *key = &variations->items[k].keys[j];
            if (!key->path || is_edited(edits, before, deck_span(key->node))) continue;
            char *text = refinement_scale(text_of(expansion, run, k, j), factor);
            text_edits_add(edits, deck_span(key->node).begin, deck_span(key->node).end, text);
            free(text);
        }
}

/* ", ufg_fraction 0.2, spacing 25 um": all but the scatter, of which curves of one title are; names
 * of values stand for the values. */
static char *words_of(const struct expansion *expansion, int64_t run)
{
    char *words = memory_text("");
    for (int k = 0; k < expansion->variations.count; k++) {
        const struct variation *variation = &expansion->variations.items[k];
        bool named = false;
        for (int j = 0; j < variation->n_keys; j++) named = named || !variation->keys[j].path;
        for (int j = 0; j < variation->n_keys; j++) {
            if (variation->role == VARIED_SCATTER || (named && variation->keys[j].path)) continue;
            char *value = shown(text_of(expansion, run, k, j));
            const bool changes = variation->role == VARIED_SENSITIVITY;
            const bool unchanged = changes && strcmp(value, varied_unchanged) == 0;
            if (changes && !unchanged)
                words = memory_append(words, ", %s", value);
            else if (!changes)
                words = memory_append(words, ", %s %s", variation->keys[j].name, value);
            free(value);
        }
    }
    return words;
}

/* Title of a deck that has none: the name of its file. */
static char *name_of(const struct deck *deck)
{
    const char *name = deck_name(deck), *slash = strrchr(name, '/');
    const char *base = slash ? slash + 1 : name, *dot = strrchr(base, '.');
    return memory_print("%.*s", (int)(dot ? dot - base : (long)strlen(base)), base);
}

static char *title_with(const char *title, const char *words)
{
    char *whole = memory_print("%s%s", title, words), *quoted = varied_quote(whole);
    free(whole);
    return quoted;
}

static bool edit_title(struct deck_node map, const char *words, struct text_edits *edits)
{
    const struct deck_node title = deck_find(map, "title");
    if (title.index == 0) return false;
    const struct deck_span span = deck_span(title);
    char *text = title_with(deck_string(title), words);
    const bool line = deck_is_block(title);
    char *whole = memory_print("%s%s", text, line ? "\n" : "");
    if (!is_edited(edits, edits->count, span)) text_edits_add(edits, span.begin, span.end, whole);
    free(whole);
    free(text);
    return true;
}

/* In place of the sections vary, refine and sensitivity. */
static void edit_sections(const struct expansion *expansion, const char *line,
                          struct text_edits *edits)
{
    const struct deck_node root = deck_root(expansion->deck);
    const bool block = deck_is_block(root);
    bool put = false;
    for (int i = 0; i < deck_count(root); i++) {
        const char *key = deck_key(root, i);
        if (strcmp(key, "vary") != 0 && strcmp(key, "refine") != 0 &&
            strcmp(key, "sensitivity") != 0)
            continue;
        size_t end = deck_span(deck_value(root, i)).end;
        if (put && !block && i + 1 < deck_count(root))
            end = deck_span(deck_key_node(root, i + 1)).begin;
        text_edits_add(edits, deck_span(deck_key_node(root, i)).begin, end, put ? "" : line);
        put = true;
    }
}

char *expansion_text(const struct expansion *expansion, int64_t run, const char *cores)
{
    struct text_edits edits = {0};
    const struct deck_node root = deck_root(expansion->deck), post = deck_find(root, "post");
    char *words = words_of(expansion, run);
    struct varied varied = expansion_varied(expansion, run);
    char *line = varied_print(&varied);
    edit_values(expansion, run, cores, &edits);
    bool titled = edit_title(root, words, &edits);
    if (post.index && deck_is_map(post)) titled = edit_title(post, words, &edits) || titled;
    if (!titled) {
        char *name = name_of(expansion->deck), *title = title_with(name, words);
        char *both = memory_print("title: %s%s%s", title, deck_is_block(root) ? "\n" : ", ", line);
        free(name);
        free(title);
        free(line);
        line = both;
    }
    edit_sections(expansion, line, &edits);
    const int clash = text_edits_clash(&edits);
    if (clash >= 0)
        deck_error(expansion->variations.items[0].where,
                   "'%.60s' lies within another value that varies", edits.items[clash].text);
    char *text = text_edits_apply(&edits, deck_text(expansion->deck));
    text_edits_free(&edits);
    varied_free(&varied);
    free(line);
    free(words);
    return text;
}

/* --- checking --------------------------------------------------------------------------------- */

static bool is_quoted(const char *text)
{
    return *text == '"' || *text == '\'';
}

/* What the deck says is what was to be put there. */
static void check_values(const struct expansion *expansion, int64_t run, const struct deck *deck)
{
    static const char *const none[] = {NULL};
    struct deck_paths paths = deck_paths_list(deck, none);
    const double factor = factor_of(expansion, run);
    for (int k = 0; k < expansion->variations.count; k++)
        for (int j = 0; j < expansion->variations.items[k].n_keys; j++) {
            const struct variation_key *key = &expansion->variations.items[k].keys[j];
            char *text = refinement_scale(text_of(expansion, run, k, j), factor);
            for (int i = 0; key->path && i < paths.count; i++) {
                const struct deck_place *place = &paths.items[i];
                if (strcmp(place->path, key->path) != 0 || is_quoted(text)) continue;
                const bool same = deck_is_scalar(place->node)
                                      ? strcmp(deck_string(place->node), text) == 0
                                      : strchr("[{", *text) != NULL;
                if (!same)
                    deck_error(key->where[index_of(expansion, run, k)],
                               "'%.60s' is not one value where it goes; put it in quotes", text);
            }
            free(text);
        }
    deck_paths_free(&paths);
}

/* The study with this run's values: lines of both are the same. */
static char *name_of_run(const struct expansion *expansion, int64_t run)
{
    struct varied varied = expansion_varied(expansion, run);
    char *name = memory_text(deck_name(expansion->deck));
    for (int i = 0; i < varied.count; i++) {
        const struct varied_item *item = &varied.items[i];
        name = memory_append(name, "%s %s %s", i ? "," : " with", item->name, item->value);
    }
    varied_free(&varied);
    return name;
}

void expansion_check(const struct expansion *expansion, int64_t run, const char *text)
{
    char *name = name_of_run(expansion, run);
    struct deck *deck = deck_parse(text, strlen(text), name);
    check_values(expansion, run, deck);
    recipe_read(deck);
    deck_free(deck);
    free(name);
}
