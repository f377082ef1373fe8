#include "scene.h"

#include "body/family.h"
#include "memory.h"
#include "nearest.h"
#include "output/fields.h"

#include <stdlib.h>

static double number_or(struct deck_node map, const char *key, const char *unit, double low,
                        double high, double fallback)
{
    return deck_has(map, key) ? deck_number(deck_get(map, key), unit, low, high) : fallback;
}

static void read_boundary(struct scene *scene, struct deck_node list)
{
    static const char *const directions[] = {"x", "y", "z"};
    scene->n_boundary = deck_count(list);
    scene->boundary = memory_new((size_t)scene->n_boundary, sizeof *scene->boundary);
    for (int i = 0; i < scene->n_boundary; i++) {
        struct deck_node entry = deck_item(list, i);
        deck_keys(entry, (const char *const[]){"set", "direction", "velocity", NULL});
        scene->boundary[i] = (struct scene_boundary){
            .set = deck_string(deck_get(entry, "set")),
            .direction = deck_choice(deck_get(entry, "direction"), directions, 3),
            .velocity = deck_number(deck_get(entry, "velocity"), "m/s", -1e5, 1e5),
            .node = entry};
    }
}

static void read_start(struct scene *scene, struct deck_node solver)
{
    static const char *const starts[] = {"affine", "ramp"};
    if (deck_has(solver, "start"))
        scene->start = (enum scene_start)deck_choice(deck_get(solver, "start"), starts, 2);
    if (scene->start == START_RAMP)
        scene->ramp = deck_number(deck_get(solver, "ramp"), "s", 1e-15, 1e6);
    else if (deck_has(solver, "ramp"))
        deck_error(deck_get(solver, "ramp"), "a ramp goes with 'start: ramp'");
}

static void read_solver(struct scene *scene, struct deck_node solver)
{
    static const char *const types[] = {"explicit"};
    deck_keys(solver, (const char *const[]){"type", "horizon", "influence", "stabilisation",
                                            "plane", "volumes", "surface_correction", "end_strain",
                                            "end_time", "safety", "start", "ramp", "damping",
                                            "energy_tolerance", NULL});
    deck_choice(deck_get(solver, "type"), types, 1);
    scene->horizon = deck_number(deck_get(solver, "horizon"), "1", 1, 8);
    scene->influence = -1;
    if (deck_has(solver, "influence"))
        scene->influence =
            deck_choice(deck_get(solver, "influence"), family_influences, family_influence_count);
    static const char *const volumes[] = {"whole", "partial"}, *const planes[] = {"stress",
                                                                                  "strain"};
    scene->solver = solver;
    if (deck_has(solver, "volumes"))
        scene->partial_volumes = deck_choice(deck_get(solver, "volumes"), volumes, 2) == 1;
    if (deck_has(solver, "plane"))
        scene->plane =
            deck_choice(deck_get(solver, "plane"), planes, 2) ? PLANE_STRAIN : PLANE_STRESS;
    if (deck_has(solver, "end_strain") == deck_has(solver, "end_time"))
        deck_error(solver, "give one of end_strain and end_time");
    scene->end_strain = number_or(solver, "end_strain", "1", 1e-9, 10, 0);
    scene->end_time = number_or(solver, "end_time", "s", 1e-15, 1e6, 0);
    scene->safety = number_or(solver, "safety", "1", 1e-3, 10, 0.8);
    scene->damping = number_or(solver, "damping", "1/s", 0, 1e15, 0);
    scene->energy_tolerance = number_or(solver, "energy_tolerance", "1", 1e-12, 1e6, 0.01);
    read_start(scene, solver);
}

static void read_fields(struct scene *scene, struct deck_node map)
{
    deck_keys(map, (const char *const[]){"frames", "variables", NULL});
    scene->fields.frames = (int)deck_integer(deck_get(map, "frames"), 1, 1000000);
    struct deck_node list = deck_get(map, "variables");
    scene->fields.n_variables = deck_count(list);
    if (deck_count(list) == 0) deck_error(list, "no variables; for no fields leave out 'fields'");
    scene->fields.variables = memory_new((size_t)deck_count(list), sizeof(int));
    for (int i = 0; i < deck_count(list); i++)
        scene->fields.variables[i] = deck_choice(deck_item(list, i), field_names, field_count);
}

struct scene scene_read(struct deck *deck)
{
    struct scene scene = {.deck = deck, .history = 500};
    struct deck_node root = deck_root(deck);
    deck_check_sections(deck);
    read_boundary(&scene, deck_get(root, "boundary"));
    read_solver(&scene, deck_get(root, "solver"));
    struct deck_node output = deck_find(root, "output");
    if (output.index != 0) {
        deck_keys(output, (const char *const[]){"history", "fields", NULL});
        if (deck_has(output, "history"))
            scene.history = (int)deck_integer(deck_get(output, "history"), 1, 10000000);
        if (deck_has(output, "fields")) read_fields(&scene, deck_get(output, "fields"));
    }
    return scene;
}

/* First node that two sets share, -1 for none. */
static int64_t shared_node(const struct node_set *a, const struct node_set *b)
{
    for (int64_t i = 0, j = 0; i < a->count && j < b->count;) {
        if (a->nodes[i] == b->nodes[j]) return a->nodes[i];
        if (a->nodes[i] < b->nodes[j])
            i++;
        else
            j++;
    }
    return -1;
}

static void refuse_overlap(const struct scene *scene, const struct domain *domain)
{
    for (int i = 0; i < scene->n_boundary; i++)
        for (int k = 0; k < i; k++) {
            const struct scene_boundary *a = &scene->boundary[k], *b = &scene->boundary[i];
            if (a->direction != b->direction) continue;
            int64_t node = shared_node(domain_set(domain, a->set), domain_set(domain, b->set));
            if (node >= 0)
                deck_error(b->node,
                           "node %lld is held along one direction twice, by '%s' and by '%s'",
                           (long long)node + 1, a->set, b->set);
        }
}

void scene_check_sets(const struct scene *scene, const struct domain *domain)
{
    const char **names = memory_new((size_t)domain->n_sets, sizeof *names);
    for (int i = 0; i < domain->n_sets; i++) names[i] = domain->sets[i].name;
    for (int i = 0; i < scene->n_boundary; i++)
        if (!domain_set(domain, scene->boundary[i].set))
            deck_error(deck_get(scene->boundary[i].node, "set"),
                       "no node set '%s' in the domain, which has: %s", scene->boundary[i].set,
                       domain->n_sets ? nearest_list(names, domain->n_sets) : "none");
    free(names);
    refuse_overlap(scene, domain);
}

void scene_free(struct scene *scene)
{
    free(scene->boundary);
    free(scene->fields.variables);
    *scene = (struct scene){0};
}
