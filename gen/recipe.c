#include "recipe.h"

#include "die.h"
#include "sections.h"
#include "topology.h"

#include <string.h>

static const char *const shapes[] = {"cell", "sphere"};
static const char *const matches[] = {"exact", "geometric"};
static const char *const phase_keys[] = {"cg", "ufg", NULL};

const struct topology *const topologies[] = {&topology_harmonic, &topology_random,
                                             &topology_homogeneous, NULL};
enum { N_TOPOLOGIES = sizeof topologies / sizeof *topologies - 1 };

static void read_phases(struct deck_node domain, struct recipe *recipe)
{
    struct deck_node phases = deck_get(domain, "phases");
    deck_keys(phases, phase_keys);
    recipe->phase_names[PHASE_CG] = deck_string(deck_get(phases, "cg"));
    recipe->phase_names[PHASE_UFG] = deck_string(deck_get(phases, "ufg"));
    recipe->n_phases = 2;
    if (strcmp(recipe->phase_names[PHASE_CG], recipe->phase_names[PHASE_UFG]) == 0)
        deck_error(phases, "the two phases need two names");
}

/* What both two-phase topologies share. */
static void read_two_phases(struct deck_node domain, struct recipe *recipe)
{
    read_phases(domain, recipe);
    recipe->ufg_fraction = deck_number(deck_get(domain, "ufg_fraction"), "1", 1e-6, 1 - 1e-6);
    recipe->shape = CORE_CELL;
    if (deck_has(domain, "core"))
        recipe->shape = (enum core_shape)deck_choice(deck_get(domain, "core"), shapes, 2);
    if (deck_has(domain, "match"))
        recipe->geometric = deck_choice(deck_get(domain, "match"), matches, 2) == 1;
    if (deck_has(domain, "override")) recipe->override = deck_bool(deck_get(domain, "override"));
    if (!deck_has(domain, "cores")) return;
    recipe->cores_file = deck_string(deck_get(domain, "cores"));
    static const char *const said[] = {"lattice", "core", "core_distance", "core_diameter",
                                       "jitter"};
    for (size_t i = 0; i < sizeof said / sizeof *said; i++)
        if (deck_has(domain, said[i]))
            deck_error(deck_get(domain, said[i]), "%s says this already: leave out '%s' or 'cores'",
                       recipe->cores_file, said[i]);
}

/* The grips' phase is one of the structure's, or a further material of the deck. */
static void read_grip_phase(struct deck_node domain, struct deck_node root, struct recipe *recipe)
{
    const char *name = recipe->specimen.grip_phase;
    recipe->grip_phase = -1;
    if (!name) return;
    for (int phase = 0; phase < recipe->n_phases; phase++)
        if (strcmp(recipe->phase_names[phase], name) == 0) recipe->grip_phase = phase;
    if (recipe->grip_phase >= 0) return;
    struct deck_node where = deck_get(deck_get(domain, "grips"), "phase");
    struct deck_node materials = deck_find(root, "materials");
    if (materials.index == 0 || !deck_has(materials, name))
        deck_error(where,
                   "'%s' is neither 'structure' nor one of this domain's phases nor a material of "
                   "this deck",
                   name);
    recipe->phase_names[recipe->n_phases] = name;
    recipe->grip_phase = recipe->n_phases++;
}

struct recipe recipe_read(const struct deck *deck)
{
    sections_read(deck);
    struct deck_node root = deck_root(deck);
    struct deck_node domain = deck_get(root, "domain");
    const char *names[N_TOPOLOGIES];
    for (int i = 0; i < N_TOPOLOGIES; i++) names[i] = topologies[i]->name;
    int choice = deck_choice(deck_get(domain, "topology"), names, N_TOPOLOGIES);
    struct recipe recipe = {.topology = topologies[choice], .seed = 1};
    deck_keys(domain, recipe.topology->keys);
    recipe.specimen = specimen_read(domain);
    if (deck_has(domain, "seed"))
        recipe.seed = deck_integer(deck_get(domain, "seed"), 0, INT32_MAX);
    if (!recipe.topology->single_phase) read_two_phases(domain, &recipe);
    recipe.topology->read(domain, &recipe);
    read_grip_phase(domain, root, &recipe);
    recipe.sets = deck_find(domain, "sets");
    return recipe;
}

struct cores recipe_cores(struct recipe *recipe)
{
    if (recipe->topology->single_phase) return (struct cores){0};
    if (!recipe->cores_file) return recipe->topology->place(recipe);
    struct cores cores = cores_read(recipe->cores_file, recipe->topology->name);
    double extent[3];
    specimen_extent(&recipe->specimen, extent);
    for (int axis = 0; axis < 3; axis++)
        if (extent[axis] > cores.size[axis] * (1 + 1e-9))
            die_user("%s: the cores are for a body of %g x %g x %g m, the deck's is larger",
                     recipe->cores_file, cores.size[0], cores.size[1], cores.size[2]);
    if (cores.distance < recipe->specimen.spacing ||
        cores.distance > LONGEST_DISTANCE * recipe->specimen.spacing)
        die_user("%s: distance_m %g is not between 1 and %g spacings", recipe->cores_file,
                 cores.distance, LONGEST_DISTANCE);
    recipe->shape = cores.shape;
    recipe->distance = cores.distance;
    return cores;
}
