#include "interface.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SERIES };
const char *const interface_laws[] = {"series", "mean", NULL};

/* A part of the line from a lower end to the upper one, in the cell of the site at a shift from the
 * lower one. */
struct segment {
    int64_t shift;
    double length; /* of the whole 1 */
};

struct interface {
    const struct bonds *bonds;
    int n_phases;
    double *stiffness; /* [n_phases] */
    /* On a lattice: segments of half offset o from first[o] to first[o + 1]. */
    int *first;
    struct segment *segments;
};

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where a line along a step passes from cell to cell, in between 0 and 1, ends included; how many.
 */
static int find_cuts(const int step[3], double *cuts)
{
    int count = 0;
    cuts[count++] = 0;
    for (int a = 0; a < 3; a++)
        for (int m = 0; m < abs(step[a]); m++) cuts[count++] = (m + 0.5) / abs(step[a]);
    cuts[count++] = 1;
    qsort(cuts, (size_t)count, sizeof *cuts, ascending);
    return count;
}

static void cut_lines(struct interface *interface)
{
    const struct body *body = interface->bonds->body;
    const struct family *family = body->family;
    double *cuts = memory_new((size_t)(3 * family->reach + 2), sizeof *cuts);
    int n = 0;
    interface->first = memory_new((size_t)family->n_half + 1, sizeof *interface->first);
    for (int o = 0; o < family->n_half; o++) {
        const int *step = family->half[o].step, count = find_cuts(step, cuts);
        for (int c = 0; c + 1 < count; c++) {
            const double length = cuts[c + 1] - cuts[c], middle = 0.5 * (cuts[c + 1] + cuts[c]);
            int at[3];
            if (!(length > 1e-12)) continue; /* through an edge of cells */
            for (int a = 0; a < 3; a++) at[a] = (int)lround(middle * step[a]);
            interface->segments = memory_grow(interface->segments, n, sizeof *interface->segments);
            interface->segments[n++] = (struct segment){grid_shift(&body->grid, at), length};
        }
        interface->first[o + 1] = n;
    }
    free(cuts);
}

bool interface_read(struct deck_node solver)
{
    const struct deck_node said = deck_find(solver, "interfaces");
    return !said.index || keys_choice(said, interface_laws) == SERIES;
}

struct interface *interface_new(const struct bonds *bonds, int n_phases, const double *stiffness)
{
    bool alike = true;
    for (int p = 1; p < n_phases; p++) alike &= stiffness[p] == stiffness[0];
    if (alike) return NULL;
    struct interface *interface = memory_new(1, sizeof *interface);
    interface->bonds = bonds;
    interface->n_phases = n_phases;
    interface->stiffness = memory_new((size_t)n_phases, sizeof(double));
    memcpy(interface->stiffness, stiffness, (size_t)n_phases * sizeof(double));
    if (!bonds->lower) cut_lines(interface);
    return interface;
}

void interface_free(struct interface *interface)
{
    if (!interface) return;
    free(interface->stiffness);
    free(interface->first);
    free(interface->segments);
    free(interface);
}

/* Adds the parts of a line through each phase; sites without a particle do not count. */
static void add_line(const struct interface *interface, const struct bond_strip *strip, int64_t i,
                     int64_t j, double *length)
{
    const uint8_t *phase = interface->bonds->body->grid.phase;
    if (!interface->first) {
        length[phase[i]] += 0.5;
        length[phase[j]] += 0.5;
        return;
    }
    for (int s = interface->first[strip->offset]; s < interface->first[strip->offset + 1]; s++) {
        const struct segment *segment = &interface->segments[s];
        if (phase[i + segment->shift] != ABSENT)
            length[phase[i + segment->shift]] += segment->length;
    }
}

bool interface_strip(const struct interface *interface, const struct bond_strip *strip,
                     double *const share[2], double *const part[2])
{
    const struct bond_view view = bonds_view(interface->bonds, strip);
    const uint8_t *phase = interface->bonds->body->grid.phase;
    double length[256];
    bool any = false;
    for (int k = 0; k < view.count; k++) {
        const int64_t end[2] = {bond_lower(&view, k), bond_upper(&view, k)};
        double all = 0, compliance = 0, own[2];
        for (int p = 0; p < interface->n_phases; p++) length[p] = 0;
        add_line(interface, strip, end[0], end[1], length);
        for (int p = 0; p < interface->n_phases; p++) {
            all += length[p];
            compliance += length[p] / interface->stiffness[p];
        }
        const bool one = length[phase[end[0]]] == all, alike = phase[end[0]] == phase[end[1]];
        for (int e = 0; e < 2; e++) {
            share[e][k] = one ? 1 : all / (compliance * interface->stiffness[phase[end[e]]]);
            own[e] = share[e][k] * length[phase[end[e]]] / all;
        }
        for (int e = 0; e < 2; e++)
            part[e][k] = one ? 1 : (1 + (alike ? 0 : own[e] - own[1 - e])) / share[e][k];
        any |= !one;
    }
    return any;
}

double interface_stiffness(const struct material *m, enum plane plane)
{
    const double mu = m->shear_modulus;
    return material_bulk_modulus(m, plane) + (plane == SPACE ? 4 * mu / 3 : mu);
}
