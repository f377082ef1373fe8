#include "grid.h"

#include "memory.h"
#include "neighbours.h"
#include "simd.h"

#include <stdlib.h>
#include <string.h>

/* The box of the cells that a rank owns, in sites. */
static void owned_box(const struct lattice *lattice, const struct partition *p, int rank,
                      int low[3], int high[3])
{
    for (int a = 0; a < 3; a++) low[a] = lattice->size[a], high[a] = 0;
    const int *owner = p->owner;
    for (int z = 0; z < p->cells[2]; z++)
        for (int y = 0; y < p->cells[1]; y++)
            for (int x = 0; x < p->cells[0]; x++) {
                if (*owner++ != rank) continue;
                const int cell[3] = {x, y, z};
                for (int a = 0; a < 3; a++) {
                    int first = cell[a] * p->edge[a], end = first + p->edge[a];
                    if (first < low[a]) low[a] = first;
                    if (end > high[a]) high[a] = end;
                }
            }
    for (int a = 0; a < 3; a++)
        if (high[a] > lattice->size[a]) high[a] = lattice->size[a];
}

static void fill(struct grid *grid, const struct lattice *lattice, const struct partition *p)
{
    int64_t site = 0;
    for (int z = 0; z < grid->size[2]; z++)
        for (int y = 0; y < grid->size[1]; y++)
            for (int x = 0; x < grid->size[0]; x++, site++) {
                const int at[3] = {grid->origin[0] + x, grid->origin[1] + y, grid->origin[2] + z};
                grid->phase[site] = lattice_phase(lattice, at[0], at[1], at[2]);
                /* Images are nobody's own. */
                if (!lattice_contains(lattice, at[0], at[1], at[2]) ||
                    !lattice_has_node(lattice, lattice_site(lattice, at[0], at[1], at[2])) ||
                    partition_owner(p, at[0], at[1], at[2]) != grid->rank)
                    continue;
                grid->flags[site] = lattice->corner ? SITE_OWNED : SITE_OWNED | SITE_NEAR;
                grid->n_owned++;
            }
}

/* Marks what lies within the offsets (both signs) of the sites that have the flag. */
static void mark_around(struct grid *grid, int around, const struct offset *offsets, int count,
                        uint8_t mark)
{
    uint8_t *marked = memory_new((size_t)grid->n_sites, 1);
    for (int64_t site = 0; site < grid->n_sites; site++) {
        if (!(grid->flags[site] & around)) continue;
        for (int o = 0; o < count; o++) {
            int64_t shift = grid_shift(grid, offsets[o].step);
            marked[site + shift] = marked[site - shift] = 1;
        }
    }
    for (int64_t site = 0; site < grid->n_sites; site++)
        if (marked[site] && grid->phase[site] != ABSENT) grid->flags[site] |= mark;
    free(marked);
}

/* Particles with an owned corner are near; their other corners move. */
static void mark_corners(struct grid *grid, const struct lattice *lattice)
{
    const int each = lattice_corners(lattice);
    int64_t shift[8];
    for (int k = 0; k < each; k++) {
        int step[3];
        lattice_corner_step(k, step);
        shift[k] = grid_shift(grid, step);
    }
    for (int64_t site = 0; site + shift[each - 1] < grid->n_sites; site++) {
        int flags = 0;
        if (grid->phase[site] == ABSENT) continue;
        for (int k = 0; k < each; k++) flags |= grid->flags[site + shift[k]];
        if (!(flags & SITE_OWNED)) continue;
        grid->flags[site] |= SITE_NEAR;
        for (int k = 0; k < each; k++)
            if (!(grid->flags[site + shift[k]] & SITE_OWNED))
                grid->flags[site + shift[k]] |= SITE_MOVES;
    }
}

