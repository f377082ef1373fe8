/* ductile.c - the stress of a node is degraded by its equivalent plastic strain, until the node is
 * removed.
 *
 *   D = min((p - p_c)/(p_f - p_c), 1) beyond p_c = onset, 0 before                      (ductile.1)
 *   exp p_f = exp onset + (exp full - exp onset) length/dx; p_f = full without a length (ductile.2)
 *
 * The stress is (1 - D) times that of the sound material, which flows on (degradation.h); beyond
 * p_f all bonds of the node break.  D is that of the state committed last, so that it stands still
 * while a force is evaluated or an equilibrium sought.  D linear in p is Lemaitre's law, J. Eng.
 * Mater. Technol. 107 (1985) 83, at constant triaxiality, but to D = 1.
 *
 * Strain that softens gathers in a band as wide as the lattice can resolve, a fixed number of
 * spacings.  exp p is the stretch of a band in uniaxial flow: with (ductile.2) the band lengthens
 * between p_c and p_f by the same at any spacing, as the crack band of Bazant, Oh, Mater. Constr.
 * 16 (1983) 155, whose softening is scaled by its width. */
#include "damage.h"
#include "die.h"

#include <math.h>

struct ductile {
    double onset, full; /* p_c, and p_f once it is read */
    double length;
};
#define AT(member) offsetof(struct ductile, member)

static const struct key keys[] = {
    {"onset", KEY_NUMBER, AT(onset), "1", 0, 100, .required = true,
     .help = "plastic strain at which D begins to rise; well below 0.65, from where on strain "
             "gathers in one or two layers of nodes, damage or not"},
    {"full", KEY_NUMBER, AT(full), "1", 0, 100, .required = true,
     .help = "plastic strain at which D is 1 and all bonds of the node break"},
    {"length", KEY_LENGTH, AT(length), NULL, 1e-12, 1e3, .otherwise = "none",
     .help = "spacing for which full is meant; at another one exp(full) - exp(onset) is scaled by "
             "length/spacing, which halves the effect of the spacing on the strain at fracture"},
};

static void read(void *own, struct deck_node entry, double spacing)
{
    struct ductile *law = own;
    if (!(law->full > law->onset))
        deck_error(deck_get(entry, "full"), "%g, expected more than 'onset' (%g)", law->full,
                   law->onset);
    if (!(law->length > 0)) return;
    law->full = log(exp(law->onset) + (exp(law->full) - exp(law->onset)) * law->length / spacing);
    note("damage: nodes of '%s' are removed at a plastic strain of %.4g",
         deck_string(deck_get(entry, "phase")), law->full);
}

static double least(const void *own)
{
    return ((const struct ductile *)own)->onset;
}

/* (ductile.1) */
static double degradation(const void *own, const double state[])
{
    const struct ductile *law = own;
    return (state[0] - law->onset) / (law->full - law->onset);
}

static double limit(const void *own, const double state[])
{
    (void)state;
    return ((const struct ductile *)own)->full;
}

const struct damage_law damage_ductile = {
    .words = {"ductile",
              "The stress of a node is multiplied by 1 - D, D rising from 0 at onset to 1 at full; "
              "without it correspondence hardly fractures, as broken bonds alone do not unload it.",
              KEYS(keys)},
    .size = sizeof(struct ductile),
    .states = {"equivalent_plastic_strain"},
    .read = read,
    .least = least,
    .degradation = degradation,
    .limit = limit,
};
