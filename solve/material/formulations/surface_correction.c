/* surface_correction.c - weights of bonds near a surface, raised by what the families of their ends
 * lack (surface_correction.h).
 *
 * The constants of bond-based and ordinary materials are those of a full family; a node with half a
 * family is too soft.  The correction is made once, at the start, and goes into the weights: the
 * loops over bonds know nothing of it, and strips of the interior, whose factors are 1, keep their
 * one weight in a register.  Both ends give the bond one factor, so that the forces at its ends
 * stay opposite.  Correspondence needs none of it: its shape tensor does the same. */
#include "surface_correction.h"

#include "bond_loop.h"
#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

const char *const surface_corrections[] = {"none", "volume", "energy", NULL};

enum surface_correction surface_correction_read(struct deck_node solver)
{
    const struct deck_node said = deck_find(solver, "surface_correction");
    return said.index ? (enum surface_correction)keys_choice(said, surface_corrections)
                      : SURFACE_NONE;
}

/* w |xi|^power n^4, power from 0 to 2 */
HS_INLINE double weighted(double weight, double length, double power, double n)
{
    const double once = weight * n * n * n * n * (power > 0 ? length : 1);
    return power > 1 ? once * length : once;
}

/* Adds to each end w |xi|^power n^4 times the volume of the other end; the pass's number is the
 * power. */
HS_INLINE void add_weighted_volume(const struct bond_pass *p, int k, struct bond b, double n)
{
    const double one = weighted(b.weight, b.length, p->number, n);
    p->sum[0][0][k] += one * b.volume_j;
    p->sum[1][0][k] += one * b.volume_i;
}
BOND_KERNELS(weighted_volumes, add_weighted_volume(p, k, b, 1))
BOND_KERNELS(weighted_volumes_x, add_weighted_volume(p, k, b, b.xi_x / b.length))
BOND_KERNELS(weighted_volumes_y, add_weighted_volume(p, k, b, b.xi_y / b.length))
BOND_KERNELS(weighted_volumes_z, add_weighted_volume(p, k, b, b.xi_z / b.length))

/* n of an axis; axis < 0: 1 */
static void add_weighted_volumes(const struct bonds *bonds, int power, int axis, double *sum)
{
    static bond_kernel *const *const kernels[] = {weighted_volumes, weighted_volumes_x,
                                                  weighted_volumes_y, weighted_volumes_z};
    for (int64_t s = 0; s < bonds->count; s++) {
        struct bond_pass pass;
        pass.number = power;
        bond_run(kernels[1 + axis], bonds, &bonds->strips[s],
                 (struct bond_fields){0, 1, NULL, &sum}, &pass);
    }
}

void surface_add_weighted_volumes(const struct bonds *bonds, int power, double *sum)
{
    add_weighted_volumes(bonds, power, -1, sum);
}

/* Sum of w |xi|^power n^4 V over a full family; axis as of add_weighted_volumes. */
static double full_family(const struct bonds *bonds, int power, int axis)
{
    const struct body *body = bonds->body;
    const struct family *family = body->family;
    const double pi = acos(-1), dx = body->lattice->spacing;
    const bool flat = body->lattice->dimensions == 2;
    double sum = 0;
    if (bonds->lower) {
        /* Mean of n_a^4: 1/5 in space, 3/8 in a plane. */
        const double mean = axis < 0 ? 1 : flat ? 0.375 : 0.2;
        sum = mean * (flat ? 2 * pi * body->lattice->thickness / dx : 4 * pi) *
              family_moment(family, power + (flat ? 1 : 2)) * pow(dx, 3 + power);
        if (!isfinite(sum))
            die_user("no surface correction of scattered particles with the steep influence "
                     "function: its continuum has no full family");
        return sum;
    }
    for (int o = 0; o < family->n_half; o++) {
        const struct bond_geometry *g = &bonds->geometry[o];
        if (flat && family->half[o].step[2] != 0) continue;
        sum += 2 * weighted(g->weight, g->length, power, axis < 0 ? 1 : g->xi[axis] / g->length) *
               body->volume;
    }
    return sum;
}

double surface_full_family(const struct bonds *bonds, int power)
{
    return full_family(bonds, power, -1);
}

/* field[node] = full/sum over the bonds of the node, at owned nodes and their neighbours elsewhere.
 */
static void find_ratio(const struct bonds *bonds, int power, int axis, double *field)
{
    const struct body *body = bonds->body;
    const double full = full_family(bonds, power, axis);
    add_weighted_volumes(bonds, power, axis, field);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int k = 0; k < body->owned.items[s].count; k++) {
            double *value = &field[body->owned.items[s].site + k];
            *value = *value > 0 ? full / *value : 1;
        }
    halo_exchange(body->stress_halo, (double *const[]){field}, 1);
}

/* (surface.2) */
static double on_ellipsoid(double *const ratio[3], int64_t i, int64_t j, const double xi[3],
                           double length)
{
    double sum = 0;
    for (int a = 0; a < 3; a++) {
        const double n = xi[a] / length, half = 0.5 * (ratio[a][i] + ratio[a][j]);
        sum += n * n / (half * half);
    }
    return 1 / sqrt(sum);
}

static void correct_strip(enum surface_correction kind, struct bonds *bonds,
                          struct bond_strip *strip, double *const ratio[3])
{
    const struct bond_view view = bonds_view(bonds, strip);
    const int g = view.geometry_step;
    double factor[BOND_LANES];
    bool changed = false;
    for (int k = 0; k < view.count; k++) {
        const double xi[3] = {view.xi[0][k * g], view.xi[1][k * g], view.xi[2][k * g]};
        const int64_t i = bond_lower(&view, k), j = bond_upper(&view, k);
        /* V_0/V is kept: 2 V_0/(V_i + V_j) = 2/(1/r_i + 1/r_j). */
        factor[k] = kind == SURFACE_VOLUME ? 2 / (1 / ratio[0][i] + 1 / ratio[0][j])
                                           : on_ellipsoid(ratio, i, j, xi, view.length[k * g]);
        /* Inside the body the ratios are 1 but for rounding. */
        if (fabs(factor[k] - 1) < 1e-12) factor[k] = 1;
        changed |= factor[k] != 1;
    }
    if (!changed) return;
    double *weight = bonds_own_weights(bonds, strip);
    for (int k = 0; k < view.count; k++) weight[k] *= factor[k];
}

void surface_correction_apply(enum surface_correction kind, struct bonds *bonds, int power)
{
    const size_t n = (size_t)bonds->body->grid.n_sites;
    double *ratio[3];
    if (kind == SURFACE_NONE) return;
    for (int a = 0; a < 3; a++) {
        ratio[a] = memory_new(n, sizeof(double));
        if (kind == SURFACE_ENERGY && a < bonds->body->lattice->dimensions) {
            find_ratio(bonds, power, a, ratio[a]);
        } else {
            for (size_t i = 0; i < n; i++) ratio[a][i] = 1;
        }
    }
    if (kind == SURFACE_VOLUME) {
        for (size_t i = 0; i < n; i++) ratio[0][i] = 0;
        find_ratio(bonds, 0, -1, ratio[0]);
    }
    for (int64_t s = 0; s < bonds->count; s++) correct_strip(kind, bonds, &bonds->strips[s], ratio);
    for (int a = 0; a < 3; a++) free(ratio[a]);
}
