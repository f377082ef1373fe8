#include "fill.h"

#include "memory.h"
#include "outline.h"
#include "symmetry.h"

#include <math.h>
#include <stdlib.h>

struct cells {
    const struct specimen *specimen;
    int64_t n_sites;
    double *inside; /* [n_sites] of the cell, its part in the body: 0 to 1 */
    double *owned;  /* [n_sites] the same with what was merged into it */
};

/* --- parts of cells --------------------------------------------------------------------------- */

static void find_parts(const struct specimen *specimen, struct cells *cells)
{
    /* A whole cell and none are exactly that: rounding makes no cut. */
    const double rounding = 1e-11, cell = specimen_node_volume(specimen);
    struct sites sites = {0};
    for (int axis = 0; axis < 3; axis++) {
        sites.count[axis] = specimen->count[axis];
        sites.spacing[axis] = specimen->spacing[axis];
    }
    for (int64_t site = 0; site < cells->n_sites; site++) {
        double centre[3];
        sites_centre(&sites, site, centre);
        double part = outline_of_cell(specimen, centre) / cell;
        if (part < rounding) part = 0;
        if (part > 1 - rounding) part = 1;
        cells->inside[site] = cells->owned[site] = part;
    }
}

/* --- merging ---------------------------------------------------------------------------------- */

struct part {
    double inside;
    int64_t site;
};

static int compare_parts(const void *a, const void *b)
{
    const struct part *left = a, *right = b;
    const int order = (left->inside > right->inside) - (left->inside < right->inside);
    return order ? order : (left->site > right->site) - (left->site < right->site);
}

/* Sites across the six faces; returns how many there are. */
static int neighbours_of(const int64_t count[3], int64_t site, int64_t neighbour[6])
{
    const int64_t stride[3] = {1, count[0], count[0] * count[1]};
    int n = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int64_t at = site / stride[axis] % count[axis];
        if (at > 0) neighbour[n++] = site - stride[axis];
        if (at < count[axis] - 1) neighbour[n++] = site + stride[axis];
    }
    return n;
}

static void merge(struct cells *cells, int64_t site)
{
    int64_t neighbour[6];
    const int n = neighbours_of(cells->specimen->count, site, neighbour);
    double most = 0;
    int heirs = 0;
    for (int i = 0; i < n; i++) most = fmax(most, cells->inside[neighbour[i]]);
    /* Cells that are alike by symmetry are so but for rounding. */
    const double alike = 1e-9;
    if (most <= cells->inside[site] + alike) return;
    for (int i = 0; i < n; i++) heirs += cells->inside[neighbour[i]] >= most - alike;
    for (int i = 0; i < n; i++)
        if (cells->inside[neighbour[i]] >= most - alike)
            cells->owned[neighbour[i]] += cells->owned[site] / heirs;
    cells->owned[site] = 0;
}

static void merge_small_parts(struct cells *cells)
{
    struct part *small = memory_new((size_t)cells->n_sites, sizeof *small);
    int64_t count = 0;
    for (int64_t site = 0; site < cells->n_sites; site++)
        if (cells->inside[site] > 0 && cells->inside[site] < FILL_LEAST)
            small[count++] = (struct part){cells->inside[site], site};
    qsort(small, (size_t)count, sizeof *small, compare_parts);
    for (int64_t i = 0; i < count; i++) merge(cells, small[i].site);
    free(small);
}

/* --- the lattice ------------------------------------------------------------------------------ */

static bool is_owned(const void *cells, int64_t site, const double point[3])
{
    const struct cells *c = cells;
    return c->owned[site] > 0 && symmetry_keeps(c->specimen, point);
}

static bool is_inside(const void *specimen, int64_t site, const double point[3])
{
    (void)site;
    return outline_holds(specimen, point) && symmetry_keeps(specimen, point);
}

static struct sites cut_sites(const struct specimen *specimen)
{
    struct cells cells = {specimen, sites_number(specimen->count), NULL, NULL};
    cells.inside = memory_new((size_t)cells.n_sites, sizeof *cells.inside);
    cells.owned = memory_new((size_t)cells.n_sites, sizeof *cells.owned);
    find_parts(specimen, &cells);
    merge_small_parts(&cells);
    struct sites sites = sites_new(specimen->count, specimen->spacing, is_owned, &cells);
    sites.volume = memory_new((size_t)sites.n_nodes, sizeof *sites.volume);
    bool cut = false;
    for (int64_t node = 0; node < sites.n_nodes; node++) {
        const double owned = cells.owned[sites.site[node]];
        sites.volume[node] = owned * specimen_node_volume(specimen);
        cut = cut || owned != 1;
    }
    if (!cut) {
        free(sites.volume);
        sites.volume = NULL;
    }
    free(cells.inside);
    free(cells.owned);
    return sites;
}

struct sites fill_sites(const struct specimen *specimen)
{
    struct sites sites = specimen->volumes == VOLUMES_CUT
                             ? cut_sites(specimen)
                             : sites_new(specimen->count, specimen->spacing, is_inside, specimen);
    sites.turn[0] = cos(specimen->angle);
    sites.turn[1] = sin(specimen->angle);
    specimen_repeats(specimen, &sites);
    return sites;
}
