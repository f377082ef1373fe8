/* ductile.c - the stress of a node is degraded by its equivalent plastic strain, until the node is removed.
 *
 *   D = min((p - p_c)/(p_f - p_c), 1) beyond p_c = onset, 0 before                       (ductile.1)
 *   exp p_f = exp onset + (exp full - exp onset) length/dx; p_f = full without a length   (ductile.2)
 *
 * The stress is (1 - D) times that of the sound material, which flows on (degradation.h); beyond p_f all bonds of the
 * node break.  D is that of the state committed last, so that it stands still while a force is evaluated or an
 * equilibrium sought.  D linear in p is Lemaitre's law, J. Eng. Mater. Technol. 107 (1985) 83, at constant triaxiality,
 * but to D = 1.
 *
 * Strain that softens gathers in a band as wide as the lattice can resolve, a fixed number of spacings.  exp p is the
 * stretch of a band in uniaxial flow: with (ductile.2) the band lengthens between p_c and p_f by the same at any
 * spacing, as the crack band of Bazant, Oh, Mater. Constr. 16 (1983) 155, whose softening is scaled by its width. */
#include "damage.h"
#include "die.h"

#include <math.h>

static void read_range(struct deck_node entry, double spacing, double range[2])
{
    deck_keys(entry, (const char *const[]){"phase", "law", "onset", "full", "length", NULL});
    struct deck_node full = deck_get(entry, "full");
    range[0] = deck_number(deck_get(entry, "onset"), "1", 0, 100);
    range[1] = deck_number(full, "1", 0, 100);
    if (!(range[1] > range[0]))
        deck_error(full, "%g: the node has to be gone beyond 'onset' (%g)", range[1], range[0]);
    if (!deck_has(entry, "length")) return;
    const double length = deck_length(deck_get(entry, "length"), spacing, 1e-12, 1e3);
    range[1] = log(exp(range[0]) + (exp(range[1]) - exp(range[0])) * length / spacing);
    note("damage: nodes of '%s' are removed at a plastic strain of %.4g",
         deck_string(deck_get(entry, "phase")), range[1]);
}

const struct damage_law damage_ductile = {
    .name = "ductile",
    .read_range = read_range,
};
