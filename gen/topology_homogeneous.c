/* One phase everywhere. */
#include "memory.h"
#include "recipe.h"
#include "topology.h"

static const struct key rows[] = {
    {"phase", KEY_TEXT, offsetof(struct recipe, phase_names[PHASE_CG]),
     .form = "name of a material", .required = true, .help = "what the body is made of"},
};

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
    .deck = {.name = "homogeneous", .help = "one phase everywhere", .keys = KEYS(rows)},
    .no_cores = true,
    .fault = no_fault,
    .describe = describe,
};