/* The same of a mesh, where a particle may be owned none of whose corners is. */
static void mark_hexahedra(struct grid *grid, const struct lattice *lattice)
{
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        const int32_t *corner = lattice->hexahedron + 8 * site;
        int flags = grid->flags[site];
        if (grid->phase[site] == ABSENT) continue;
        for (int k = 0; k < 8; k++) flags |= grid->flags[corner[k]];
        if (!(flags & SITE_OWNED)) continue;
        grid->flags[site] |= SITE_NEAR;
        for (int k = -1; k < 8; k++) {
            const int64_t moves = k < 0 ? site : corner[k];
            if (!(grid->flags[moves] & SITE_OWNED)) grid->flags[moves] |= SITE_MOVES;
        }
    }
}

/* Marks the neighbours of owned particles among scattered ones. */
static void mark_neighbours(struct grid *grid, const struct lattice *lattice,
                            const struct neighbours *neighbours, int around, uint8_t mark)
{
    uint8_t *marked = memory_new((size_t)lattice->n_sites, 1);
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        if (!(grid->flags[site] & around)) continue;
        int64_t count = neighbours_find(neighbours, lattice->point, site);
        for (int64_t k = 0; k < count; k++) marked[neighbours->found[k]] = 1;
    }
    for (int64_t site = 0; site < lattice->n_sites; site++)
        if (marked[site]) grid->flags[site] |= mark;
    free(marked);
}

static void drop_owned(struct grid *grid, uint8_t mark)
{
    for (int64_t site = 0; site < grid->n_sites; site++)
        if (grid->flags[site] & SITE_OWNED) grid->flags[site] &= (uint8_t)~mark;
}

/* Near sites that are not owned move. */
static void near_sites_move(struct grid *grid)
{
    for (int64_t site = 0; site < grid->n_sites; site++)
        if ((grid->flags[site] & (SITE_OWNED | SITE_NEAR)) == SITE_NEAR)
            grid->flags[site] |= SITE_MOVES | SITE_GHOST;
}

static void allocate(struct grid *grid)
{
    grid->size[0] = (grid->size[0] + 7) / 8 * 8;
    grid->step[0] = 1;
    grid->step[1] = grid->size[0];
    grid->step[2] = grid->step[1] * grid->size[1];
    grid->n_sites = grid->step[2] * grid->size[2];
    grid->phase = memory_new((size_t)grid->n_sites, 1);
    grid->flags = memory_new((size_t)grid->n_sites, 1);
}

/* Each rank has room for all of the row. */
static struct grid grid_of_row(const struct lattice *lattice, const struct partition *partition,
                               const struct family *family, int n_bonds, int rank)
{
    struct grid grid = {.rank = rank, .size = {lattice->size[0], 1, 1}};
    allocate(&grid);
    fill(&grid, lattice, partition);
    if (lattice->hexahedron) mark_hexahedra(&grid, lattice);
    if (lattice->hexahedron || grid.n_owned == lattice->n_nodes) return grid;
    struct neighbours neighbours = neighbours_new(lattice->point, lattice->period, lattice->n_sites,
                                                  family->horizon * lattice->spacing);
    if (n_bonds > 0) mark_neighbours(&grid, lattice, &neighbours, SITE_OWNED, SITE_NEAR);
    mark_neighbours(&grid, lattice, &neighbours, SITE_OWNED, SITE_STRESSED);
    mark_neighbours(&grid, lattice, &neighbours, SITE_NEAR, SITE_MOVES);
    drop_owned(&grid, SITE_STRESSED | SITE_MOVES);
    near_sites_move(&grid);
    neighbours_free(&neighbours);
    return grid;
}

