/* critical_stretch.c - (critical_stretch.1): a bond breaks beyond a stretch s = (|y| - |xi|)/|xi|
 * (Silling, Askari, Computers & Structures 83 (2005) 1526); from a fracture energy G by s =
 * sqrt(G/a), (opening.1) and (opening.2).
 *
 * The law of brittle materials of central forces: a bond's stretch fixes its energy there.  The
 * margin is a length, s_c |xi| less the extension, so that the ways of the ends tell when it can be
 * used up (damage.c). */
#include "bond_loop.h"
#include "damage.h"

#include <math.h>

/* s_c |xi| - (|y| - |xi|) */
HS_INLINE void find_margin(const struct bond_pass *p, int k, struct bond b)
{
    p->each[0][k] = p->given[0][k] * b.length - bond_extension(b);
}
BOND_KERNELS(find_margins, find_margin(p, k, b))

static void margin(const struct damage_view *see, const struct bond_strip *strip,
                   const double *value, double *margin)
{
    struct bond_pass pass = {.given = {value}, .each = {margin}};
    bond_run(find_margins, see->bonds, strip, (struct bond_fields){0}, &pass);
}

static double from_fracture_energy(const struct damage_view *see, int a, int b, double energy,
                                   struct deck_node where)
{
    const struct formulation *formulation = see->materials->formulation;
    const int phases[2] = {a, b};
    double opening[2];
    if (!formulation->opening)
        deck_error(
            where,
            "%s materials have no formula for the stretch of a fracture energy: their stress "
            "comes from nodes, not from bonds; give 'value'",
            formulation->name);
    for (int k = 0; k < 2; k++)
        opening[k] = formulation->opening(&see->materials->items[phases[k]], see->materials->plane,
                                          see->body->family, see->body->lattice);
    return sqrt(energy /
                combine(see->series ? COMBINE_HARMONIC : COMBINE_MEAN, opening[0], opening[1]));
}

static const struct key keys[] = {{"value", KEY_NUMBER, 0, "1", 1e-12, 10,
                                   .otherwise = "by fracture_energy",
                                   .help = "(length - length at rest)/(length at rest)"}};

const struct damage_law damage_critical_stretch = {
    .words = {"critical_stretch", "A bond breaks beyond a stretch.", KEYS(keys)},
    .size = sizeof(double),
    .margin = margin,
    .from_fracture_energy = from_fracture_energy,
};
