#include "keys.h"

#include "memory.h"
#include "nearest.h"

#include <stdlib.h>
#include <string.h>

static int count_names(const char *const names[])
{
    int count = 0;
    while (names[count]) count++;
    return count;
}

int keys_choice(struct deck_node node, const char *const names[])
{
    return deck_choice(node, names, count_names(names));
}

static int count_variants(const struct section *section)
{
    int count = 0;
    while (section->variant && section->variant(count)) count++;
    return count;
}

static const char **variant_names(const struct section *section)
{
    const int count = count_variants(section);
    const char **names = memory_new((size_t)count + 1, sizeof *names);
    for (int i = 0; i < count; i++) names[i] = section->variant(i)->name;
    return names;
}

int keys_variant(struct deck_node map, const struct section *section)
{
    if (section->usual >= 0 && !deck_has(map, section->chooser)) return section->usual;
    const char **names = variant_names(section);
    const int variant = keys_choice(deck_get(map, section->chooser), names);
    free(names);
    return variant;
}

/* --- checking --------------------------------------------------------------------------------- */

static bool uses(const struct key *key, int variant)
{
    return !key->users || (key->users >> variant & 1);
}

static const struct key *find(const struct keys *keys, const char *name)
{
    for (int i = 0; i < keys->count; i++)
        if (strcmp(keys->rows[i].name, name) == 0) return &keys->rows[i];
    return NULL;
}

static bool chooses(const struct section *section)
{
    return section->chooser && !section->outside;
}

static bool belongs(const struct section *section, int variant, const char *name)
{
    if (chooses(section) && strcmp(section->chooser, name) == 0) return true;
    const struct key *key = find(&section->keys, name);
    if (key && uses(key, variant)) return true;
    return section->variant && find(&section->variant(variant)->keys, name);
}

/* "type: explicit or hybrid": the variants that have the key, NULL where none has; the caller frees
 * it. */
static char *owners(const struct section *section, const char *name)
{
    char *text = NULL;
    const int count = count_variants(section);
    for (int i = 0; i < count; i++) {
        if (!belongs(section, i, name)) continue;
        const char *owner = section->variant(i)->name;
        text = text ? memory_append(text, " or %s", owner)
                    : memory_print("%s: %s", section->chooser, owner);
    }
    return text;
}

/* Names that the variant knows, ended by NULL; to be freed. */
static const char **known_names(const struct section *section, int variant)
{
    const struct keys *own = section->variant ? &section->variant(variant)->keys : NULL;
    const int most = 1 + section->keys.count + (own ? own->count : 0);
    const char **names = memory_new((size_t)most + 1, sizeof *names);
    int n = 0;
    if (chooses(section)) names[n++] = section->chooser;
    for (int i = 0; i < section->keys.count; i++)
        if (uses(&section->keys.rows[i], variant)) names[n++] = section->keys.rows[i].name;
    for (int i = 0; own && i < own->count; i++) names[n++] = own->rows[i].name;
    return names;
}

void keys_check(struct deck_node map, const struct section *section, int variant)
{
    (void)deck_find(map, ""); /* dies where it is no mapping */
    for (int i = 0; i < deck_count(map); i++) {
        const char *name = deck_key(map, i);
        if (belongs(section, variant, name)) continue;
        char *others = owners(section, name);
        if (others)
            deck_error(deck_key_node(map, i), "'%.60s' belongs to %s, not to %s: %s", name, others,
                       section->chooser, section->variant(variant)->name);
        deck_keys(map, known_names(section, variant)); /* dies */
    }
}

/* --- reading ---------------------------------------------------------------------------------- */

static double read_number(const struct key *key, struct deck_node node, double spacing)
{
    const double scale = key->kind == KEY_SPACINGS ? spacing : 1;
    if (key->kind == KEY_NUMBER) return deck_number(node, key->unit, key->low, key->high);
    return spacing > 0 ? deck_length(node, spacing, scale * key->low, scale * key->high)
                       : deck_number(node, "m", key->low, key->high);
}

