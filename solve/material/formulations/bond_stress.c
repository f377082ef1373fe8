/* bond_stress.c - the nominal stress of bonds.
 *
 * For records alone, not in every step: so a strip's directions and force states are found once,
 * for both ends, and kept in buffers, from which each component is added in a loop of its own.  On
 * a lattice a bond that does not reach along an axis adds nothing to the stress there; of a family
 * of 122 a fifth of all components is left out so. */
#include "bond_stress.h"

#include "bond_loop.h"

#include <math.h>

/* Of each bond, what it is found of and what is found: y, and the force state of either end times
 * the volume of the other over |y|. */
enum { EXTENSION, STATE, STATE_UPPER };
enum { Y, PULL = Y + 3, PULL_UPPER, FOUND };

HS_INLINE void find_direction(const struct bond_pass *p, int k, struct bond b)
{
    const double inverse = 1 / (b.length + p->given[EXTENSION][k]);
    p->each[Y][k] = b.xi_x + p->u[1][0][k] - p->u[0][0][k];
    p->each[Y + 1][k] = b.xi_y + p->u[1][1][k] - p->u[0][1][k];
    p->each[Y + 2][k] = b.xi_z + p->u[1][2][k] - p->u[0][2][k];
    p->each[PULL][k] = p->given[STATE][k] * b.volume_j * inverse;
    p->each[PULL_UPPER][k] = p->given[STATE_UPPER][k] * b.volume_i * inverse;
}
BOND_KERNELS(find_directions, find_direction(p, k, b))

HS_SIMD static void add_alike(int count, const double *restrict pull, const double *restrict y,
                              double xi, double *restrict S)
{
    for (int k = 0; k < count; k++) S[k] += pull[k] * (y[k] * xi);
}
HS_SIMD static void add_scattered(int count, const double *restrict pull, const double *restrict y,
                                  const double *restrict xi, double *restrict S)
{
    for (int k = 0; k < count; k++) S[k] += pull[k] * (y[k] * xi[k]);
}

void bond_stress_add(const struct bonds *bonds, const struct bond_strip *strip,
                     const double *extension, const double *lower, const double *upper, int rows,
                     struct body *body)
{
    const struct bond_view view = bonds_view(bonds, strip);
    double found[FOUND][BOND_LANES], buffer[BOND_LANES];
    struct bond_pass pass = {.given = {extension, lower, upper}};
    for (int k = 0; k < FOUND; k++) pass.each[k] = found[k];
    bond_run(find_directions, bonds, strip, (struct bond_fields){0}, &pass);
    for (int end = 0; end < 2; end++)
        for (int a = 0; a < rows; a++)
            for (int b = 0; b < 3; b++) {
                double *S = body->S[3 * a + b], *target;
                if (!view.geometry_step && view.xi[b][0] == 0) continue;
                target = bond_target(&view, end, S, buffer);
                if (view.geometry_step)
                    add_scattered(view.count, found[PULL + end], found[Y + a], view.xi[b], target);
                else
                    add_alike(view.count, found[PULL + end], found[Y + a], view.xi[b][0], target);
                bond_scatter(&view, end, S, buffer);
            }
}

/* Periods by which the upper end of bond k of a strip lies beyond the cell that its lower one is
 * in, along an axis. */
static int periods_beyond(const struct bonds *bonds, const struct bond_strip *strip, int axis,
                          int k)
{
    const struct body *body = bonds->body;
    const struct lattice *lattice = body->lattice;
    int at[3];
    if (!lattice->periodic[axis]) return 0;
    if (strip->offset < 0) {
        const int64_t entry = strip->i + k;
        const double *x = lattice->point[axis],
                     apart = x[bonds->upper[entry]] - x[bonds->lower[entry]];
        return (int)lround((bonds->xi[axis][entry] - apart) / lattice->period[axis]);
    }
    grid_position(&body->grid, strip->i, at);
    const int upper = at[axis] + body->family->half[strip->offset].step[axis] + (axis == 0 ? k : 0);
    return upper < 0 ? -1 : upper >= lattice->size[axis];
}

bool bond_stress_crosses(const struct bonds *bonds, const struct bond_strip *strip)
{
    /* Of a strip of a lattice the first bond or the last. */
    const int step = strip->offset < 0 || strip->count < 2 ? 1 : strip->count - 1;
    for (int k = 0; k < strip->count; k += step)
        for (int a = 0; a < 3; a++)
            if (periods_beyond(bonds, strip, a, k)) return true;
    return false;
}

void bond_stress_cross(const struct bonds *bonds, const struct bond_strip *strip,
                       const double *const y[3], const double *force, const struct body *body)
{
    const struct bond_view view = bonds_view(bonds, strip);
    for (int k = 0; k < strip->count; k++) {
        const int g = k * view.geometry_step;
        if (!(body->grid.flags[bond_lower(&view, k)] & SITE_OWNED))
            continue; /* counted by the owner */
        for (int b = 0; b < 3; b++) {
            const int beyond = periods_beyond(bonds, strip, b, k);
            const double way =
                beyond * lattice_period(body->lattice, b) * view.volume_i[g] * view.volume_j[g];
            for (int a = 0; beyond && a < 3; a++)
                exact_sum_add(&body->stress_sums[3 * a + b], way * (force[k] * y[a][k]));
        }
    }
}

void bond_stress_nodes(const struct body *body)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        for (int k = 0; k < 9; k++) {
            double terms[LANES];
            for (int i = 0; i < strip->count; i++) {
                double x[3];
                body_position(body, strip->site + i, x);
                terms[i] = body->f[k / 3][strip->site + i] * x[k % 3];
            }
            body_times_volume(body, strip->site, strip->count, terms);
            exact_sum_add_strip(&body->stress_sums[k], strip->count, terms, -1);
        }
    }
}
