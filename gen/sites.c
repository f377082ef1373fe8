#include "sites.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>

int64_t sites_number(const int64_t count[3])
{
    const double sites = (double)count[0] * (double)count[1] * (double)count[2];
    if (sites > INT32_MAX)
        die_user("%.0f lattice sites are more than the %d that a domain can have: use a larger "
                 "spacing",
                 sites, INT32_MAX);
    return count[0] * count[1] * count[2];
}

struct sites sites_new(const int64_t count[3], const double spacing[3], sites_inside *inside,
                       const void *specimen)
{
    struct sites sites = {.count = {count[0], count[1], count[2]},
                          .spacing = {spacing[0], spacing[1], spacing[2]},
                          .turn = {1, 0}};
    const int64_t n_sites = sites_number(count);
    sites.node = memory_new((size_t)n_sites, sizeof *sites.node);
    sites.site = memory_new((size_t)n_sites, sizeof *sites.site);
    for (int64_t site = 0; site < n_sites; site++) {
        double point[3];
        sites_centre(&sites, site, point);
        sites.node[site] = -1;
        if (inside(specimen, site, point)) {
            sites.node[site] = sites.n_nodes;
            sites.site[sites.n_nodes++] = site;
        }
    }
    return sites;
}

void sites_free(struct sites *sites)
{
    free(sites->node);
    free(sites->site);
    free(sites->volume);
    *sites = (struct sites){0};
}

char *sites_cell(const struct sites *sites)
{
    const double *edge = sites->spacing;
    const bool cube = edge[1] == edge[0] && (edge[2] == edge[0] || sites->count[2] == 1);
    return cube ? memory_print("%.6g", 1e6 * edge[0])
                : memory_print("%.6g x %.6g x %.6g", 1e6 * edge[0], 1e6 * edge[1], 1e6 * edge[2]);
}

static void index_of(const struct sites *sites, int64_t at, int64_t index[3])
{
    /* There are less than 2^31 sites, and 32-bit division is several times faster. */
    uint32_t site = (uint32_t)at;
    uint32_t columns = (uint32_t)sites->count[0], rows = (uint32_t)sites->count[1];
    uint32_t row = site / columns, layer = row / rows;
    index[0] = site - row * columns;
    index[1] = row - layer * rows;
    index[2] = layer;
}

void sites_index(const struct sites *sites, int64_t node, int64_t index[3])
{
    index_of(sites, sites->site[node], index);
}

double sites_coordinate(const struct sites *sites, int axis, int64_t i)
{
    /* A whole number times half the edge: mirrored nodes have exactly opposite coordinates. */
    return 0.5 * (double)(2 * i + 1 - sites->count[axis]) * sites->spacing[axis];
}

void sites_centre(const struct sites *sites, int64_t site, double centre[3])
{
    int64_t index[3];
    index_of(sites, site, index);
    for (int axis = 0; axis < 3; axis++) centre[axis] = sites_coordinate(sites, axis, index[axis]);
}

void sites_position(const struct sites *sites, int64_t node, double position[3])
{
    sites_centre(sites, sites->site[node], position);
}

void sites_in_body(const struct sites *sites, int64_t node, double position[3])
{
    sites_position(sites, node, position);
    const double x = position[0], y = position[1], *turn = sites->turn;
    position[0] = turn[0] * x + turn[1] * y;
    position[1] = turn[0] * y - turn[1] * x;
}

double sites_volume(const struct sites *sites, int64_t node)
{
    const double *edge = sites->spacing;
    return sites->volume ? sites->volume[node] : edge[0] * edge[1] * edge[2];
}

double sites_whole_volume(const struct sites *sites, const uint8_t *counted)
{
    double volume = 0;
    int64_t nodes = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        if (counted && !counted[node]) continue;
        nodes++;
        if (sites->volume) volume += sites->volume[node];
    }
    return sites->volume ? volume : (double)nodes * sites_volume(sites, 0);
}
