/* bond_energy.c - (bond_energy.1): a bond that is longer than at rest breaks when it holds more than an energy density w_c
 * [J/m^6]; from a fracture energy by (opening.3), which is the same for all bonds and materials (Foster,
 * Silling, Chen, Int. J. Multiscale Comput. Eng. 9 (2011) 675).  What an ordinary bond holds is that of the
 * force states of its ends as they are, over its elastic extension; theirs is the work done on it so far,
 * the same where the strain grows in proportion. */
#include "bond_ends.h"
#include "damage.h"
#include "opening.h"

static void room(const struct damage_view *see, const struct bond_strip *strip,
                 const struct bond_view *bond, const double *value, double *out)
{
    const struct model *model = see->model;
    double energy[BOND_LANES], extension[BOND_LANES], displacement[6][BOND_LANES];
    const struct bond_ends ends = bond_ends_find(bond, see->body, displacement);
    model->formulation->bond_energy(model->self, see->body, strip, energy);
    bond_ends_extensions(bond, &ends, extension);
    for (int k = 0; k < bond->count; k++)
        out[k] = energy[k] > value[k] && extension[k] > 0
                     ? bond->length[k * bond->geometry_step] * (1 - energy[k] / value[k])
                     : 0;
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
    .room = room,
    .from_fracture_energy = from_fracture_energy,
    .check = check,
};
