/* One phase everywhere. */
#include "memory.h"
#include "recipe.h"
#include "topology.h"

static const char *const keys[] = {"specimen", "dimensions", "size", "spacing",
                                   "topology", "phase",      "seed", "grips",
                                   "gauge",    "sets",       NULL};

static void read_keys(struct deck_node domain, struct recipe *recipe)
{
    recipe->phase_names[PHASE_CG] = deck_string(deck_get(domain, "phase"));
    recipe->n_phases = 1;
}

static char *no_fault(const struct recipe *recipe, const struct findings *findings)
{
    (void)recipe, (void)findings;
    return NULL;
}

static char *describe(const struct recipe *recipe, const struct findings *findings)
{
    (void)findings;
    return memory_print("homogeneous, %s", recipe->phase_names[PHASE_CG]);
}

const struct topology topology_homogeneous = {
    .name = "homogeneous",
    .single_phase = true,
    .keys = keys,
    .read = read_keys,
    .fault = no_fault,
    .describe = describe,
};
