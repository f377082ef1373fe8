#include "scene.h"

#include "body/family.h"

static double number_or(struct deck_node map, const char *key, const char *unit, double low,
                        double high, double fallback)
{
    return deck_has(map, key) ? deck_number(deck_get(map, key), unit, low, high) : fallback;
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
                                            "end_time", "end_steps", "safety", "start", "ramp",
                                            "damping", "energy_tolerance", NULL});
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
    if (deck_has(solver, "end_strain") + deck_has(solver, "end_time") +
            deck_has(solver, "end_steps") !=
        1)
        deck_error(solver, "give one of end_strain, end_time and end_steps");
    scene->end_strain = number_or(solver, "end_strain", "1", 1e-9, 10, 0);
    scene->end_time = number_or(solver, "end_time", "s", 1e-15, 1e6, 0);
    if (deck_has(solver, "end_steps"))
        scene->end_steps = deck_integer(deck_get(solver, "end_steps"), 1, 1000000000000);
    scene->safety = number_or(solver, "safety", "1", 1e-3, 10, 0.8);
    scene->damping = number_or(solver, "damping", "1/s", 0, 1e15, 0);
    scene->energy_tolerance = number_or(solver, "energy_tolerance", "1", 1e-12, 1e6, 0.01);
    read_start(scene, solver);
}

struct scene scene_read(struct deck *deck)
{
    struct scene scene = {.deck = deck, .history = 500};
    struct deck_node root = deck_root(deck);
    deck_check_sections(deck);
    read_solver(&scene, deck_get(root, "solver"));
    scene_read_entries(&scene, root);
    if (deck_has(root, "output")) scene_read_output(&scene, deck_get(root, "output"));
    return scene;
}
