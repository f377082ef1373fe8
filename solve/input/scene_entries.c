/* The deck's sections boundary and initial: who is held, loaded or set in motion. */
#include "corners.h"
#include "memory.h"
#include "scene.h"

#include <stdlib.h>

struct given {
    struct deck_node selector[SELECTORS], value[SCENE_KINDS];
    int direction;
};
#define AT(member) offsetof(struct given, member)
#define VALUE(kind, unit, most)                                                                    \
    KEY_NODE, AT(value) + (kind) * sizeof(struct deck_node), unit, -(most), most, .form = "VALUE"

static const char *const directions[] = {"x", "y", "z", NULL};

/* The last rows are the kinds, in their order; those of initial end before the forces. */
static const struct key rows[] = {
    SELECTION_KEYS(AT(selector)),
    {"direction", KEY_CHOICE, AT(direction), .names = directions, .required = true,
     .help = "across it the nodes are free"},
    {"velocity", VALUE(SCENE_VELOCITY, "m/s", 1e5), .help = "of each node"},
    {"displacement", VALUE(SCENE_DISPLACEMENT, "m", 1e3), .help = "of each node"},
    {"force", VALUE(SCENE_FORCE, "N", 1e15),
     .help = "of all nodes, spread evenly over their volume"},
    {"body_force", VALUE(SCENE_BODY_FORCE, "N/m3", 1e18), .help = "per volume"},
};
enum { FIRST_KIND = SELECTORS + 1 };

const struct section section_boundary = {
    .path = "boundary",
    .help =
        "A list of entries with one selector, a direction and one of the four values: a number "
        "with its unit; an expression in x, y, z (reference position) and t, in SI, of force in t "
        "alone; {ramp: TIME, to: NUMBER}; a table [[TIME, NUMBER], ...] or {table: FILE}; or, of "
        "forces, {initial: NUMBER, increment: NUMBER, "
        "every: N steps}.  Expressions know + - * / ^, comparisons, && ||, c ? a : b, sin cos tan "
        "sqrt exp ln abs min max and their like; they are tried at all nodes before the first "
        "step.  Loads add up; a node held twice along one direction is an error.  The grips are, "
        "of the selections that move along the axis of the test (x, or domain.axis) as one, the "
        "leftmost and the rightmost, where these "
        "lie one beside the other.",
    .keys = {FIRST_KIND + SCENE_KINDS, rows}};

const struct section section_initial = {
    .path = "initial",
    .help =
        "A list of entries with selector and direction as in boundary: where the nodes start, a "
        "number or an expression in x, y, z.  It stands over 'start: affine', what boundary "
        "holds stands over it.",
    .keys = {FIRST_KIND + SCENE_FORCE, rows}};

/* What a value may depend on. */
static const int allowed[SCENE_KINDS] = {
    [SCENE_VELOCITY] = VALUE_IN_SPACE | VALUE_IN_TIME,
    [SCENE_DISPLACEMENT] = VALUE_IN_SPACE | VALUE_IN_TIME,
    [SCENE_FORCE] = VALUE_IN_TIME | VALUE_STEPPED,
    [SCENE_BODY_FORCE] = VALUE_IN_SPACE | VALUE_IN_TIME | VALUE_STEPPED,
};

static enum scene_kind find_kind(struct deck_node entry, const struct deck_node value[],
                                 bool initial)
{
    int kind = -1;
    for (int k = 0; k < SCENE_KINDS; k++) {
        if (value[k].index == 0) continue;
        if (kind >= 0)
            deck_error(value[k], "'%s' beside '%s', expected one of them",
                       rows[FIRST_KIND + k].name, rows[FIRST_KIND + kind].name);
        kind = k;
    }
    if (kind < 0)
        deck_error(entry, "expected one of: velocity, displacement%s",
                   initial ? "" : ", force, body_force");
    return (enum scene_kind)kind;
}

