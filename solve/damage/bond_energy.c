/* bond_energy.c - (bond_energy.1): a bond that is longer than at rest breaks when it holds more
 * than an energy density w_c [J/m^6]; from a fracture energy by (opening.3), which is the same for
 * all bonds and materials (Foster, Silling, Chen, Int. J. Multiscale Comput. Eng. 9 (2011) 675).
 * What an ordinary bond holds is that of the force states of its ends as they are, over its elastic
 * extension; theirs is the work done on it so far, the same where the strain grows in proportion.
 */
#include "bond_loop.h"
#include "damage.h"
#include "opening.h"

/* |xi| (1 - w/w_c) of a bond beyond w_c, else 0: what it holds does not tell how far its ends may
 * still move. */
HS_INLINE void find_margin(const struct bond_pass *p, int k, struct bond b)
{
    const double allowed = p->given[0][k], held = p->given[1][k];
    p->each[0][k] = held > allowed && b.longer > 0 ? b.length * (1 - held / allowed) : 0;
}
BOND_KERNELS(find_margins, find_margin(p, k, b))

static void margin(const struct damage_view *see, const struct bond_strip *strip,
                   const double *value, double *margin)
{
    const struct model *model = see->model;
    double energy[BOND_LANES];
    struct bond_pass pass = {.given = {value, energy}, .each = {margin}};
    model->formulation->bond_energy(model->self, see->body, strip, energy);
    bond_run(find_margins, see->bonds, strip, (struct bond_fields){0}, &pass);
}

static double from_fracture_energy(const struct damage_view *see, int a, int b, double energy,
                                   struct deck_node where)
{
    (void)a, (void)b, (void)where;
    return energy * opening_energy_density(see->body->family, see->body->lattice);
}

static void check(const struct damage_view *see, struct deck_node where)
{
    if (!see->materials->formulation->bond_energy)
        deck_error(where, "bonds of %s materials have no energy of their own: use %s or %s",
                   see->materials->formulation->name, damage_critical_stretch.words.name,
                   damage_plastic_strain.words.name);
}

static const struct key keys[] = {{"value", KEY_NUMBER, 0, "J/m6", 1e-12, 1e60,
                                   .otherwise = "by fracture_energy",
                                   .help = "energy density of a bond longer than at rest"}};

const struct damage_law damage_bond_energy = {
    .words = {"bond_energy",
              "A bond longer than at rest breaks beyond an energy density; not for correspondence.",
              KEYS(keys)},
    .size = sizeof(double),
    .margin = margin,
    .from_fracture_energy = from_fracture_energy,
    .check = check,
};
