#include "material.h"

#include "die.h"
#include "memory.h"
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The models a material may name. */
static const struct kind {
    const char *name;
    const struct formulation *formulation;
    bool hardened; /* has a key "hardening" */
    bool central;  /* central forces alone, which fix Poisson's ratio */
    bool spatial;  /* not in a plane */
    bool strained; /* not in plane stress: its strain across the plane is zero */
} kinds[] = {
    /* J2, logarithmic strain; without yield */
    {"correspondence", &formulation_correspondence, .hardened = true, .strained = true},
    {"correspondence_elastic", &formulation_correspondence, .strained = true},
    /* prototype microelastic */
    {"bond_based", &formulation_bond_based, .central = true},
    /* linear peridynamic solid; Mitchell's plasticity */
    {"ordinary", &formulation_ordinary, .hardened = false},
    {"ordinary_plastic", &formulation_ordinary, .hardened = true, .spatial = true},
    /* a, b and d */
    {"madenci_oterkus", &formulation_madenci_oterkus, .hardened = false},
};
enum { KIND_COUNT = sizeof kinds / sizeof *kinds };

/* Poisson's ratio of central forces: 1/4, in plane stress 1/3. */
static double central_ratio(enum plane plane)
{
    return plane == PLANE_STRESS ? 1.0 / 3 : 0.25;
}

/* E and nu from two of E, nu, K, G; of a material of central forces, which has its nu, from one. */
static void read_elasticity(struct deck_node map, const struct kind *kind, enum plane plane,
                            struct material *m)
{
    static const char *const keys[] = {"youngs_modulus", "poissons_ratio", "bulk_modulus",
                                       "shear_modulus"};
    enum { E, NU, K, G };
    double value[4];
    bool given[4];
    int count = 0;
    for (int k = 0; k < 4; k++) {
        given[k] = deck_has(map, keys[k]);
        if (!given[k]) continue;
        struct deck_node node = deck_get(map, keys[k]);
        value[k] =
            k == NU ? deck_number(node, "1", -0.99, 0.4999) : deck_number(node, "Pa", 1, 1e14);
        count++;
    }
    if (kind->central) {
        const double ratio = central_ratio(plane);
        if (given[NU] && !(fabs(value[NU] - ratio) < 1e-3))
            deck_error(deck_get(map, keys[NU]),
                       "%g: a bond-based material has Poisson's ratio %s, whatever its deck says; "
                       "leave it out, or take an ordinary one",
                       value[NU], plane == PLANE_STRESS ? "1/3 in plane stress" : "1/4");
        count += !given[NU];
        given[NU] = true;
        value[NU] = ratio;
    }
    if (count != 2)
        deck_error(map, "material '%s' needs %s", m->name,
                   kind->central ? "one of youngs_modulus, bulk_modulus and shear_modulus"
                                 : "two of youngs_modulus, poissons_ratio, bulk_modulus and "
                                   "shear_modulus");
    if (given[K] && given[G]) {
        value[E] = 9 * value[K] * value[G] / (3 * value[K] + value[G]);
        value[NU] = (3 * value[K] - 2 * value[G]) / (2 * (3 * value[K] + value[G]));
    } else if (!given[NU]) {
        value[NU] =
            given[K] ? (3 * value[K] - value[E]) / (6 * value[K]) : value[E] / (2 * value[G]) - 1;
    } else if (!given[E]) {
        value[E] = given[K] ? 3 * value[K] * (1 - 2 * value[NU]) : 2 * value[G] * (1 + value[NU]);
    }
    if (!(value[NU] > -0.99 && value[NU] < 0.4999))
        deck_error(map, "material '%s': its moduli give a Poisson's ratio of %g", m->name,
                   value[NU]);
    m->youngs_modulus = value[E];
    m->poissons_ratio = value[NU];
    m->shear_modulus = value[E] / (2 * (1 + value[NU]));
    m->bulk_modulus = value[E] / (3 * (1 - 2 * value[NU]));
}

static const struct kind *read_kind(struct deck_node map)
{
    const char *names[KIND_COUNT];
    for (int i = 0; i < KIND_COUNT; i++) names[i] = kinds[i].name;
    return &kinds[deck_choice(deck_get(map, "model"), names, KIND_COUNT)];
}

