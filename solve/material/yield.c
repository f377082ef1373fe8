#include "yield.h"

#include "body.h"
#include "die.h"
#include "flow_curve.h"
#include "law.h"
#include "material.h"
#include "memory.h"
#include "random.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

static const double most_deviations = 3;

#define PLACE(member) .place = offsetof(struct yield, member)

static const struct key flaw_keys[] = {
    {"centre", KEY_NUMBER, PLACE(centre), "m", -1e3, 1e3, .size = 3, .required = true,
     .help = "c, where it is softest; the body is centred at the origin"},
    {"radius", KEY_NUMBER, PLACE(radius), "m", 1e-12, 1e3, .required = true,
     .help = "R, within which the softening falls to 1/e"},
    {"reduction", KEY_NUMBER, PLACE(reduction), "1", 0, 0.99, .required = true,
     .help = "r, share of the yield stress that is missing at the centre"},
};
static const struct section section_flaw = {
    .path = "materials.NAME.flaw",
    .help =
        "A softer place, where a neck starts: the yield stress of the phase is multiplied by 1 - r "
        "exp(-|x - c|^2/R^2).",
    .keys = KEYS(flaw_keys),
};

/* Three deviations leave a tenth of the yield stress. */
static const struct key scatter_keys[] = {
    {"deviation", KEY_NUMBER, PLACE(deviation), "1", 0, 0.3, .required = true,
     .help = "d, standard deviation of the factor"},
    {"seed", KEY_INTEGER, PLACE(seed), NULL, 0, 2147483647, .required = true,
     .help = "of the random numbers, which follow from it, the phase's name and the node"},
};
static const struct section section_scatter = {
    .path = "materials.NAME.yield_scatter",
    .help = "A yield stress that varies from node to node: it is multiplied by 1 + d g, g a number "
            "of the normal distribution, cut at three deviations.",
    .keys = KEYS(scatter_keys),
};

const struct key yield_keys[YIELD_KEYS] = {
    {"hardening", KEY_NODE, PLACE(node), .required = true, .section = &section_hardening,
     .help = "true stress against equivalent logarithmic plastic strain"},
    {"flaw", KEY_SECTION, .section = &section_flaw, .otherwise = "none",
     .form = "{centre: [x, y, z], radius: R, reduction: r}", .help = "a softer place"},
    {"yield_scatter", KEY_SECTION, .section = &section_scatter, .otherwise = "none",
     .form = "{deviation: d, seed: n}", .help = "a yield stress that varies from node to node"},
};

void yield_read(struct deck_node material, void *self)
{
    struct yield *yield = self;
    yield->material = material;
    yield->hardening = hardening_read(yield->node);
}

void yield_release(void *self)
{
    hardening_free(&((struct yield *)self)->hardening);
}

const struct yield *yield_of(const void *self)
{
    return self;
}

void *yield_pairs(int count, const void *const first[], const void *const second[])
{
    const struct hardening none = hardening_none(),
                           **ends = memory_new(2 * (size_t)count, sizeof *ends);
    for (int k = 0; k < count; k++) {
        ends[k] = first[k] ? &((const struct yield *)first[k])->hardening : &none;
        ends[count + k] = second[k] ? &((const struct yield *)second[k])->hardening : &none;
    }
    double *table = flow_curves_new(count, ends, ends + count);
    free(ends);
    return table;
}

static double uniform(uint64_t hash)
{
    return ((double)(hash >> 11) + 0.5) * 0x1p-53;
}

/* A number of the normal distribution cut at most_deviations, for a node: the inverse of its
 * cumulated distribution at the node's own random number. */
static double normal(const struct yield *yield, const char *phase, uint64_t node)
{
    const double least = gsl_cdf_ugaussian_P(-most_deviations);
    return gsl_cdf_ugaussian_Pinv(least +
                                  (1 - 2 * least) * uniform(random_hash(yield->seed, phase, node)));
}

/* Of an image the bits of the original. */
static double factor(const struct yield *yield, const char *phase, const struct lattice *lattice,
                     int64_t node)
{
    double k = 1, square = 0, x[3];
    int at[3];
    lattice_position(lattice, node, at);
    lattice_particle(lattice, at, x);
    for (int a = 0; a < 3; a++) {
        const double period = lattice->periodic[a] ? lattice_period(lattice, a) : 0,
                     apart = lattice_shortest(x[a] - yield->centre[a], period);
        square += apart * apart;
    }
    if (yield->radius > 0)
        k *= 1 - yield->reduction * exp(-square / (yield->radius * yield->radius));
    if (yield->deviation > 0) k *= 1 + yield->deviation * normal(yield, phase, (uint64_t)node);
    return k;
}

static const struct yield *yield_of_phase(const struct materials *materials, int phase)
{
    const struct material *material = &materials->items[phase];
    return material->law && material->law->yield ? material->law->yield(material->parameters)
                                                 : NULL;
}

double yield_first_strain(const struct materials *materials)
{
    double least = INFINITY;
    for (int p = 0; p < materials->count; p++) {
        const struct yield *yield = yield_of_phase(materials, p);
        if (yield)
            least = fmin(least, hardening_stress(&yield->hardening, 0) /
                                    materials->items[p].youngs_modulus);
    }
    return least;
}

double yield_strongest(const struct materials *materials, double p, int *phase)
{
    double most = 0;
    for (int k = 0; k < materials->count; k++) {
        const struct yield *yield = yield_of_phase(materials, k);
        const double stress = yield ? hardening_stress(&yield->hardening, p) : INFINITY;
        if (stress > most) *phase = k;
        most = fmax(most, stress);
    }
    return most;
}

static void check_planes(const struct yield *yield, const struct body *body)
{
    const struct lattice *lattice = body->lattice;
    const double rounding = 1e-6;
    for (int a = 0; a < 3; a++) {
        if (!lattice->mirror[a]) continue;
        const double plane = lattice->origin[a];
        if (yield->radius > 0 && fabs(yield->centre[a] - plane) > rounding * lattice->spacing)
            deck_error(deck_get(deck_get(yield->material, "flaw"), "centre"),
                       "the flaw's %c, %g m, is not in the plane of symmetry across %c, at %g m, "
                       "which would make other flaws of it: put it there, or solve the whole body",
                       'x' + a, yield->centre[a], 'x' + a, plane);
        if (yield->deviation > 0 && body->ranks.rank == 0)
            warn("below the plane of symmetry across %c the yield scatters as above, not on its "
                 "own",
                 'x' + a);
    }
}

void yield_start(struct body *body, const struct materials *materials)
{
    bool varies = false;
    for (int p = 0; p < materials->count; p++) {
        const struct yield *yield = yield_of_phase(materials, p);
        if (yield) check_planes(yield, body);
        varies |= yield && (yield->radius > 0 || yield->deviation > 0);
    }
    if (!varies) return;
    body->yield_shift = memory_new((size_t)body->grid.n_sites, sizeof *body->yield_shift);
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        const int phase = body->grid.phase[site];
        const struct yield *yield = phase == ABSENT ? NULL : yield_of_phase(materials, phase);
        if (!yield) continue;
        const double k =
            factor(yield, materials->items[phase].name, body->lattice, body_number(body, site));
        body->yield_shift[site] = (k - 1) * hardening_stress(&yield->hardening, 0);
    }
}
