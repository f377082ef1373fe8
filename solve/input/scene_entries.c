/* The deck's sections boundary and initial: who is held, loaded or set in motion. */
#include "memory.h"
#include "scene.h"

#include <stdlib.h>

/* Keys of the kinds, their units, the largest value that makes sense, and what a value may depend on. */
static const struct {
    const char *key, *unit;
    double largest;
    int allowed;
} kinds[SCENE_KINDS] = {
    {"velocity", "m/s", 1e5, VALUE_IN_SPACE | VALUE_IN_TIME},
    {"displacement", "m", 1e3, VALUE_IN_SPACE | VALUE_IN_TIME},
    {"force", "N", 1e15, VALUE_IN_TIME | VALUE_STEPPED},
    {"body_force", "N/m3", 1e18, VALUE_IN_SPACE | VALUE_IN_TIME | VALUE_STEPPED},
};

static enum scene_kind find_kind(struct deck_node entry, int count)
{
    int kind = -1;
    for (int k = 0; k < count; k++) {
        if (!deck_has(entry, kinds[k].key)) continue;
        if (kind >= 0)
            deck_error(deck_get(entry, kinds[k].key), "'%s' beside '%s', expected one of them",
                       kinds[k].key, kinds[kind].key);
        kind = k;
    }
    if (kind < 0)
        deck_error(entry, "expected one of: velocity, displacement%s",
                   count > SCENE_FORCE ? ", force, body_force" : "");
    return (enum scene_kind)kind;
}

static struct scene_entry read_entry(struct deck_node where, bool initial)
{
    static const char *const directions[] = {"x", "y", "z"};
    struct scene_entry entry = {.where = where,
                                .nodes.selection = selection_read(where),
                                .direction =
                                    deck_choice(deck_get(where, "direction"), directions, 3),
                                .kind = find_kind(where, initial ? SCENE_FORCE : SCENE_KINDS)};
    const int allowed = kinds[entry.kind].allowed & (initial ? VALUE_IN_SPACE : ~0);
    const double largest = kinds[entry.kind].largest;
    entry.value = value_read(deck_get(where, kinds[entry.kind].key), kinds[entry.kind].unit,
                             -largest, largest, allowed);
    return entry;
}

static struct scene_entry *read_list(struct deck_node list, bool initial, int *count)
{
    *count = deck_count(list);
    struct scene_entry *entries = memory_new((size_t)*count, sizeof *entries);
    for (int i = 0; i < *count; i++) {
        struct deck_node entry = deck_item(list, i);
        if (initial)
            deck_keys(entry, (const char *const[]){SELECTION_KEYS, "direction", "velocity",
                                                   "displacement", NULL});
        else
            deck_keys(entry, (const char *const[]){SELECTION_KEYS, "direction", "velocity",
                                                   "displacement", "force", "body_force", NULL});
        entries[i] = read_entry(entry, initial);
    }
    return entries;
}

/* solver.ramp: the velocities that are numbers are reached along it. */
static void add_ramp(struct scene *scene)
{
    for (int i = 0; i < scene->n_boundary; i++) {
        struct scene_entry *entry = &scene->boundary[i];
        if (entry->kind != SCENE_VELOCITY || entry->value.kind != VALUE_CONSTANT) continue;
        entry->value.kind = VALUE_RAMP;
        entry->value.ramp = scene->ramp;
    }
}

void scene_read_entries(struct scene *scene, struct deck_node root)
{
    if (deck_has(root, "boundary"))
        scene->boundary = read_list(deck_get(root, "boundary"), false, &scene->n_boundary);
    if (deck_has(root, "initial"))
        scene->initial = read_list(deck_get(root, "initial"), true, &scene->n_initial);
    if (scene->start == START_RAMP) add_ramp(scene);
}

/* First node that two selections share, -1 for none. */
static int64_t shared_node(const struct scene_nodes *a, const struct scene_nodes *b)
{
    for (int64_t i = 0, j = 0; i < a->count && j < b->count;) {
        if (a->numbers[i] == b->numbers[j]) return a->numbers[i];
        if (a->numbers[i] < b->numbers[j])
            i++;
        else
            j++;
    }
    return -1;
}

/* Whether both want to rule the same component: at the start each kind is one of its own. */
static bool rivals(const struct scene_entry *a, const struct scene_entry *b, bool initial)
{
    if (a->direction != b->direction) return false;
    return initial ? a->kind == b->kind : scene_holds(a->kind) && scene_holds(b->kind);
}

static void refuse_overlap(const struct scene_entry *entries, int count, bool initial)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < i; k++) {
            if (!rivals(&entries[k], &entries[i], initial)) continue;
            int64_t node = shared_node(&entries[k].nodes, &entries[i].nodes);
            if (node < 0) continue;
            deck_error(entries[i].where,
                       "node %lld is %s along one direction twice, by %s and by %s",
                       (long long)node + 1, initial ? "set" : "held",
                       selection_name(&entries[k].nodes.selection),
                       selection_name(&entries[i].nodes.selection));
        }
}

static void resolve(struct scene_nodes *nodes, const struct domain *domain, double spacing)
{
    nodes->numbers = selection_nodes(&nodes->selection, domain, spacing, &nodes->count);
}

void scene_resolve(struct scene *scene, const struct domain *domain, double spacing)
{
    for (int i = 0; i < scene->n_boundary; i++) resolve(&scene->boundary[i].nodes, domain, spacing);
    for (int i = 0; i < scene->n_initial; i++) resolve(&scene->initial[i].nodes, domain, spacing);
    for (int i = 0; i < scene->n_quantities; i++) {
        struct scene_quantity *quantity = &scene->quantities[i];
        if (quantity->place.index == 0) {
            resolve(&quantity->nodes, domain, spacing);
            continue;
        }
        quantity->nodes.count = 1;
        quantity->nodes.numbers = memory_new(1, sizeof *quantity->nodes.numbers);
        quantity->nodes.numbers[0] = selection_nearest(quantity->place, domain, spacing);
    }
    refuse_overlap(scene->boundary, scene->n_boundary, false);
    refuse_overlap(scene->initial, scene->n_initial, true);
}

static void try_entries(const struct scene_entry *entries, int count, const struct domain *domain,
                        double end_time)
{
    const double *const x[] = {domain->x, domain->y, domain->z};
    for (int i = 0; i < count; i++)
        value_try(&entries[i].value, entries[i].nodes.count, entries[i].nodes.numbers, x, end_time);
}

void scene_try(const struct scene *scene, const struct domain *domain, double end_time)
{
    try_entries(scene->boundary, scene->n_boundary, domain, end_time);
    try_entries(scene->initial, scene->n_initial, domain, end_time);
}

static void free_nodes(struct scene_nodes *nodes)
{
    selection_free(&nodes->selection);
    free(nodes->numbers);
}

static void free_entries(struct scene_entry *entries, int count)
{
    for (int i = 0; i < count; i++) {
        free_nodes(&entries[i].nodes);
        value_free(&entries[i].value);
    }
    free(entries);
}

void scene_free(struct scene *scene)
{
    free_entries(scene->boundary, scene->n_boundary);
    free_entries(scene->initial, scene->n_initial);
    for (int i = 0; i < scene->n_quantities; i++) free_nodes(&scene->quantities[i].nodes);
    free(scene->quantities);
    free(scene->fields.variables);
    *scene = (struct scene){0};
}
