/* plastic_strain.c - (plastic_strain.1): all bonds of a node break once its equivalent plastic strain is beyond a value. */
#include "damage.h"

static void check(const struct damage_view *see, struct deck_node where)
{
    if (!see->materials->formulation->plastic_strain)
        deck_error(where, "%s materials have no plastic strain", see->materials->formulation->name);
}

const struct damage_law damage_plastic_strain = {
    .name = "plastic_strain",
    .unit = "1",
    .most = 100,
    .check = check,
};
