/* Layers of both phases across x, by turns: the coarse ones about the multiples of core_distance.
 */
#include "memory.h"
#include "recipe.h"
#include "topology.h"

#include <math.h>

static const struct key rows[] = {
    {"core_distance", KEY_SPACINGS, offsetof(struct recipe, distance), .low = 1,
     .high = LONGEST_DISTANCE, .required = true, .help = "of the middles of coarse layers"},
};

static struct cores place(const struct recipe *recipe)
{
    const struct cores_box box = recipe_box(recipe);
    return cores_lattice(LATTICE_SC, CORE_CELL, recipe->distance, 0, &box, recipe->seed);
}

static int64_t score(const struct recipe *recipe, const struct cores *cores, const double point[3],
                     int32_t *core)
{
    (void)cores;
    *core = (int32_t)lround(point[0] / recipe->distance);
    return llround(fabs(point[0] - *core * recipe->distance) /
                   (SCORE_UNIT * recipe->specimen.spacing[0]));
}

static char *no_fault(const struct recipe *recipe, const struct findings *findings)
{
    (void)recipe, (void)findings;
    return NULL;
}

static char *describe(const struct recipe *recipe, const struct findings *findings)
{
    (void)findings;
    return memory_print("layers %.6g um apart", 1e6 * recipe->distance);
}

const struct topology topology_layers = {
    .deck = {.name = "layers", .help = "layers of both phases by turns", .keys = KEYS(rows)},
    .place = place,
    .score = score,
    .fault = no_fault,
    .describe = describe,
};
