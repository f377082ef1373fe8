#include "image_labels.h"

#include "die.h"
#include "keys.h"
#include "memory.h"
#include "nearest.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char rest_word[] = "rest";

/* --- the deck -----------------------------------------------------------------------------------
 */

struct threshold_keys {
    double at;
    const char *below, *above;
};

#define MEMBER(member) .place = offsetof(struct threshold_keys, member)
static const struct key threshold_rows[] = {
    {"at", KEY_NUMBER, MEMBER(at), .unit = "1", .low = -HUGE_VAL, .high = HUGE_VAL,
     .required = true, .help = "value from which on a voxel is above"},
    {"below", KEY_TEXT, MEMBER(below), .form = "name of a material", .required = true,
     .help = "phase of the voxels below"},
    {"above", KEY_TEXT, MEMBER(above), .form = "name of a material", .required = true,
     .help = "phase of the voxels above"},
};

const struct section image_threshold_section = {
    .path = "domain.threshold",
    .help = "Phases of a grey image.",
    .keys = KEYS(threshold_rows),
};

static struct threshold_keys read_threshold(struct deck_node map)
{
    struct threshold_keys keys;
    keys_read(map, &image_threshold_section, 0, 0, &keys, NULL);
    if (strcmp(keys.below, keys.above) == 0) deck_error(map, "the two phases need two names");
    return keys;
}

int image_phases(struct deck_node domain, const struct image_words *words, int most,
                 const char *names[])
{
    const struct deck_node labels = words->labels;
    if (!labels.index == !words->threshold.index)
        deck_error(words->threshold.index ? words->threshold : domain,
                   "an image needs either 'labels', such as {CG: [1, 3], UFG: 2}, or 'threshold', "
                   "such as {at: 128, below: UFG, above: CG}");
    if (words->threshold.index) {
        const struct threshold_keys keys = read_threshold(words->threshold);
        names[0] = keys.below;
        names[1] = keys.above;
        return 2;
    }
    (void)deck_find(labels, ""); /* dies where it is no mapping */
    const int count = deck_count(labels);
    if (count == 0) deck_error(labels, "there is no phase in it");
    if (count > most) deck_error(labels, "%d phases, a domain can have %d", count, most);
    for (int i = 0; i < count; i++) names[i] = deck_key(labels, i);
    return count;
}

/* --- rules --------------------------------------------------------------------------------------
 */

/* Values from low to high are a phase. */
struct rule {
    double low, high;
    uint8_t phase;
    bool met;
    struct deck_node where;
};

struct rules {
    const struct image *image;
    const char *path;
    int count;
    struct rule *items;
    bool has_rest;
    uint8_t rest;
};

