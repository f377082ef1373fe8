#include "bond_search.h"

#include "memory.h"
#include "neighbours.h"
#include "scattered.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where a strip of a lattice comes in the order of the sums: line by line, by offset, then along x.
 */
struct place {
    int key[4];
    struct bond_strip strip;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *s = a, *t = b;
    for (int k = 0; k < 4; k++)
        if (s->key[k] != t->key[k]) return s->key[k] < t->key[k] ? -1 : 1;
    return 0;
}

static void find_geometry(struct bonds *bonds)
{
    const struct body *body = bonds->body;
    const struct family *family = body->family;
    bonds->geometry = memory_new((size_t)family->n_half, sizeof *bonds->geometry);
    bonds->volume[0] = body->volume;
    for (int o = 0; o < family->n_half; o++) {
        const struct offset *offset = &family->half[o];
        struct bond_geometry *g = &bonds->geometry[o];
        double square = 0;
        for (int a = 0; a < 3; a++) {
            g->xi[a] = offset->step[a] * body->lattice->spacing;
            square += g->xi[a] * g->xi[a];
        }
        g->length = sqrt(square);
        g->weight = offset->weight;
        g->shift = grid_shift(&body->grid, offset->step);
        g->apart = offset->step[1] != 0 || offset->step[2] != 0;
    }
}

static void list_lattice(struct bonds *bonds, const struct body *body)
{
    const struct grid *grid = &body->grid;
    const struct family *family = body->family;
    find_geometry(bonds);
    struct strips *strips = memory_new((size_t)family->n_half, sizeof *strips);
    for (int o = 0; o < family->n_half; o++) {
        strips[o] = grid_bond_strips(grid, family->half[o].step, BOND_LANES);
        bonds->count += strips[o].count;
    }
    struct place *places = memory_new((size_t)bonds->count, sizeof *places), *next = places;
    for (int o = 0; o < family->n_half; o++) {
        for (int64_t s = 0; s < strips[o].count; s++) {
            const struct strip *strip = &strips[o].items[s];
            int at[3];
            grid_position(grid, strip->site, at);
            *next++ = (struct place){{at[2], at[1], o, at[0]},
                                     {.count = strip->count, .offset = o, .i = strip->site}};
        }
        strips_free(&strips[o]);
    }
    free(strips);
    qsort(places, (size_t)bonds->count, sizeof *places, compare_places);
    bonds->strips = memory_new((size_t)bonds->count, sizeof *bonds->strips);
    for (int64_t s = 0; s < bonds->count; s++) {
        bonds->strips[s] = places[s].strip;
        bonds->strips[s].store = bonds->points;
        if (s == 0 || memcmp(places[s].key, places[s - 1].key, 2 * sizeof(int))) bonds->lines++;
        bonds->strips[s].line = bonds->lines - 1;
        bonds->points += bonds_stride(places[s].strip.count);
    }
    free(places);
}

/* Whether a bond of these flags is listed: one end near. */
static bool listed(uint8_t i, uint8_t j)
{
    return ((i | j) & SITE_NEAR) != 0;
}

static void make_room(struct bonds *bonds, size_t entries)
{
    bonds->lower = memory_new(entries, sizeof *bonds->lower);
    bonds->upper = memory_new(entries, sizeof *bonds->upper);
    for (int a = 0; a < 3; a++) bonds->xi[a] = memory_new(entries, sizeof(double));
    bonds->length = memory_new(entries, sizeof(double));
    bonds->volume_lower = memory_new(entries, sizeof(double));
    bonds->volume_upper = memory_new(entries, sizeof(double));
}

static void add_bond(struct bonds *bonds, const struct lattice *lattice, int64_t entry, int64_t i,
                     int64_t j)
{
    double square = 0, way[3];
    bonds->lower[entry] = i;
    bonds->upper[entry] = j;
    lattice_between(lattice, i, j, way);
    for (int a = 0; a < 3; a++) {
        bonds->xi[a][entry] = way[a];
        square += way[a] * way[a];
    }
    bonds->length[entry] = sqrt(square);
    bonds->volume_lower[entry] = lattice->volume[i];
    bonds->volume_upper[entry] = lattice->volume[j];
}

static void add_strip(struct bonds *bonds, int64_t first, int count)
{
    struct bond_strip strip = {.count = count, .offset = -1, .i = first, .store = bonds->points};
    strip.weight = memory_new((size_t)bonds_stride(count), sizeof(double));
    for (int k = 0; k < count; k++) strip.weight[k] = bonds_first_weight(bonds, &strip, k);
    bonds->strips = memory_grow(bonds->strips, bonds->count, sizeof strip);
    strip.line = bonds->lines++;
    bonds->strips[bonds->count++] = strip;
    bonds->points += bonds_stride(count);
}

/* Lists the bonds with a near end, by lower, then by upper node; a strip has one lower end. */
static void list_scattered(struct bonds *bonds, const struct body *body)
{
    const struct lattice *lattice = body->lattice;
    const uint8_t *flags = body->grid.flags;
    struct neighbours neighbours = neighbours_new(lattice->point, lattice->period, lattice->n_sites,
                                                  body->family->horizon * lattice->spacing);
    int64_t entries = 0;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1) make_room(bonds, (size_t)entries);
        entries = 0;
        for (int64_t i = 0; i < lattice->n_sites; i++) {
            if (!(flags[i] & (SITE_NEAR | SITE_MOVES))) continue;
            const int64_t count = neighbours_find(&neighbours, lattice->point, i);
            const int64_t first = entries;
            for (int64_t k = 0; k < count; k++) {
                const int64_t j = neighbours.found[k];
                if (j < i || !listed(flags[i], flags[j])) continue;
                if (pass == 1) add_bond(bonds, lattice, entries, i, j);
                entries++;
            }
            for (int64_t at = first; pass == 1 && at < entries; at += LANES)
                add_strip(bonds, at, (int)(entries - at < LANES ? entries - at : LANES));
        }
    }
    neighbours_free(&neighbours);
}

struct bonds *bonds_new(struct body *body)
{
    const bool scattered = lattice_is_scattered(body->lattice);
    struct bonds *bonds = memory_new(1, sizeof *bonds);
    body->bonds = bonds;
    bonds->body = body;
    (scattered ? list_scattered : list_lattice)(bonds, body);
    if (scattered) scattered_shapes(body);
    return bonds;
}
