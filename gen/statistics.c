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

double statistics_two_point(const struct structure *structure, int phase, int axis, int64_t lag)
{
    const struct sites *sites = structure->sites;
    const int64_t *count = sites->count;
    int64_t stride = axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1];
    int64_t n_sites = count[0] * count[1] * count[2];
    int64_t pairs = 0, both = 0;
    const int64_t last = sites->periodic[axis] ? count[axis] : count[axis] - lag;
    if (sites->periodic[axis]) lag %= count[axis];
    for (int64_t line = 0; line < n_sites; line += stride * count[axis])
        for (int64_t site = line; site < line + stride * last; site++) {
            int64_t to = site + stride * lag;
            if (to >= line + stride * count[axis]) to -= stride * count[axis];
            int64_t node = sites->node[site], other = sites->node[to];
            if (!is_counted(structure, node) || !is_counted(structure, other)) continue;
            pairs++;
            both += structure->phase[node] == phase && structure->phase[other] == phase;
        }
    return pairs ? (double)both / (double)pairs : NAN;
}

double statistics_profile(const struct structure *structure, int phase, int axis, int64_t i)
{
    const struct sites *sites = structure->sites;
    int64_t nodes = 0, found = 0;
    int other[2] = {axis == 0, axis == 2 ? 1 : 2};
    int64_t at[3];
    at[axis] = i;
    for (at[other[1]] = 0; at[other[1]] < sites->count[other[1]]; at[other[1]]++)
        for (at[other[0]] = 0; at[other[0]] < sites->count[other[0]]; at[other[0]]++) {
            int64_t node = sites_at(sites, at[0], at[1], at[2]);
            if (!is_counted(structure, node)) continue;
            nodes++;
            found += structure->phase[node] == phase;
        }
    return nodes ? (double)found / (double)nodes : NAN;
}

/* The node next to another one, across a plane of symmetry that of which it is the image. */
static int64_t neighbour(const struct sites *sites, int64_t node, const int offset[3], int sense)
{
    int64_t at[3];
    sites_index(sites, node, at);
    for (int axis = 0; axis < 3; axis++) {
        at[axis] += sense * offset[axis];
        if (sites->mirrored[axis] && 2 * at[axis] < sites->count[axis])
            at[axis] = sites->count[axis] - 1 - at[axis];
    }
    return sites_at(sites, at[0], at[1], at[2]);
}

/* Unlike pairs per pair of counted neighbours in one direction; where there are planes of symmetry
 * in either sense, of which one leads across them. */
static double crossings(const struct structure *structure, const int offset[3])
{
    const struct sites *sites = structure->sites;
    const bool *planes = sites->mirrored, both = planes[0] || planes[1] || planes[2];
    int64_t pairs = 0, unlike = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++)
        for (int sense = 1; is_counted(structure, node) && sense >= (both ? -1 : 1); sense -= 2) {
            const int64_t other = neighbour(sites, node, offset, sense);
            if (!is_counted(structure, other)) continue;
            pairs++;
            unlike += structure->phase[node] != structure->phase[other];
        }
    return pairs ? (double)unlike / (double)pairs : 0;
}

/* One octant of the sphere in equal parts; the others are its images. */
static void count_directions(const double spacing[3], double share[NEIGHBOURS_26])
{
    enum { PARTS = 1000 };
    double unit[NEIGHBOURS_26][3],
        counted[2][2][2] = {0}; /* of the directions with these components */
    for (int n = 0; n < NEIGHBOURS_26; n++)
        for (int axis = 0; axis < 3; axis++)
            unit[n][axis] = clusters_offset[n][axis] * spacing[axis] / spacing[0] /
                            steps_to(spacing, clusters_offset[n]).distance;
    for (int p = 0; p < PARTS * PARTS; p++) {
        const double z = (p / PARTS + 0.5) / PARTS, turn = M_PI / 2 * (p % PARTS + 0.5) / PARTS;
        const double at[3] = {sqrt(1 - z * z) * cos(turn), sqrt(1 - z * z) * sin(turn), z};
        double best = 0;
        int nearest = 0;
        for (int n = 0; n < NEIGHBOURS_26; n++) {
            const double cosine = at[0] * unit[n][0] + at[1] * unit[n][1] + at[2] * unit[n][2];
            if (cosine > best) nearest = n;
            best = fmax(best, cosine);
        }
        const int *offset = clusters_offset[nearest];
        counted[offset[0] != 0][offset[1] != 0][offset[2] != 0]++;
    }
    for (int n = 0; n < NEIGHBOURS_26; n++) {
        const int *o = clusters_offset[n];
        const int alike = (o[0] ? 2 : 1) * (o[1] ? 2 : 1) * (o[2] ? 2 : 1);
        share[n] = counted[o[0] != 0][o[1] != 0][o[2] != 0] / (alike * (double)PARTS * PARTS);
    }
}