void keys_list(const struct key *key, struct deck_node node, double spacing, double values[])
{
    if (!deck_is_list(node) || deck_count(node) != key->size)
        deck_error(node, "'%s' is a list of %d %s", key->name, key->size,
                   key->kind == KEY_NUMBER ? "numbers" : "lengths");
    for (int k = 0; k < key->size; k++) {
        values[k] = read_number(key, deck_item(node, k), spacing);
        if (key->rising && k > 0 && values[k] <= values[k - 1])
            deck_error(deck_item(node, k), "'%s' must rise, expected more than %g", key->name,
                       values[k - 1]);
    }
}

void keys_axes(struct deck_node list, const char *key, bool axes[3])
{
    static const char *const names[] = {"x", "y", "z"};
    if (!deck_is_list(list) || deck_count(list) == 0)
        deck_error(list, "%s is a list of axes: [x, y, z], or some of them", key);
    for (int i = 0; i < deck_count(list); i++) {
        const int axis = deck_choice(deck_item(list, i), names, 3);
        if (axes[axis]) deck_error(deck_item(list, i), "%s is in the list already", names[axis]);
        axes[axis] = true;
    }
}

/* One number is all edges of a cell. */
static void read_spacing(const struct key *key, struct deck_node node, double edges[])
{
    if (key->size && deck_is_list(node)) {
        keys_list(key, node, 0, edges);
        return;
    }
    edges[0] = deck_number(node, "m", key->low, key->high);
    for (int k = 1; k < key->size; k++) edges[k] = edges[0];
}

static void read_key(const struct key *key, struct deck_node node, double *spacing, void *place,
                     void *whole)
{
    switch (key->kind) {
    case KEY_SPACING:
        read_spacing(key, node, place);
        *spacing = *(double *)place;
        break;
    case KEY_NUMBER:
    case KEY_LENGTH:
    case KEY_SPACINGS:
        if (key->size)
            keys_list(key, node, *spacing, place);
        else
            *(double *)place = read_number(key, node, *spacing);
        break;
    case KEY_INTEGER:
        *(int64_t *)place = deck_integer(node, (long)key->low, (long)key->high);
        break;
    case KEY_CHOICE:
        *(int *)place = keys_choice(node, key->names);
        break;
    case KEY_FLAG:
        *(bool *)place = deck_bool(node);
        break;
    case KEY_TEXT:
        *(const char **)place = deck_string(node);
        break;
    case KEY_SECTION:
        keys_read(node, key->section, 0, *spacing, whole, NULL);
        break;
    case KEY_NODE:
        *(struct deck_node *)place = node;
    }
}

double keys_usual(const struct key *key, int k)
{
    return key->usuals ? key->usuals[k] : key->usual;
}

static void set_usual(const struct key *key, double spacing, void *place, void *whole)
{
    const double scale = key->kind == KEY_SPACINGS ? spacing : 1;
    switch (key->kind) {
    case KEY_NUMBER:
    case KEY_LENGTH:
    case KEY_SPACINGS:
    case KEY_SPACING:
        for (int k = 0; k < (key->size ? key->size : 1); k++)
            ((double *)place)[k] = scale * keys_usual(key, k);
        break;
    case KEY_INTEGER:
        *(int64_t *)place = (int64_t)key->usual;
        break;
    case KEY_CHOICE:
        *(int *)place = (int)key->usual;
        break;
    case KEY_FLAG:
        *(bool *)place = key->usual > 0;
        break;
    case KEY_SECTION:
        keys_read((struct deck_node){0}, key->section, 0, spacing, whole, NULL);
        break;
    case KEY_TEXT:
        *(const char **)place = NULL;
        break;
    case KEY_NODE:
        *(struct deck_node *)place = (struct deck_node){0};
    }
}

static void read_rows(struct deck_node map, const struct keys *keys, int variant, double *spacing,
                      void *out)
{
    for (int i = 0; i < keys->count; i++) {
        const struct key *key = &keys->rows[i];
        void *place = (char *)out + key->place;
        struct deck_node node = {0};
        if (map.index && uses(key, variant))
            node = key->required ? deck_get(map, key->name) : deck_find(map, key->name);
        if (node.index)
            read_key(key, node, spacing, place, out);
        else
            set_usual(key, *spacing, place, out);
    }
}

void keys_read(struct deck_node map, const struct section *section, int variant, double spacing,
               void *common, void *own)
{
    if (map.index) keys_check(map, section, variant);
    read_rows(map, &section->keys, variant, &spacing, common);
    if (own && section->variant) read_rows(map, &section->variant(variant)->keys, 0, &spacing, own);
}
