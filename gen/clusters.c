#include "clusters.h"

#include "forest.h"
#include "memory.h"
#include "steps.h"

#include <math.h>
#include <stdlib.h>

const int clusters_offset[NEIGHBOURS_26][3] = {
    {1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0}, {1, 0, 1},   {1, 0, -1},
    {0, 1, 1}, {0, 1, -1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1},
};

static bool is_member(const struct structure *structure, int64_t node, int phase)
{
    return node >= 0 && structure->counted[node] && structure->phase[node] == phase;
}

static void join_neighbours(const struct structure *structure, int phase, int half,
                            struct forest *forest)
{
    const struct sites *sites = structure->sites;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        if (!is_member(structure, node, phase)) continue;
        int64_t at[3];
        sites_index(sites, node, at);
        for (int n = 0; n < half; n++) {
            const int *offset = clusters_offset[n];
            const int64_t to[3] = {at[0] + offset[0], at[1] + offset[1], at[2] + offset[2]};
            const int64_t other = sites_at(sites, to[0], to[1], to[2]);
            if (!is_member(structure, other, phase)) continue;
            int32_t around[3];
            for (int axis = 0; axis < 3; axis++)
                around[axis] = (int32_t)sites_around(sites, axis, to[axis]);
            forest_join(forest, (int32_t)node, (int32_t)other, around);
        }
    }
}

/* Where the first and the last layer of the counted region end, inwards, along each axis of the
 * body; a layer is as thick as a cell is wide in that direction. */
static void counted_ends(const struct structure *structure, double end[2][3])
{
    const struct sites *sites = structure->sites;
    const double *edge = sites->spacing, c = fabs(sites->turn[0]), s = fabs(sites->turn[1]);
    const double width[3] = {c * edge[0] + s * edge[1], s * edge[0] + c * edge[1], edge[2]};
    for (int axis = 0; axis < 3; axis++) {
        end[0][axis] = INFINITY;
        end[1][axis] = -INFINITY;
    }
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        if (!structure->counted[node]) continue;
        double at[3];
        sites_in_body(sites, node, at);
        for (int axis = 0; axis < 3; axis++) {
            end[0][axis] = fmin(end[0][axis], at[axis] + (1 - 1e-6) * width[axis]);
            end[1][axis] = fmax(end[1][axis], at[axis] - (1 - 1e-6) * width[axis]);
        }
    }
}

/* Ends that the node takes part in, a bit an end and axis.  Along a periodic axis there are none:
 * there a way around the body counts as both. */
static unsigned ends_at(const struct structure *structure, const struct forest *forest,
                        int64_t node, double end[2][3])
{
    double at[3];
    unsigned ends = 0;
    sites_in_body(structure->sites, node, at);
    for (int axis = 0; axis < 3; axis++) {
        const unsigned bit = 1u << 2 * axis;
        if (structure->sites->periodic[axis]) {
            ends |= forest->closed[node][axis] ? 3 * bit : 0;
            continue;
        }
        ends |= at[axis] < end[0][axis] ? bit : 0;
        ends |= at[axis] > end[1][axis] ? 2 * bit : 0;
    }
    return ends;
}

bool clusters_percolate_everywhere(const struct clusters *clusters)
{
    return clusters->percolates[0] && clusters->percolates[1] && clusters->percolates[2];
}

struct clusters clusters_find(const struct structure *structure, int phase,
                              enum neighbourhood neighbourhood)
{
    struct clusters clusters = {0};
    int64_t n_nodes = structure->sites->n_nodes;
    const bool *periodic = structure->sites->periodic;
    struct forest forest = forest_new(n_nodes, periodic[0] || periodic[1] || periodic[2]);
    int32_t *size = memory_new((size_t)n_nodes, sizeof *size);
    uint8_t *reaches = memory_new((size_t)n_nodes, sizeof *reaches);
    join_neighbours(structure, phase, (int)neighbourhood, &forest);
    double end[2][3];
    counted_ends(structure, end);
    for (int64_t node = 0; node < n_nodes; node++) {
        if (!is_member(structure, node, phase)) continue;
        int32_t root = forest_root(&forest, (int32_t)node);
        clusters.nodes++;
        clusters.count += size[root]++ == 0;
        clusters.largest = size[root] > clusters.largest ? size[root] : clusters.largest;
        reaches[root] |= (uint8_t)ends_at(structure, &forest, node, end);
        for (int axis = 0; axis < 3; axis++)
            if ((reaches[root] >> (2 * axis) & 3) == 3) clusters.percolates[axis] = true;
    }
    forest_free(&forest);
    free(size);
    free(reaches);
    return clusters;
}

/* Whether all six neighbours of a coarse node belong to its core. */
static bool is_buried(const struct structure *structure, int64_t node, const int64_t at[3])
{
    for (int n = 0; n < 6; n++) {
        const int *offset = clusters_offset[n % 3];
        int sign = n < 3 ? 1 : -1;
        const int64_t to[3] = {at[0] + sign * offset[0], at[1] + sign * offset[1],
                               at[2] + sign * offset[2]};
        const int64_t other = sites_at(structure->sites, to[0], to[1], to[2]);
        if (!is_member(structure, other, PHASE_CG) ||
            !structure_one_core(structure, node, other, to))
            return false;
    }
    return true;
}

struct contact clusters_contact(const struct structure *structure, int limit)
{
    const struct sites *sites = structure->sites;
    const bool flat = sites->count[2] == 1;
    const double furthest = limit * steps_unit(sites->spacing, flat);
    int n_steps;
    struct step *steps =
        steps_ball(sites->spacing, furthest + steps_longest_edge(sites->spacing, flat), true, flat,
                   STEPS_BY_FILM, &n_steps);
    struct contact contact = {.film = INFINITY};
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        if (!is_member(structure, node, PHASE_CG)) continue;
        int64_t at[3];
        sites_index(sites, node, at);
        /* Neighbours are all counted; beyond them only what is nearer than known.  From a buried
         * node its neighbour one step on, along the shortest edge that the step has, is nearer to
         * whatever lies beyond, and the film is thinner: the direction turns to longer edges. */
        const bool buried = is_buried(structure, node, at);
        for (int s = 0; s < n_steps; s++) {
            const double film = steps_film(&steps[s]);
            const bool touch = steps_touch(&steps[s]);
            if (!touch && (buried || film >= contact.film || film > furthest)) break;
            const int *offset = steps[s].offset;
            const int64_t to[3] = {at[0] + offset[0], at[1] + offset[1], at[2] + offset[2]};
            const int64_t other = sites_at(sites, to[0], to[1], to[2]);
            if (!is_member(structure, other, PHASE_CG) ||
                structure_one_core(structure, node, other, to))
                continue;
            contact.touching += touch;
            contact.film = fmin(contact.film, film);
        }
    }
    free(steps);
    return contact;
}
