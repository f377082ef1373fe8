/* family_sums.h - sums over whole families of lattice sites, column by column.
 *
 *   G_b(i) = sum_o w_o xi_b [a(i + xi_o) - a(i - xi_o)]  over the half offsets o    (family_sums.1)
 *
 * Members with the same y and z lie on a column along x, and columns at (y, z) and (-y, -z) have
 * the same weights. With E_k(i) = sum_c w_kc [a(i + c) + a(i - c)] over the columns c that a family
 * meets at |x| = k, and O_k the same with y (or z) and the difference,
 *
 *   G_x = sum_k k [E_k(i + k) - E_k(i - k)],   G_y = O_0(i) + sum_k [O_k(i + k) + O_k(i - k)]
 *                                                                                   (family_sums.2)
 *
 * E_k is E_k+1 and what changes from there on: where the weights are alike, each column is added
 * once.  So a family of 122 takes 14 pairs of columns a component instead of 46 pairs of members.
 */
#ifndef HS_FAMILY_SUMS_H
#define HS_FAMILY_SUMS_H

#include "grid.h"

/* out[i] += G_b(i) for count sites from the one that field points to.  Of the family, all members
 * are there, or field is zero; up to a vector's length of field behind the last family is read,
 * too. */
void family_sums_add(const struct family *family, const struct grid *grid, int b, int count,
                     const double *field, double *out);

#endif
