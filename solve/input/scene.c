#include "scene.h"

#include "equilibrium.h"
#include "family.h"
#include "sections.h"

#include <math.h>

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

/* Keys of every solver, and those that only some have. */
#define COMMON_KEYS                                                                                \
    "type", "horizon", "influence", "stabilisation", "plane", "volumes", "surface_correction",     \
        "end_strain", "end_time", "end_steps", "end_load"
#define EXPLICIT_KEYS "safety", "damping", "local_damping", "mass_scaling", "energy_tolerance"
#define STATIC_KEYS                                                                                \
    "method", "first_step", "step", "tolerance", "smallest_step", "most_evaluations",              \
        "break_at_once"
static const char *const explicit_keys[] = {COMMON_KEYS, EXPLICIT_KEYS, "start", "ramp", NULL};
static const char *const static_keys[] = {COMMON_KEYS, STATIC_KEYS, NULL};
static const char *const hybrid_keys[] = {
    COMMON_KEYS,       EXPLICIT_KEYS, STATIC_KEYS, "explicit_when",
    "explicit_strain", "static_when", NULL};

static const struct {
    const char *name;
    const char *const *keys;
} types[SOLVER_TYPES] = {
    {"explicit", explicit_keys}, {"quasi_static", static_keys}, {"hybrid", hybrid_keys}};

static void read_type(struct scene *scene, struct deck_node solver)
{
    const char *names[SOLVER_TYPES];
    for (int k = 0; k < SOLVER_TYPES; k++) names[k] = types[k].name;
    scene->type = SOLVER_QUASI_STATIC;
    if (deck_has(solver, "type"))
        scene->type = (enum scene_type)deck_choice(deck_get(solver, "type"), names, SOLVER_TYPES);
    deck_keys(solver, types[scene->type].keys);
}

static void read_body(struct scene *scene, struct deck_node solver)
{
    static const char *const volumes[] = {"whole", "partial"}, *const planes[] = {"stress",
                                                                                  "strain"};
    if (deck_has(solver, "horizon"))
        scene->horizon = deck_number(deck_get(solver, "horizon"), "1", 1, 8);
    scene->influence = -1;
    if (deck_has(solver, "influence"))
        scene->influence =
            deck_choice(deck_get(solver, "influence"), family_influences, family_influence_count);
    scene->solver = solver;
    if (deck_has(solver, "volumes"))
        scene->partial_volumes = deck_choice(deck_get(solver, "volumes"), volumes, 2) == 1;
    if (deck_has(solver, "plane"))
        scene->plane =
            deck_choice(deck_get(solver, "plane"), planes, 2) ? PLANE_STRAIN : PLANE_STRESS;
}

static void read_end(struct scene *scene, struct deck_node solver)
{
    if (deck_has(solver, "end_strain") + deck_has(solver, "end_time") +
            deck_has(solver, "end_steps") !=
        1)
        deck_error(solver, "give one of end_strain, end_time and end_steps");
    scene->end_strain = number_or(solver, "end_strain", "1", 1e-9, 10, 0);
    scene->end_time = number_or(solver, "end_time", "s", 1e-15, 1e12, 0);
    scene->end_load = number_or(solver, "end_load", "1", 0, 1, 0);
    if (deck_has(solver, "end_steps"))
        scene->end_steps = deck_integer(deck_get(solver, "end_steps"), 1, 1000000000000);
}

/* A key's number in the unit of load steps; deck_number wants a literal. */
static double step_or(struct scene *scene, const char *key, double fallback)
{
    if (scene->end_strain > 0) return number_or(scene->solver, key, "1", 1e-12, 10, fallback);
    return number_or(scene->solver, key, "s", 1e-15, 1e12, fallback);
}

