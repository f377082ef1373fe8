#include "sites.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>

struct sites sites_new(const int64_t count[3], double spacing, sites_inside *inside,
                       const void *specimen)
{
    struct sites sites = {.count = {count[0], count[1], count[2]}, .spacing = spacing};
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

void sites_index(const struct sites *sites, int64_t node, int64_t index[3])
{
    int64_t site = sites->site[node];
    index[0] = site % sites->count[0];
    index[1] = site / sites->count[0] % sites->count[1];
    index[2] = site / sites->count[0] / sites->count[1];
}

double sites_coordinate(const struct sites *sites, int axis, int64_t i)
{
    /* A whole number times half the spacing: mirrored nodes have exactly opposite coordinates. */
    return 0.5 * (double)(2 * i + 1 - sites->count[axis]) * sites->spacing;
}

void sites_position(const struct sites *sites, int64_t node, double position[3])
{
    int64_t index[3];
    sites_index(sites, node, index);
    for (int axis = 0; axis < 3; axis++)
        position[axis] = sites_coordinate(sites, axis, index[axis]);
}

int64_t sites_at(const struct sites *sites, int64_t i, int64_t j, int64_t k)
{
    const int64_t *count = sites->count;
    if (i < 0 || j < 0 || k < 0 || i >= count[0] || j >= count[1] || k >= count[2])
        return -1;
    return sites->node[i + count[0] * (j + count[1] * k)];
}