static struct scene_entry read_entry(struct deck_node where, bool initial)
{
    struct given given = {0};
    keys_read(where, initial ? &section_initial : &section_boundary, 0, 0, &given, NULL);
    const enum scene_kind kind = find_kind(where, given.value, initial);
    const struct key *row = &rows[FIRST_KIND + kind];
    return (struct scene_entry){.where = where,
                                .nodes.selection = selection_read(where, given.selector),
                                .direction = given.direction,
                                .kind = kind,
                                .value =
                                    value_read(given.value[kind], row->unit, row->low, row->high,
                                               allowed[kind] & (initial ? VALUE_IN_SPACE : ~0))};
}

static struct scene_entry *read_list(struct deck_node list, bool initial, int *count)
{
    if (list.index == 0) return NULL;
    *count = deck_count(list);
    struct scene_entry *entries = memory_new((size_t)*count, sizeof *entries);
    for (int i = 0; i < *count; i++) entries[i] = read_entry(deck_item(list, i), initial);
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
    scene->boundary = read_list(deck_find(root, "boundary"), false, &scene->n_boundary);
    scene->initial = read_list(deck_find(root, "initial"), true, &scene->n_initial);
    scene_read_macroscopic(scene, deck_find(root, "macroscopic"));
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

/* Those that move: of corners, all that particles of a set or block have, or those at the place. */
static void resolve_moving(struct scene_entry *entry, const struct domain *domain,
                           const struct domain *places, const struct lattice *lattice)
{
    struct scene_nodes *nodes = &entry->nodes;
    /* The sets of a mesh are of its nodes. */
    const bool named = (nodes->selection.kind == SELECT_SET && !lattice->hexahedron) ||
                       nodes->selection.kind == SELECT_BLOCK;
    resolve(nodes, named ? domain : places, lattice->spacing);
    if (!lattice->corner || !named) return;
    int64_t *particles = nodes->numbers;
    nodes->numbers = corners_of_particles(lattice, particles, &nodes->count);
    free(particles);
    if (entry->kind == SCENE_BODY_FORCE && nodes->count < lattice->n_nodes)
        deck_error(entry->where,
                   "corners that a set or block shares with other particles would have "
                   "the whole of a body_force: give force, or a box or where");
}

void scene_resolve(struct scene *scene, const struct domain *domain, const struct domain *nodes,
                   const struct lattice *lattice)
{
    const double spacing = lattice->spacing;
    for (int i = 0; i < scene->n_boundary; i++)
        resolve_moving(&scene->boundary[i], domain, nodes, lattice);
    for (int i = 0; i < scene->n_initial; i++)
        resolve_moving(&scene->initial[i], domain, nodes, lattice);
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
    for (int i = 0; i < count; i++) {
        const int64_t *number = entries[i].nodes.numbers, *end = number + entries[i].nodes.count;
        struct domain_nodes nodes = {0};
        while (entries[i].value.expression && number < end && domain_next(domain, &nodes))
            for (; number < end && *number < nodes.first + nodes.count; number++) {
                const int64_t k = *number - nodes.first;
                const double x[] = {nodes.x[0][k], nodes.x[1][k], nodes.x[2][k]};
                value_try(&entries[i].value, x, end_time);
            }
    }
}

void scene_try(const struct scene *scene, const struct domain *nodes, double end_time)
{
    try_entries(scene->boundary, scene->n_boundary, nodes, end_time);
    try_entries(scene->initial, scene->n_initial, nodes, end_time);
    for (int i = 0; i < scene->n_components; i++)
        value_try(&scene->components[i].value, (const double[]){0, 0, 0}, end_time);
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
    for (int i = 0; i < scene->n_components; i++) value_free(&scene->components[i].value);
    free(scene->components);
    for (int i = 0; i < scene->n_quantities; i++) free_nodes(&scene->quantities[i].nodes);
    free(scene->quantities);
    free(scene->fields.variables);
    programme_free(&scene->programme);
    *scene = (struct scene){0};
}
