#include "statistics.h"

#include "memory.h"
#include "steps.h"

#include <math.h>
#include <stdlib.h>

/* Areas of the spherical Voronoi cells of the 26 directions over 4 pi. */
const double statistics_direction_share[3] = {0.04577789120476, 0.03698062787608, 0.03519563978232};

static bool is_counted(const struct structure *structure, int64_t node)
{
    return node >= 0 && structure->counted[node];
}

static bool is_fine(const struct structure *structure, int64_t node)
{
    return structure->phase[node] == PHASE_UFG;
}

double statistics_two_point(const struct structure *structure, int axis, int64_t lag)
{
    const struct sites *sites = structure->sites;
    const int64_t *count = sites->count;
    int64_t stride = axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1];
    int64_t n_sites = count[0] * count[1] * count[2];
    int64_t pairs = 0, both = 0;
    for (int64_t line = 0; line < n_sites; line += stride * count[axis])
        for (int64_t site = line; site < line + stride * (count[axis] - lag); site++) {
            int64_t node = sites->node[site], other = sites->node[site + stride * lag];
            if (!is_counted(structure, node) || !is_counted(structure, other)) continue;
            pairs++;
            both += is_fine(structure, node) && is_fine(structure, other);
        }
    return pairs ? (double)both / (double)pairs : NAN;
}

double statistics_profile(const struct structure *structure, int axis, int64_t i)
{
    const struct sites *sites = structure->sites;
    int64_t nodes = 0, fine = 0;
    int other[2] = {axis == 0, axis == 2 ? 1 : 2};
    int64_t at[3];
    at[axis] = i;
    for (at[other[1]] = 0; at[other[1]] < sites->count[other[1]]; at[other[1]]++)
        for (at[other[0]] = 0; at[other[0]] < sites->count[other[0]]; at[other[0]]++) {
            int64_t node = sites_at(sites, at[0], at[1], at[2]);
            if (!is_counted(structure, node)) continue;
            nodes++;
            fine += is_fine(structure, node);
        }
    return nodes ? (double)fine / (double)nodes : NAN;
}

/* Unlike pairs per pair of counted neighbours in one direction. */
static double crossings(const struct structure *structure, const int offset[3])
{
    const struct sites *sites = structure->sites;
    int64_t pairs = 0, unlike = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        if (!is_counted(structure, node)) continue;
        int64_t at[3];
        sites_index(sites, node, at);
        int64_t other = sites_at(sites, at[0] + offset[0], at[1] + offset[1], at[2] + offset[2]);
        if (!is_counted(structure, other)) continue;
        pairs++;
        unlike += is_fine(structure, node) != is_fine(structure, other);
    }
    return pairs ? (double)unlike / (double)pairs : 0;
}

struct interface statistics_interface(const struct structure *structure, bool sheet)
{
    struct interface interface = {0};
    double spacing = structure->sites->spacing;
    for (int n = 0; n < NEIGHBOURS_26; n++) {
        const int *offset = clusters_offset[n];
        if (sheet && offset[2] != 0) continue;
        int square = abs(offset[0]) + abs(offset[1]) + abs(offset[2]);
        double per_length = crossings(structure, offset) / (sqrt(square) * spacing);
        if (square == 1) interface.faces += per_length;
        /* S_V = 2 P_L, both senses of a direction share its line; in the plane L_A = pi/2 P_L. */
        interface.crofton += sheet ? M_PI / 2 / 4 * per_length
                                   : 2 * 2 * statistics_direction_share[square - 1] * per_length;
    }
    return interface;
}

enum { FURTHEST_CORE = 12 }; /* spacings */

/* 0 where the second core is too far. */
static double shell_at(const struct structure *structure, int64_t node, const struct step *steps,
                       int n_steps)
{
    const struct sites *sites = structure->sites;
    int64_t at[3];
    int32_t nearest = -1;
    double thickness = -1;
    sites_index(sites, node, at);
    for (int s = 0; s < n_steps; s++) {
        const int *offset = steps[s].offset;
        int64_t other = sites_at(sites, at[0] + offset[0], at[1] + offset[1], at[2] + offset[2]);
        if (!is_counted(structure, other) || is_fine(structure, other) ||
            structure->core[other] == nearest)
            continue;
        thickness += sqrt(steps[s].square);
        if (nearest >= 0) return thickness;
        nearest = structure->core[other];
    }
    return 0;
}

int64_t statistics_shell(const struct structure *structure, int64_t most, double *thickness)
{
    int n_steps;
    struct step *steps = steps_ball(FURTHEST_CORE, false, &n_steps);
    int64_t n_nodes = structure->sites->n_nodes, fine = 0, seen = 0, found = 0;
    for (int64_t node = 0; node < n_nodes; node++)
        fine += structure->counted[node] && is_fine(structure, node);
    int64_t stride = (fine + most - 1) / most;
    for (int64_t node = 0; node < n_nodes; node++) {
        if (!structure->counted[node] || !is_fine(structure, node) || seen++ % stride != 0)
            continue;
        double here = shell_at(structure, node, steps, n_steps);
        if (here > 0) thickness[found++] = here;
    }
    free(steps);
    return found;
}
