#include "deck_path.h"

#include "memory.h"
#include "nearest.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 20000 };

static void add(struct deck_paths *paths, char *path, struct deck_node node)
{
    if (paths->count >= MOST) deck_error(node, "a deck of more than %d places", MOST);
    paths->items = memory_grow(paths->items, paths->count, sizeof *paths->items);
    paths->items[paths->count++] = (struct deck_place){path, node};
}

static void walk(struct deck_paths *paths, const char *path, struct deck_node node)
{
    const bool map = deck_is_map(node);
    if (!map && !deck_is_list(node)) return;
    for (int i = 0; i < deck_count(node); i++) {
        char *longer = map ? memory_print("%s.%s", path, deck_key(node, i))
                           : memory_print("%s.%d", path, i + 1);
        const struct deck_node child = map ? deck_value(node, i) : deck_item(node, i);
        add(paths, longer, child);
        walk(paths, longer, child);
    }
}

static bool among(const char *const names[], const char *name)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(names[i], name) == 0) return true;
    return false;
}

struct deck_paths deck_paths_list(const struct deck *deck, const char *const except[])
{
    struct deck_paths paths = {0};
    const struct deck_node root = deck_root(deck);
    for (int i = 0; i < deck_count(root); i++) {
        if (among(except, deck_key(root, i))) continue;
        char *path = memory_text(deck_key(root, i));
        add(&paths, path, deck_value(root, i));
        walk(&paths, path, deck_value(root, i));
    }
    return paths;
}

void deck_paths_free(struct deck_paths *paths)
{
    for (int i = 0; i < paths->count; i++) free(paths->items[i].path);
    free(paths->items);
    *paths = (struct deck_paths){0};
}

static bool ends_in(const char *path, const char *name)
{
    const size_t n = strlen(path), m = strlen(name);
    return n > m && path[n - m - 1] == '.' && strcmp(path + n - m, name) == 0;
}

static int count_dots(const char *text)
{
    int n = 0;
    for (; *text; text++) n += *text == '.';
    return n;
}

/* The end of a path with so many dots in it, or the whole. */
static const char *tail_of(const char *path, int dots)
{
    for (int more = count_dots(path) - dots; more > 0; more--) path = strchr(path, '.') + 1;
    return path;
}

static _Noreturn void die_unknown(const struct deck_paths *paths, struct deck_node where,
                                  const char *name)
{
    const char **tails = memory_new((size_t)paths->count, sizeof *tails);
    for (int i = 0; i < paths->count; i++)
        tails[i] = tail_of(paths->items[i].path, count_dots(name));
    const char *nearest = nearest_name(name, tails, paths->count);
    int k = 0;
    while (nearest && tails[k] != nearest) k++;
    deck_error(where,
               "this deck has no key '%.60s'%s%s%s; what varies has to stand in it, with any value",
               name, nearest ? " (did you mean " : "", nearest ? paths->items[k].path : "",
               nearest ? "?)" : "");
}

const struct deck_place *deck_paths_find(const struct deck_paths *paths, struct deck_node where,
                                         const char *name)
{
    const struct deck_place *found = NULL;
    char *all = NULL;
    bool several = false;
    for (int i = 0; i < paths->count; i++) {
        const struct deck_place *place = &paths->items[i];
        if (strcmp(place->path, name) == 0) {
            free(all);
            return place;
        }
        if (!ends_in(place->path, name)) continue;
        all = memory_append(all, "%s%s", all ? ", " : "", place->path);
        /* Through aliases one place has several paths. */
        several = several || (found && found->node.index != place->node.index);
        if (!found) found = place;
    }
    if (!found) die_unknown(paths, where, name);
    if (several) deck_error(where, "'%.60s' may mean %s: write more of it", name, all);
    free(all);
    return found;
}