struct grid grid_new(const struct lattice *lattice, const struct partition *partition,
                     const struct family *family, const struct offset *bonds, int n_bonds, int rank)
{
    if (lattice_is_row(lattice)) return grid_of_row(lattice, partition, family, n_bonds, rank);
    struct grid grid = {.rank = rank};
    int low[3], high[3];
    owned_box(lattice, partition, rank, low, high);
    /* Twice the reach where a near site is one reach away, its family another. */
    const int pad = lattice->corner ? 1 : (n_bonds > 0 ? 2 : 1) * family->reach;
    for (int a = 0; a < 3; a++) {
        const int before =
            a == 0 ? (pad + 7) / 8 * 8 : pad; /* lines of nodes start on cache lines */
        grid.origin[a] = low[a] - before;
        grid.size[a] = before + high[a] - low[a] + pad;
    }
    allocate(&grid);
    fill(&grid, lattice, partition);
    if (lattice->corner) mark_corners(&grid, lattice);
    const bool alone = grid.n_owned == lattice->n_nodes && !lattice_is_periodic(lattice);
    if (lattice->corner || alone) return grid;

    mark_around(&grid, SITE_OWNED, bonds, n_bonds, SITE_NEAR);
    mark_around(&grid, SITE_OWNED, family->half, family->n_half, SITE_STRESSED);
    mark_around(&grid, SITE_NEAR, family->half, family->n_half, SITE_MOVES);
    drop_owned(&grid, SITE_STRESSED | SITE_MOVES);
    near_sites_move(&grid);
    return grid;
}

void grid_free(struct grid *grid)
{
    free(grid->phase);
    free(grid->flags);
    *grid = (struct grid){0};
}

int64_t grid_site(const struct grid *grid, const int at[3])
{
    int64_t site = 0;
    for (int a = 0; a < 3; a++) {
        int local = at[a] - grid->origin[a];
        if (local < 0 || local >= grid->size[a]) return -1;
        site += local * grid->step[a];
    }
    return site;
}

void grid_position(const struct grid *grid, int64_t site, int at[3])
{
    at[2] = grid->origin[2] + (int)(site / grid->step[2]);
    at[1] = grid->origin[1] + (int)(site % grid->step[2] / grid->step[1]);
    at[0] = grid->origin[0] + (int)(site % grid->step[1]);
}

/* Strips of the sites where listed[site] is set. */
static struct strips make_strips(const struct grid *grid, const uint8_t *listed, int lanes)
{
    struct strips strips = {0};
    for (int pass = 0; pass < 2; pass++) {
        int64_t points = 0;
        strips.count = 0;
        for (int64_t line = 0; line < grid->n_sites; line += grid->step[1])
            for (int x = 0; x < grid->size[0];) {
                int first = x++;
                if (!listed[line + first]) continue;
                while (x < grid->size[0] && listed[line + x] && (grid->origin[0] + x) % lanes != 0)
                    x++;
                const int stride = (x - first + 7) / 8 * 8;
                if (pass)
                    strips.items[strips.count] = (struct strip){
                        line + first, x - first, grid->origin[0] + first, stride, points};
                points += stride;
                strips.count++;
            }
        strips.points = points;
        if (!pass) strips.items = memory_new((size_t)strips.count, sizeof(struct strip));
    }
    return strips;
}

struct strips grid_strips(const struct grid *grid, int wanted, int unwanted)
{
    uint8_t *listed = memory_new((size_t)grid->n_sites, 1);
    for (int64_t site = 0; site < grid->n_sites; site++)
        listed[site] = (grid->flags[site] & (wanted | unwanted)) == wanted;
    struct strips strips = make_strips(grid, listed, LANES);
    free(listed);
    return strips;
}

struct strips grid_bond_strips(const struct grid *grid, const int step[3], int lanes)
{
    uint8_t *listed = memory_new((size_t)grid->n_sites, 1);
    const int64_t shift = grid_shift(grid, step);
    for (int64_t i = 0; i < grid->n_sites; i++) {
        int64_t j = i + shift;
        if (j < 0 || j >= grid->n_sites || grid->phase[i] == ABSENT || grid->phase[j] == ABSENT)
            continue;
        listed[i] = ((grid->flags[i] | grid->flags[j]) & SITE_OWNED) != 0;
    }
    struct strips strips = make_strips(grid, listed, lanes);
    free(listed);
    return strips;
}

void strips_free(struct strips *strips)
{
    free(strips->items);
    *strips = (struct strips){0};
}
