/* symbol.h - how stiffly the material answers to waves: what the static solver's preconditioner
 * inverts.
 *
 *   M_aa(k) = - sum_r A_aa(r) cos(k_x r_x) cos(k_y r_y) cos(k_z r_z)                     (symbol.1)
 *   M_ab(k) = - sum_r A_ab(r) sin(k_a r_a) sin(k_b r_b) cos(k_c r_c)                     (symbol.2)
 *
 * A_ab(r) is the force density along a at the distance r from a node that alone has been moved
 * along b; c: the third axis.  It is measured, not derived: one node is pushed in a block of the
 * same material under the same formulation, large enough that no free surface is felt.  So it holds
 * for every formulation, horizon and influence. */
#ifndef HS_SYMBOL_H
#define HS_SYMBOL_H

#include "model.h"

/* xx, yy, zz, yz, zx, xy */
enum { SYMBOL_ENTRIES = 6 };

struct symbol {
    int reach[3];                   /* sites, along each axis */
    double *answer[SYMBOL_ENTRIES]; /* -A_ab at r >= 0, [(reach + 1)^3], N/m^4, x fastest */
};

/* Of the elastic material of one phase.  Collective. */
struct symbol symbol_new(struct deck_node solver, const struct family *family,
                         const struct materials *materials, const struct lattice *lattice,
                         int phase);
void symbol_free(struct symbol *symbol);

/* values[(z n_y + y) n_x + x] = M of an entry at the wave numbers k[0][x], k[1][y], k[2][z] (per
 * site). */
void symbol_evaluate(const struct symbol *symbol, int entry, const int n[3], double *const k[3],
                     double *values);

#endif
