#include "material_plausible.h"

#include "hardening.h"

static const double softest = 1e6, stiffest = 2e12;  /* Pa */
static const double lightest = 10, heaviest = 30000; /* kg/m^3 */
static const double strongest = 0.1;                 /* yield over E */
static const double first_flow = 0.01; /* plastic strain at which hardening is looked at */

#define ACCEPT " ('accept: true' in solver takes it as it is)"

/* Of the deck's keys the one that is there, or the whole mapping. */
static struct deck_node key_or(struct deck_node map, const char *key)
{
    const struct deck_node node = deck_find(map, key);
    return node.index ? node : map;
}

static void check_moduli(const struct material *m, struct deck_node map)
{
    const double E = m->youngs_modulus, density = m->density;
    if (E < softest || E > stiffest)
        deck_error(
            key_or(map, "youngs_modulus"),
            "Young's modulus of '%s' is %g Pa, expected 1 MPa to 2 TPa: did you mean %s?" ACCEPT,
            m->name, E, E < softest ? "GPa" : "MPa or Pa");
    if (density < lightest || density > heaviest)
        deck_error(
            key_or(map, "density"),
            "the density of '%s' is %g kg/m3, expected 10 to 30,000: did you mean %s?" ACCEPT,
            m->name, density, density < lightest ? "g/cm3, of which one is 1000 kg/m3" : "g/m3");
}

static void check_flow(const struct material *m, struct deck_node map)
{
    const double E = m->youngs_modulus;
    struct hardening flow = hardening_read(map);
    const double yield = flow.law->stress(&flow, 0),
                 slope = (flow.law->stress(&flow, first_flow) - yield) / first_flow;
    hardening_free(&flow);
    if (yield > strongest * E)
        deck_error(map,
                   "'%s' yields at %g MPa, over a tenth of its Young's modulus of %g MPa: did you "
                   "mean MPa, and the modulus in GPa?" ACCEPT,
                   m->name, 1e-6 * yield, 1e-6 * E);
    if (slope > E)
        deck_error(map,
                   "'%s' hardens by %g MPa in its first %g of plastic strain, faster than its "
                   "Young's modulus of %g MPa: did you mean MPa?" ACCEPT,
                   m->name, 1e-6 * slope * first_flow, first_flow, 1e-6 * E);
}

void material_check_plausible(const struct materials *materials, struct deck_node section)
{
    for (int p = 0; p < materials->count; p++) {
        const struct material *m = &materials->items[p];
        const struct deck_node map = deck_get(section, m->name),
                               hardening = deck_find(map, "hardening");
        check_moduli(m, map);
        if (hardening.index) check_flow(m, hardening);
    }
}
