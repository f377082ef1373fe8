#include "sites.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>

struct sites sites_new(const int64_t count[3], const double spacing[3], sites_inside *inside,
                       const void *specimen)
{
    struct sites sites = {.count = {count[0], count[1], count[2]},
                          .spacing = {spacing[0], spacing[1], spacing[2]}};
    int64_t n_sites = count[0] * count[1] * count[2];
    if (n_sites > INT32_MAX)
        die_user("%lld lattice sites are more than the %d that a domain can have: use a larger "
                 "spacing",
                 (long long)n_sites, INT32_MAX);
    sites.node = memory_new((size_t)n_sites, sizeof *sites.node);
    sites.site = memory_new((size_t)n_sites, sizeof *sites.site);
    for (int64_t site = 0; site < n_sites; site++) {
        double point[3] = {
            sites_coordinate(&sites, 0, site % count[0]),
            sites_coordinate(&sites, 1, site / count[0] % count[1]),
            sites_coordinate(&sites, 2, site / count[0] / count[1]),
        };
        sites.node[site] = -1;
        if (inside(specimen, point)) {
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
    *sites = (struct sites){0};
}

char *sites_cell(const struct sites *sites)
{
    const double *edge = sites->spacing;
    const bool cube = edge[1] == edge[0] && (edge[2] == edge[0] || sites->count[2] == 1);
    return cube ? memory_print("%.6g", 1e6 * edge[0])
                : memory_print("%.6g x %.6g x %.6g", 1e6 * edge[0], 1e6 * edge[1], 1e6 * edge[2]);
}

void sites_index(const struct sites *sites, int64_t node, int64_t index[3])
{
    /* There are less than 2^31 sites, and 32-bit division is several times faster. */
    uint32_t site = (uint32_t)sites->site[node];
    uint32_t columns = (uint32_t)sites->count[0], rows = (uint32_t)sites->count[1];
    uint32_t row = site / columns, layer = row / rows;
    index[0] = site - row * columns;
    index[1] = row - layer * rows;
    index[2] = layer;
}

double sites_coordinate(const struct sites *sites, int axis, int64_t i)
{
    /* A whole number times half the edge: mirrored nodes have exactly opposite coordinates. */
    return 0.5 * (double)(2 * i + 1 - sites->count[axis]) * sites->spacing[axis];
}

void sites_position(const struct sites *sites, int64_t node, double position[3])
{
    int64_t index[3];
    sites_index(sites, node, index);
    for (int axis = 0; axis < 3; axis++)
        position[axis] = sites_coordinate(sites, axis, index[axis]);
}
