#include "bonds.h"

#include "memory.h"

#include <stdlib.h>

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

struct bond_view bonds_view(const struct bonds *bonds, const struct bond_strip *strip)
{
    if (strip->offset < 0) return scattered_view(bonds, strip);
    const struct bond_geometry *g = &bonds->geometry[strip->offset];
    return (struct bond_view){.count = strip->count,
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

struct bond_view bonds_part(const struct bond_view *view, int first, int count)
{
    struct bond_view part = *view;
    const int g = first * view->geometry_step;
    part.count = count;
    for (int a = 0; a < 3; a++) part.xi[a] += g;
    part.length += g;
    part.volume_i += g;
    part.volume_j += g;
    part.weight += first * view->weight_step;
    part.i += first;
    part.j += first;
    if (view->lower) {
        part.lower += first;
        part.upper += first;
    }
    return part;
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

double bonds_first_weight(const struct bonds *bonds, const struct bond_strip *strip, int k)
{
    const struct body *body = bonds->body;
    if (strip->offset >= 0) return bonds->geometry[strip->offset].weight;
    return family_weight(body->family, bonds->length[strip->i + k] / body->lattice->spacing);
}

void bonds_only_owned(const struct bonds *bonds, const struct bond_strip *strip, double *terms)
{
    const uint8_t *flags = bonds->body->grid.flags;
    for (int k = 0; k < strip->count; k++) {
        const int64_t lower = bonds->lower ? bonds->lower[strip->i + k] : strip->i + k;
        terms[k] = (flags[lower] & SITE_OWNED) ? terms[k] : 0;
    }
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
