#include "integrity.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double combine(enum combination combination, double a, double b)
{
    switch (combination) {
    case COMBINE_SMALLER:
        return fmin(a, b);
    case COMBINE_LARGER:
        return fmax(a, b);
    case COMBINE_HARMONIC:
        return a + b > 0 ? 2 * a * b / (a + b) : 0;
    default:
        return 0.5 * (a + b);
    }
}

struct integrity *integrity_new(const struct body *body, int n_phases,
                                const enum combination bonds[])
{
    struct integrity *integrity = memory_new(1, sizeof *integrity);
    const size_t pairs = (size_t)(n_phases * n_phases);
    integrity->whole = true;
    integrity->n_phases = n_phases;
    integrity->bonds = memory_new(pairs, sizeof *integrity->bonds);
    memcpy(integrity->bonds, bonds, pairs * sizeof *bonds);
    integrity->node = memory_new((size_t)body->grid.n_sites, sizeof *integrity->node);
    for (int64_t i = 0; i < body->grid.n_sites; i++) integrity->node[i] = 1;
    return integrity;
}

void integrity_free(struct integrity *integrity)
{
    if (!integrity) return;
    free(integrity->node);
    free(integrity->bonds);
    free(integrity);
}

static bool any_degraded(int count, const double *values)
{
    double least = 1;
    for (int k = 0; k < count; k++) least = values[k] < least ? values[k] : least;
    return least < 1;
}

const double *integrity_of_nodes(const struct body *body, int64_t site, int count)
{
    const struct integrity *integrity = body->integrity;
    if (!integrity || integrity->whole || !any_degraded(count, integrity->node + site)) return NULL;
    return integrity->node + site;
}

const double *integrity_of_bonds(const struct body *body, const struct bond_view *view,
                                 double *buffer)
{
    const struct integrity *integrity = body->integrity;
    if (!integrity || integrity->whole) return NULL;
    for (int k = 0; k < view->count; k++) {
        const int64_t i = bond_lower(view, k), j = bond_upper(view, k);
        const int pair = body->grid.phase[i] * integrity->n_phases + body->grid.phase[j];
        buffer[k] = combine(integrity->bonds[pair], integrity->node[i], integrity->node[j]);
    }
    return any_degraded(view->count, buffer) ? buffer : NULL;
}