static struct material read_material(struct deck_node map, const char *name, enum plane plane)
{
    const struct kind *kind = read_kind(map);
    deck_keys(map, (const char *const[]){"model", "density", "youngs_modulus", "poissons_ratio",
                                         "bulk_modulus", "shear_modulus",
                                         kind->hardened ? "hardening" : NULL, "flaw",
                                         "yield_scatter", NULL});
    if (kind->spatial && plane != SPACE)
        deck_error(deck_get(map, "model"),
                   "%s is for bodies of three dimensions: in a plane its flow would keep the area, "
                   "which a metal's does not",
                   kind->name);
    if (kind->strained && plane == PLANE_STRESS)
        deck_error(deck_get(map, "model"),
                   "%s has no plane stress, since nothing moves across its plane: take 'plane: "
                   "strain', or an ordinary material",
                   kind->name);
    struct material m = {.name = name, .yields = kind->hardened};
    m.density = deck_number(deck_get(map, "density"), "kg/m3", 1e-3, 1e6);
    read_elasticity(map, kind, plane, &m);
    if (kind->hardened) m.yield = yield_read(map);
    m.hardening = kind->hardened ? hardening_read(deck_get(map, "hardening")) : hardening_none();
    return m;
}

static void make_pairs(struct materials *all)
{
    const int n = all->count;
    const struct hardening **first = memory_new((size_t)(n * n), sizeof *first);
    const struct hardening **second = memory_new((size_t)(n * n), sizeof *second);
    all->shear = memory_new((size_t)(n * n), sizeof(double));
    all->bulk = memory_new((size_t)(n * n), sizeof(double));
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            const struct material *ma = &all->items[a], *mb = &all->items[b];
            first[a * n + b] = &ma->hardening;
            second[a * n + b] = &mb->hardening;
            all->shear[a * n + b] = 0.5 * (ma->shear_modulus + mb->shear_modulus);
            all->bulk[a * n + b] = 0.5 * (ma->bulk_modulus + mb->bulk_modulus);
        }
    all->curves = flow_curves_new(n * n, first, second);
    free(first);
    free(second);
}

struct materials materials_read(struct deck_node section, int n_phases, char *const phase_names[],
                                enum plane plane)
{
    struct materials all = {.count = n_phases,
                            .plane = plane,
                            .items = memory_new((size_t)n_phases, sizeof(struct material))};
    for (int i = 0; i < n_phases; i++) {
        struct deck_node map = deck_find(section, phase_names[i]);
        if (map.index == 0)
            deck_error(section, "no material for the domain's phase '%s'", phase_names[i]);
        all.items[i] = read_material(map, phase_names[i], plane);
        const struct formulation *formulation = read_kind(map)->formulation;
        if (i > 0 && formulation != all.formulation)
            deck_error(deck_get(map, "model"),
                       "all materials of a body share one formulation: '%s' is %s, '%s' is %s",
                       phase_names[i], formulation->name, phase_names[0], all.formulation->name);
        all.formulation = formulation;
    }
    for (int i = 0; i < deck_count(section); i++) {
        bool used = false;
        for (int k = 0; k < n_phases; k++)
            used |= strcmp(deck_key(section, i), phase_names[k]) == 0;
        if (!used) note("material '%s' is not in this domain", deck_key(section, i));
    }
    make_pairs(&all);
    return all;
}

void materials_free(struct materials *all)
{
    for (int i = 0; i < all->count; i++) hardening_free(&all->items[i].hardening);
    free(all->items);
    free(all->shear);
    free(all->bulk);
    flow_curves_free(&all->curves);
    *all = (struct materials){0};
}

void materials_vary_yield(const struct materials *all, struct body *body)
{
    for (int p = 0; p < all->count; p++) {
        const struct material *m = &all->items[p];
        yield_vary(body, p, &m->yield, m->name, hardening_stress(&m->hardening, 0));
    }
}

double material_bulk_modulus(const struct material *m, enum plane plane)
{
    const double nu = m->poissons_ratio;
    if (plane == PLANE_STRESS) return m->youngs_modulus / (2 * (1 - nu));
    if (plane == PLANE_STRAIN) return m->youngs_modulus / (2 * (1 + nu) * (1 - 2 * nu));
    return m->bulk_modulus;
}

double materials_wave_speed(const struct materials *all)
{
    double fastest = 0;
    for (int i = 0; i < all->count; i++) {
        const struct material *m = &all->items[i];
        double speed = sqrt((m->bulk_modulus + 4 * m->shear_modulus / 3) / m->density);
        fastest = fmax(fastest, speed);
    }
    return fastest;
}

double materials_stiffest(const struct materials *all)
{
    double most = 0;
    for (int i = 0; i < all->count; i++) most = fmax(most, all->items[i].youngs_modulus);
    return most;
}
