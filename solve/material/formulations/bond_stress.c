/* bond_stress.c - the nominal stress of bonds.
 *
 * For records alone, not in every step: so a strip's directions and force states are found once,
 * for both ends, and kept in buffers, from which each component is added in a loop of its own.  On
 * a lattice a bond that does not reach along an axis adds nothing to the stress there; of a family
 * of 122 a fifth of all components is left out so. */
#include "bond_stress.h"

#include "bond_loop.h"

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

static void find(const struct bonds *bonds, const struct bond_strip *strip, const double *extension,
                 const double *lower, const double *upper, double found[FOUND][BOND_LANES])
{
    struct bond_pass pass = {.given = {extension, lower, upper}};
    for (int k = 0; k < FOUND; k++) pass.each[k] = found[k];
    bond_run(find_directions, bonds, strip, (struct bond_fields){0}, &pass);
}

void bond_stress_add(const struct bonds *bonds, const struct bond_strip *strip,
                     const double *extension, const double *lower, const double *upper, int rows,
                     struct body *body)
{
    const struct bond_view view = bonds_view(bonds, strip);
    double found[FOUND][BOND_LANES], buffer[BOND_LANES];
    find(bonds, strip, extension, lower, upper, found);
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

void bond_stress_sum(const struct bonds *bonds, const struct bond_strip *strip,
                     const double *extension, const double *lower, const double *upper,
                     const struct body *body)
{
    const struct bond_view view = bonds_view(bonds, strip);
    double found[FOUND][BOND_LANES], force[BOND_LANES], terms[BOND_LANES];
    find(bonds, strip, extension, lower, upper, found);
    for (int k = 0; k < view.count; k++) {
        const int g = k * view.geometry_step;
        force[k] = found[PULL][k] * view.volume_i[g] + found[PULL_UPPER][k] * view.volume_j[g];
    }
    bonds_only_owned(bonds, strip, force);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            if (!view.geometry_step && view.xi[b][0] == 0) continue;
            for (int k = 0; k < view.count; k++)
                terms[k] = force[k] * found[Y + a][k] * view.xi[b][k * view.geometry_step];
            exact_sum_add_strip(&body->stress_sums[3 * a + b], view.count, terms, 1);
        }
}
