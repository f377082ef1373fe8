/* A random bimodal structure.
 *
 * cell: Voronoi cells of independent uniform points become coarse in random order; in an exact
 * match the last one is cut by a surface parallel to its faces.
 *
 * sphere: overlapping equal spheres at independent uniform points (Boolean model): the fine phase
 * is what none of them covers, phi_U = exp(-rho v) (Torquato, Random Heterogeneous Materials, 2002,
 * section 5.1), which sets the number density rho.
 *
 * Whether the phases are connected is found and said, and asked for where the deck requires it: to
 * keep those samples alone in which they are is to choose.  A sheet shows the middle section of
 * such a structure; phases are not asked to be connected in it. */
#include "findings.h"
#include "memory.h"
#include "recipe.h"
#include "requirements.h"
#include "topology.h"

#include <math.h>

static const struct key rows[] = {
    {"core_distance", KEY_SPACINGS, offsetof(struct recipe, distance), .low = 1,
     .high = LONGEST_DISTANCE, .usual = NAN,
     .help = "cube root of the cells' mean volume; required of cells without cores"},
    {"core_diameter", KEY_SPACINGS, offsetof(struct recipe, diameter), .low = 1,
     .high = LONGEST_DISTANCE, .usual = NAN,
     .help = "of the spheres, required without cores; their number follows from ufg_fraction"},
};

static void check(struct deck_node domain, struct recipe *recipe)
{
    if (recipe->cores_file) return;
    const bool sphere = recipe->shape == CORE_SPHERE;
    struct deck_node other = deck_find(domain, sphere ? "core_distance" : "core_diameter");
    if (other.index && sphere)
        deck_error(other, "random spheres take core_diameter; their number follows from "
                          "ufg_fraction");
    if (other.index)
        deck_error(other, "random cells take core_distance, the cube root of their mean volume");
    deck_get(domain, sphere ? "core_diameter" : "core_distance"); /* dies where it is missing */
}

static struct cores place(const struct recipe *recipe)
{
    const struct cores_box box = recipe_box(recipe);
    if (recipe->shape == CORE_CELL) {
        double density = 1 / (recipe->distance * recipe->distance * recipe->distance);
        return cores_random(CORE_CELL, density, 4 * recipe->distance, &box, recipe->seed);
    }
    double volume = M_PI / 6 * recipe->diameter * recipe->diameter * recipe->diameter;
    double density = -log(recipe->ufg_fraction) / volume;
    return cores_random(CORE_SPHERE, density, 2 * recipe->diameter, &box, recipe->seed);
}

static int64_t score(const struct recipe *recipe, const struct cores *cores, const double point[3],
                     int32_t *core)
{
    int with_depth = cores->shape == CORE_CELL && !recipe->geometric;
    struct core_place at = cores_place(cores, point, with_depth);
    *core = (int32_t)at.core;
    double unit = SCORE_UNIT * recipe->specimen.spacing[0];
    if (cores->shape == CORE_SPHERE) return llround(at.distance / unit);
    if (!with_depth) return cores->order[at.core];
    /* Deeper nodes first; no depth fills the gap between two cells' scores. */
    const int64_t gap = INT64_C(1000000000000);
    return cores->order[at.core] * gap - (int64_t)fmin(round(at.depth / unit), 1e12 - 1);
}

static char *fault(const struct recipe *recipe, const struct findings *findings)
{
    /* Of two phases in a plane one at most can connect opposite sides both ways. */
    if (specimen_is_sheet(&recipe->specimen)) return NULL;
    const bool cg =
        !(recipe->require & REQUIRE_CG_CONNECTED) || clusters_percolate_everywhere(&findings->cg);
    const bool ufg =
        !(recipe->require & REQUIRE_UFG_CONNECTED) || clusters_percolate_everywhere(&findings->ufg);
    if (cg && ufg) return NULL;
    return memory_print("not what the deck requires: %s%s%s must percolate along x, y and z "
                        "and %s not; use smaller cells or cores (core_distance, core_diameter) or "
                        "another seed",
                        cg ? "" : recipe->phase_names[PHASE_CG], cg || ufg ? "" : " and ",
                        ufg ? "" : recipe->phase_names[PHASE_UFG], cg || ufg ? "does" : "do");
}

static char *describe(const struct recipe *recipe, const struct findings *findings)
{
    if (recipe->shape == CORE_SPHERE)
        return memory_print("random bimodal, overlapping spheres of %.6g um",
                            2e6 * findings->reach);
    return memory_print("random bimodal, randomly labelled Voronoi cells");
}

const struct topology topology_random = {
    .deck = {.name = "random",
             .help = "cells or spheres at independent uniform places",
             .keys = KEYS(rows)},
    .check = check,
    .place = place,
    .score = score,
    .fault = fault,
    .describe = describe,
};