static void read_static(struct scene *scene, struct deck_node solver)
{
    struct scene_static *statics = &scene->statics;
    const double usual = scene->end_strain > 0 ? 0.005
                         : scene->end_time > 0 ? scene->end_time / 100
                                               : 1;
    statics->largest_step = step_or(scene, "step", usual);
    /* Three records lie where the elastic slope of the softest metals is measured; steps of loads are all alike. */
    const double first =
        scene->end_strain > 0 ? fmin(5e-6, statics->largest_step) : statics->largest_step;
    statics->first_step = step_or(scene, "first_step", first);
    statics->smallest_step =
        step_or(scene, "smallest_step", fmin(1e-4 * statics->largest_step, statics->first_step));
    if (statics->first_step > statics->largest_step)
        deck_error(deck_get(solver, "first_step"), "%g is over the largest step, %g",
                   statics->first_step, statics->largest_step);
    if (statics->smallest_step > statics->first_step)
        deck_error(deck_get(solver, "smallest_step"), "%g is over the first step, %g",
                   statics->smallest_step, statics->first_step);
    statics->tolerance = number_or(solver, "tolerance", "1", 1e-10, 1e-2, 1e-6);
    if (deck_has(solver, "method"))
        statics->method =
            deck_choice(deck_get(solver, "method"), equilibrium_methods, equilibrium_method_count);
    statics->most_evaluations = equilibrium_usual_evaluations(statics->method);
    if (deck_has(solver, "most_evaluations"))
        statics->most_evaluations =
            deck_integer(deck_get(solver, "most_evaluations"), 10, 1000000000);
    statics->break_at_once = 10;
    if (deck_has(solver, "break_at_once"))
        statics->break_at_once =
            (double)deck_integer(deck_get(solver, "break_at_once"), 1, 1000000000);
}

static void read_hybrid(struct scene *scene, struct deck_node solver)
{
    static const char *const events[] = {"damage", "maximum_load"};
    struct scene_hybrid *hybrid = &scene->hybrid;
    hybrid->strain = number_or(solver, "explicit_strain", "1", 0, 10, INFINITY);
    if (deck_has(solver, "explicit_when")) {
        struct deck_node list = deck_get(solver, "explicit_when");
        for (int i = 0; i < deck_count(list); i++)
            *(deck_choice(deck_item(list, i), events, 2) == 0 ? &hybrid->at_damage
                                                              : &hybrid->at_maximum) = true;
    }
    if (!deck_has(solver, "static_when")) return;
    struct deck_node back = deck_get(solver, "static_when");
    deck_keys(back, (const char *const[]){"kinetic_to_internal", "quiet", NULL});
    hybrid->kinetic_share = deck_number(deck_get(back, "kinetic_to_internal"), "1", 1e-12, 1);
    hybrid->quiet = deck_number(deck_get(back, "quiet"), "s", 0, 1e6);
}

static void read_solver(struct scene *scene, struct deck_node solver)
{
    read_type(scene, solver);
    read_body(scene, solver);
    read_end(scene, solver);
    scene->safety = number_or(solver, "safety", "1", 1e-3, 10, 0.8);
    scene->local_damping = number_or(solver, "local_damping", "1", 0, 0.95, 0);
    scene->mass_scaling = number_or(solver, "mass_scaling", "1", 1e-6, 1e12, 1);
    scene->damping = number_or(solver, "damping", "1/s", 0, 1e15, 0);
    scene->energy_tolerance = number_or(solver, "energy_tolerance", "1", 1e-12, 1e6, 0.01);
    read_start(scene, solver);
    if (scene->type != SOLVER_EXPLICIT) read_static(scene, solver);
    if (scene->type == SOLVER_HYBRID) read_hybrid(scene, solver);
}

struct scene scene_read(struct deck *deck)
{
    struct scene scene = {.deck = deck, .history = 500};
    struct deck_node root = deck_root(deck);
    sections_read(deck);
    read_solver(&scene, deck_get(root, "solver"));
    scene_read_entries(&scene, root);
    if (deck_has(root, "output")) scene_read_output(&scene, deck_get(root, "output"));
    return scene;
}
