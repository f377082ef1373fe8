#include "bonds.h"

#include "memory.h"
#include "scattered.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where a strip of a lattice comes in the order of the sums: line by line, by offset, then along x. */
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

/* The phases of both ends where all bonds of the strip have the same. */
static int common_pair(const struct grid *grid, int64_t i, int64_t shift, int count)
{
    const uint8_t a = grid->phase[i], b = grid->phase[i + shift];
    for (int k = 1; k < count; k++)
        if (grid->phase[i + k] != a || grid->phase[i + shift + k] != b) return -1;
    return 16 * a + b;
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

struct bonds *bonds_new(struct body *body)
{
    struct bonds *bonds = memory_new(1, sizeof *bonds);
    body->bonds = bonds;
    if (body->lattice->point[0]) {
        scattered_bonds(bonds, body);
        scattered_shapes(body);
        return bonds;
    }
    const struct grid *grid = &body->grid;
    const struct family *family = body->family;
    bonds->body = body;
    find_geometry(bonds);
    struct strips *strips = memory_new((size_t)family->n_half, sizeof *strips);
    for (int o = 0; o < family->n_half; o++) {
        strips[o] = grid_bond_strips(grid, family->half[o].step);
        bonds->count += strips[o].count;
    }
    struct place *places = memory_new((size_t)bonds->count, sizeof *places), *next = places;
    for (int o = 0; o < family->n_half; o++) {
        for (int64_t s = 0; s < strips[o].count; s++) {
            const struct strip *strip = &strips[o].items[s];
            int at[3];
            grid_position(grid, strip->site, at);
            *next++ = (struct place){
                {at[2], at[1], o, at[0]},
                {.count = strip->count,
                 .offset = o,
                 .pair = common_pair(grid, strip->site, bonds->geometry[o].shift, strip->count),
                 .i = strip->site}};
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
    return bonds;
}

void bonds_free(struct bonds *bonds)
{
    for (int64_t s = 0; s < bonds->count; s++) free(bonds->strips[s].weight);
    free(bonds->strips);
    free(bonds->geometry);
    free(bonds->lower);
    free(bonds->upper);
    for (int a = 0; a < 3; a++) free(bonds->xi[a]);
    free(bonds->length);
    free(bonds->volume_lower);
    free(bonds->volume_upper);
    free(bonds);
}

static struct bond_view scattered_view(const struct bonds *bonds, const struct bond_strip *strip)
{
    const int64_t i = strip->i;
    return (struct bond_view){.count = strip->count,
                              .stride = bonds_stride(strip->count),
                              .geometry_step = 1,
                              .weight_step = 1,
                              .xi = {bonds->xi[0] + i, bonds->xi[1] + i, bonds->xi[2] + i},
                              .length = bonds->length + i,
                              .volume_i = bonds->volume_lower + i,
                              .volume_j = bonds->volume_upper + i,
                              .weight = strip->weight,
                              .lower = bonds->lower + i,
                              .upper = bonds->upper + i};
}

/* Written where it is wanted: a kernel's call is short. */
static inline void fill_view(const struct bonds *bonds, const struct bond_strip *strip,
                             struct bond_view *view)
{
    if (strip->offset < 0) {
        *view = scattered_view(bonds, strip);
        return;
    }
    const struct bond_geometry *g = &bonds->geometry[strip->offset];
    *view = (struct bond_view){.count = strip->count,
                               .stride = bonds_stride(strip->count),
                               .weight_step = strip->weight ? 1 : 0,
                               .xi = {&g->xi[0], &g->xi[1], &g->xi[2]},
                               .length = &g->length,
                               .volume_i = bonds->volume,
                               .volume_j = bonds->volume,
                               .weight = strip->weight ? strip->weight : &g->weight,
                               .i = strip->i,
                               .j = strip->i + g->shift,
                               .apart = g->apart};
}

struct bond_view bonds_view(const struct bonds *bonds, const struct bond_strip *strip)
{
    struct bond_view view;
    fill_view(bonds, strip, &view);
    return view;
}

int64_t bonds_line(const struct bonds *bonds, int64_t s, struct bond_view *view)
{
    const struct bond_strip *first = &bonds->strips[s], *end = bonds->strips + bonds->count;
    fill_view(bonds, first, view);
    if (view->weight_step || !view->apart || first->pair < 0) return 1;
    const struct bond_strip *next = first + 1;
    for (; next < end && next->offset == first->offset && next->i == first->i + view->count &&
           next->pair == first->pair && !next->weight;
         next++)
        view->count += next->count;
    return next - first;
}

double *bonds_own_weights(struct bonds *bonds, struct bond_strip *strip)
{
    bonds->changed = true;
    bonds->changes++;
    if (strip->weight) return strip->weight;
    strip->weight = memory_new((size_t)bonds_stride(strip->count), sizeof *strip->weight);
    for (int k = 0; k < strip->count; k++) strip->weight[k] = bonds->geometry[strip->offset].weight;
    return strip->weight;
}

void bonds_only_owned(const struct bonds *bonds, const struct bond_view *view, double *terms)
{
    const uint8_t *flags = bonds->body->grid.flags;
    for (int k = 0; k < view->count; k++)
        terms[k] = (flags[bond_lower(view, k)] & SITE_OWNED) ? terms[k] : 0;
}

int64_t bonds_total(const struct bonds *bonds)
{
    double total = 0; /* exact below 2^53 */
    for (int64_t s = 0; s < bonds->count; s++) {
        const struct bond_view view = bonds_view(bonds, &bonds->strips[s]);
        for (int k = 0; k < view.count; k++)
            total += (bonds->body->grid.flags[bond_lower(&view, k)] & SITE_OWNED) != 0;
    }
    ranks_sum(&total, 1);
    return (int64_t)total;
}