void statistics_direction_shares(const double spacing[3], double share[NEIGHBOURS_26])
{
    const bool cube = spacing[1] == spacing[0] && spacing[2] == spacing[0];
    if (!cube) count_directions(spacing, share);
    for (int n = 0; n < NEIGHBOURS_26 && cube; n++) {
        const int *offset = clusters_offset[n];
        share[n] = statistics_direction_share[abs(offset[0]) + abs(offset[1]) + abs(offset[2]) - 1];
    }
}

struct interface statistics_interface(const struct structure *structure, bool sheet)
{
    struct interface interface = {0};
    const double *spacing = structure->sites->spacing;
    const double slope = atan2(spacing[1], spacing[0]); /* of the diagonal, pi/4 of squares */
    double share[NEIGHBOURS_26];
    if (!sheet) statistics_direction_shares(spacing, share);
    for (int n = 0; n < NEIGHBOURS_26; n++) {
        const int *offset = clusters_offset[n];
        if (sheet && offset[2] != 0) continue;
        double per_length =
            crossings(structure, offset) / (steps_to(spacing, offset).distance * spacing[0]);
        const bool face = abs(offset[0]) + abs(offset[1]) + abs(offset[2]) == 1;
        if (face) interface.faces += per_length;
        /* S_V = 2 P_L, both senses of a direction share its line; in the plane L_A = pi/2 P_L, and
         * a direction's share of the half turn is half of the angles to the next ones. */
        const double turn = !face ? M_PI / 4 : offset[0] ? slope : M_PI / 2 - slope;
        interface.crofton +=
            sheet ? M_PI / 2 * turn / M_PI * per_length : 2 * 2 * share[n] * per_length;
    }
    return interface;
}

enum { FURTHEST_CORE = 12 }; /* edges of a cube of the cell's volume */

/* A node, or an image of it, and where it was met. */
struct place {
    int64_t node, at[3];
};

static struct place place_at(const struct sites *sites, const int64_t from[3], const int offset[3])
{
    struct place place = {-1, {from[0] + offset[0], from[1] + offset[1], from[2] + offset[2]}};
    place.node = sites_at(sites, place.at[0], place.at[1], place.at[2]);
    return place;
}

static bool in_one_core(const struct structure *structure, const struct place *a,
                        const struct place *b)
{
    /* Both moved back into the body together, so that the first lies in it. */
    int64_t at[3];
    for (int axis = 0; axis < 3; axis++)
        at[axis] = b->at[axis] - structure->sites->count[axis] *
                                     sites_around(structure->sites, axis, a->at[axis]);
    return structure_one_core(structure, a->node, b->node, at);
}

/* 0 where the second core is too far. */
static double shell_at(const struct structure *structure, int64_t node, const struct step *steps,
                       int n_steps)
{
    const struct sites *sites = structure->sites;
    int64_t at[3];
    const struct step *first = NULL;
    struct place nearest = {0};
    sites_index(sites, node, at);
    for (int s = 0; s < n_steps; s++) {
        const int *offset = steps[s].offset;
        const struct place there = place_at(sites, at, offset);
        if (!is_counted(structure, there.node) || is_fine(structure, there.node) ||
            (first && in_one_core(structure, &nearest, &there)))
            continue;
        if (first) {
            const int across[3] = {offset[0] - first->offset[0], offset[1] - first->offset[1],
                                   offset[2] - first->offset[2]};
            return first->distance - steps_to(sites->spacing, across).edge + steps[s].distance;
        }
        first = &steps[s];
        nearest = there;
    }
    return 0;
}

int64_t statistics_shell(const struct structure *structure, int64_t most, double *thickness)
{
    const struct sites *sites = structure->sites;
    const bool flat = sites->count[2] == 1;
    int n_steps;
    struct step *steps =
        steps_ball(sites->spacing, FURTHEST_CORE * steps_unit(sites->spacing, flat), false, flat,
                   STEPS_BY_DISTANCE, &n_steps);
    int64_t n_nodes = sites->n_nodes, fine = 0, seen = 0, found = 0;
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