static int compare_numbers(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* The image's values and how often each is there, in words: at most a dozen.  The caller frees it.
 */
static char *list_values(const struct image *image)
{
    enum { SHOWN = 12 };
    const int64_t voxels = image_voxels(image);
    double *sorted = memory_new((size_t)voxels, sizeof *sorted);
    memcpy(sorted, image->value, (size_t)voxels * sizeof *sorted);
    qsort(sorted, (size_t)voxels, sizeof *sorted, compare_numbers);
    char *list = memory_text("");
    int shown = 0;
    for (int64_t i = 0, end; i < voxels; i = end, shown++) {
        for (end = i + 1; end < voxels && sorted[end] == sorted[i];) end++;
        if (shown >= SHOWN) continue;
        const char *name = image_name_of(image, sorted[i]);
        list = memory_append(list, "%s%.9g%s%s%s (%lld)", *list ? ", " : "", sorted[i],
                             name ? " '" : "", name ? name : "", name ? "'" : "",
                             (long long)(end - i));
    }
    free(sorted);
    char *whole =
        shown > SHOWN ? memory_print("%s and %d more", list, shown - SHOWN) : memory_text(list);
    free(list);
    return whole;
}

static void add_rule(struct rules *rules, double low, double high, uint8_t phase,
                     struct deck_node where)
{
    rules->items = memory_grow(rules->items, rules->count, sizeof *rules->items);
    rules->items[rules->count++] = (struct rule){low, high, phase, false, where};
}

static bool read_colour(const char *text, double *value)
{
    if (*text != '#' || strlen(text) != 7 || strspn(text + 1, "0123456789abcdefABCDEF") != 6)
        return false;
    *value = (double)strtol(text + 1, NULL, 16);
    return true;
}

static bool read_value(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

/* "1..12", or a single value. */
static bool read_range(const char *text, double *low, double *high)
{
    const char *dots = strstr(text, "..");
    if (!dots) {
        const bool one = read_value(text, low);
        *high = *low;
        return one;
    }
    char *first = memory_print("%.*s", (int)(dots - text), text);
    const bool both = read_value(first, low) && read_value(dots + 2, high) && *low <= *high;
    free(first);
    return both;
}

/* "3", "1..12", "#ff8000", or a name that the file gives. */
static void add_item(struct rules *rules, struct deck_node item, uint8_t phase)
{
    const char *text = deck_string(item);
    const struct image *image = rules->image;
    double low, high;
    if (strcmp(text, rest_word) == 0) {
        if (rules->has_rest) deck_error(item, "'rest' can belong to one phase only");
        rules->has_rest = true;
        rules->rest = phase;
        return;
    }
    for (int i = 0; i < image->n_names; i++)
        if (strcmp(image->names[i].name, text) == 0) {
            add_rule(rules, image->names[i].value, image->names[i].value, phase, item);
            return;
        }
    if (read_colour(text, &low)) {
        add_rule(rules, low, low, phase, item);
        return;
    }
    if (read_range(text, &low, &high)) {
        add_rule(rules, low, high, phase, item);
        return;
    }
    char *values = list_values(image);
    deck_error(
        item,
        "'%.40s' is no value, range such as 1..12, colour such as #ff8000, 'rest' or name in "
        "%s, which has %s",
        text, rules->path, values);
}

static void add_items(struct rules *rules, struct deck_node node, uint8_t phase)
{
    if (!deck_is_list(node)) {
        add_item(rules, node, phase);
        return;
    }
    for (int i = 0; i < deck_count(node); i++) add_item(rules, deck_item(node, i), phase);
}

static int compare_rules(const void *a, const void *b)
{
    return compare_numbers(&((const struct rule *)a)->low, &((const struct rule *)b)->low);
}

static struct rules read_rules(const struct image *image, const char *path,
                               const struct image_words *words, uint8_t empty)
{
    struct rules rules = {.image = image, .path = path};
    if (words->threshold.index) {
        const double at = read_threshold(words->threshold).at;
        add_rule(&rules, -HUGE_VAL, nextafter(at, -HUGE_VAL), 0, words->threshold);
        add_rule(&rules, at, HUGE_VAL, 1, words->threshold);
    }
    for (int i = 0; words->labels.index && i < deck_count(words->labels); i++)
        add_items(&rules, deck_value(words->labels, i), (uint8_t)i);
    if (words->empty.index) add_items(&rules, words->empty, empty);
    qsort(rules.items, (size_t)rules.count, sizeof *rules.items, compare_rules);
    for (int i = 1; i < rules.count && words->labels.index; i++)
        if (rules.items[i].low <= rules.items[i - 1].high)
            deck_error(rules.items[i].where, "the value %.9g is said to be of two phases, or twice",
                       rules.items[i].low);
    return rules;
}

/* --- voxels -------------------------------------------------------------------------------------
 */

/* Of rules in rising order the one that holds the value, NULL where none does. */
static struct rule *find_rule(const struct rules *rules, double value)
{
    int low = 0, high = rules->count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (rules->items[middle].high < value)
            low = middle + 1;
        else
            high = middle;
    }
    const bool holds = low < rules->count && rules->items[low].low <= value;
    return holds ? &rules->items[low] : NULL;
}

static _Noreturn void refuse_value(const struct rules *rules, int64_t voxel,
                                   const struct image_words *words)
{
    const int64_t *count = rules->image->count;
    char *values = list_values(rules->image);
    deck_error(
        words->labels.index ? words->labels : words->threshold,
        "the value %.9g of %s, first of voxel [%lld, %lld, %lld], belongs to no phase; the "
        "image has %s (values: voxels); name all of them, or 'rest' for those that are left, "
        "or under 'empty' those without material",
        rules->image->value[voxel], rules->path, (long long)(voxel % count[0]),
        (long long)(voxel / count[0] % count[1]), (long long)(voxel / count[0] / count[1]), values);
}

uint8_t *image_label(const struct image *image, const char *path, const struct image_words *words,
                     uint8_t empty)
{
    struct rules rules = read_rules(image, path, words, empty);
    const int64_t voxels = image_voxels(image);
    uint8_t *phase = memory_new((size_t)voxels, sizeof *phase);
    for (int64_t i = 0; i < voxels; i++) {
        struct rule *rule = find_rule(&rules, image->value[i]);
        if (!rule && (!rules.has_rest || !isfinite(image->value[i])))
            refuse_value(&rules, i, words);
        if (rule) rule->met = true;
        phase[i] = rule ? rule->phase : rules.rest;
    }
    for (int i = 0; i < rules.count; i++) {
        const struct rule *rule = &rules.items[i];
        if (rule->met) continue;
        char *values = list_values(image);
        if (words->threshold.index)
            deck_error(rule->where, "all of %s is on one side of the threshold; it has %s", path,
                       values);
        deck_error(rule->where, "%s has no such value: it has %s (values: voxels)", path, values);
    }
    free(rules.items);
    return phase;
}
