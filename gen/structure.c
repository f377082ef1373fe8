#include "structure.h"

#include "die.h"
#include "memory.h"
#include "topology.h"

#include <stdlib.h>

enum { LONG_WORK = 2000000 }; /* nodes from which on the progress is told */

static void tell_progress(int64_t node, int64_t n_nodes)
{
    if (n_nodes >= LONG_WORK && node % (n_nodes / 10) == 0)
        note("ranking nodes: %.0f %%", 100 * (double)node / (double)n_nodes);
}

static void rank_nodes(const struct recipe *recipe, const struct cores *cores,
                       struct structure *structure)
{
    const struct sites *sites = structure->sites;
    int64_t n_nodes = sites->n_nodes;
    int64_t *score = memory_new((size_t)n_nodes, sizeof *score);
    for (int64_t node = 0; node < n_nodes; node++) {
        double position[3];
        tell_progress(node, n_nodes);
        sites_in_body(sites, node, position);
        score[node] = recipe->topology->score(recipe, cores, position, &structure->core[node]);
    }
    double coarse = 1 - recipe->ufg_fraction;
    const struct ranks ranks = {n_nodes, score, sites->site, structure->counted, sites->volume};
    structure->threshold = recipe->geometric ? fraction_geometric(&ranks, coarse)
                                             : fraction_exact(&ranks, coarse, recipe->seed);
    for (int64_t node = 0; node < n_nodes; node++)
        structure->phase[node] =
            fraction_is_coarse(&structure->threshold, score[node], sites->site[node]) ? PHASE_CG
                                                                                      : PHASE_UFG;
    free(score);
}

static void take_voxels(const struct recipe *recipe, struct structure *structure)
{
    const struct sites *sites = structure->sites;
    if (recipe->voxels.grain)
        structure->grain = memory_new((size_t)sites->n_nodes, sizeof *structure->grain);
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        double position[3];
        sites_position(sites, node, position);
        const struct voxel here = recipe_voxel(recipe, position);
        if (here.phase == VOXEL_OUTSIDE) continue; /* a grip */
        structure->phase[node] = (uint8_t)here.phase;
        if (structure->grain) structure->grain[node] = here.grain;
    }
}

struct structure structure_new(const struct recipe *recipe, const struct sites *sites,
                               const struct cores *cores)
{
    struct structure structure = {.sites = sites, .cores = cores};
    size_t n_nodes = (size_t)sites->n_nodes;
    structure.counted = specimen_counted(&recipe->specimen, sites);
    structure.phase = memory_new(n_nodes, sizeof *structure.phase);
    structure.core = memory_new(n_nodes, sizeof *structure.core);
    if (!recipe->topology->no_cores) rank_nodes(recipe, cores, &structure);
    if (recipe->voxels.phase) take_voxels(recipe, &structure);
    if (recipe->grip_phase >= 0)
        for (size_t node = 0; node < n_nodes; node++)
            if (!structure.counted[node]) structure.phase[node] = (uint8_t)recipe->grip_phase;
    return structure;
}

void structure_free(struct structure *structure)
{
    free(structure->counted);
    free(structure->phase);
    free(structure->grain);
    free(structure->core);
    *structure = (struct structure){0};
}

bool structure_one_core(const struct structure *structure, int64_t node, int64_t other,
                        const int64_t at[3])
{
    const int32_t a = structure->core[node], b = structure->core[other];
    const struct cores *cores = structure->cores;
    if (!cores || !cores->original) return a == b;
    bool same = cores->original[a] == cores->original[b];
    for (int axis = 0; axis < 3; axis++)
        same = same && cores->image[a][axis] ==
                           cores->image[b][axis] + sites_around(structure->sites, axis, at[axis]);
    return same;
}

double structure_reach(const struct structure *structure)
{
    return (double)structure->threshold.score * SCORE_UNIT * structure->sites->spacing[0];
}
