#include "yield.h"

#include "body.h"
#include "memory.h"
#include "random.h"

#include <math.h>

static const double most_deviations = 3;

static void read_flaw(struct deck_node map, struct yield_variation *yield)
{
    deck_keys(map, (const char *const[]){"centre", "radius", "reduction", NULL});
    struct deck_node centre = deck_get(map, "centre");
    if (!deck_is_list(centre) || deck_count(centre) != 3)
        deck_error(centre, "a list of three lengths is expected here");
    for (int a = 0; a < 3; a++)
        yield->centre[a] = deck_number(deck_item(centre, a), "m", -1e3, 1e3);
    yield->radius = deck_number(deck_get(map, "radius"), "m", 1e-12, 1e3);
    yield->reduction = deck_number(deck_get(map, "reduction"), "1", 0, 0.99);
    yield->flawed = true;
}

static void read_scatter(struct deck_node map, struct yield_variation *yield)
{
    deck_keys(map, (const char *const[]){"deviation", "seed", NULL});
    /* Three deviations leave a tenth of the yield stress. */
    yield->deviation = deck_number(deck_get(map, "deviation"), "1", 0, 0.3);
    yield->seed = deck_integer(deck_get(map, "seed"), 0, 2147483647);
    yield->scattered = true;
}

struct yield_variation yield_read(struct deck_node material)
{
    struct yield_variation yield = {0};
    if (deck_has(material, "flaw")) read_flaw(deck_get(material, "flaw"), &yield);
    if (deck_has(material, "yield_scatter"))
        read_scatter(deck_get(material, "yield_scatter"), &yield);
    return yield;
}

static double uniform(uint64_t hash)
{
    return ((double)(hash >> 11) + 0.5) * 0x1p-53;
}

/* A number of the normal distribution for a node (Box, Muller, Ann. Math. Stat. 29 (1958) 610); beyond three
 * it is drawn again, from the next number. */
static double normal(const struct yield_variation *yield, const char *phase, uint64_t node)
{
    const double pi = acos(-1);
    for (uint64_t draw = 0;; draw++) {
        const uint64_t number = (node << 8 | draw) << 1;
        double radius = sqrt(-2 * log(uniform(random_hash(yield->seed, phase, number))));
        double value = radius * cos(2 * pi * uniform(random_hash(yield->seed, phase, number | 1)));
        if (fabs(value) <= most_deviations) return value;
    }
}

static double factor(const struct yield_variation *yield, const char *phase, const double x[3],
                     uint64_t node)
{
    double k = 1, square = 0;
    for (int a = 0; a < 3; a++) square += (x[a] - yield->centre[a]) * (x[a] - yield->centre[a]);
    if (yield->flawed) k *= 1 - yield->reduction * exp(-square / (yield->radius * yield->radius));
    if (yield->scattered) k *= 1 + yield->deviation * normal(yield, phase, node);
    return k;
}

void yield_vary(struct body *body, int phase, const struct yield_variation *yield, const char *name,
                double stress)
{
    if (!yield->flawed && !yield->scattered) return;
    if (!body->yield_shift)
        body->yield_shift = memory_new((size_t)body->grid.n_sites, sizeof *body->yield_shift);
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        double x[3];
        if (body->grid.phase[site] != phase) continue;
        body_position(body, site, x);
        body->yield_shift[site] =
            (factor(yield, name, x, (uint64_t)body_number(body, site)) - 1) * stress;
    }
}
