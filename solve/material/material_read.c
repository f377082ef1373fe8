#include "material_read.h"

#include "die.h"
#include "laws.h"
#include "memory.h"
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The models a material may name. */
enum {
    CORNER,
    CORRESPONDENCE,
    CORRESPONDENCE_ELASTIC,
    BOND_BASED,
    ORDINARY,
    ORDINARY_PLASTIC,
    MADENCI_OTERKUS,
    MODELS
};
static const char *const models[] = {
    "corner",   "correspondence",   "correspondence_elastic", "bond_based",
    "ordinary", "ordinary_plastic", "madenci_oterkus",        NULL};
static const struct kind {
    const struct formulation *formulation;
    const struct law *law; /* NULL: that of the key law */
    bool central;          /* central forces alone, which fix Poisson's ratio */
    bool spatial;          /* not in a plane */
    bool strained;         /* not in plane stress: its strain across the plane is zero */
} kinds[MODELS] = {
    [CORNER] = {.formulation = &formulation_corner},
    [CORRESPONDENCE] = {&formulation_correspondence, NULL, .strained = true},
    [CORRESPONDENCE_ELASTIC] = {&formulation_correspondence, &law_elastic, .strained = true},
    [BOND_BASED] = {&formulation_bond_based, &law_elastic, .central = true},
    [ORDINARY] = {&formulation_ordinary, &law_elastic, .central = false},
    [ORDINARY_PLASTIC] = {&formulation_ordinary, &law_mitchell, .spatial = true},
    [MADENCI_OTERKUS] = {&formulation_madenci_oterkus, &law_elastic, .central = false},
};

/* What the rows below fill; moduli that the deck does not give are NAN. */
enum { E, NU, K, G, ELASTIC };
struct given {
    int model;
    double density, elastic[ELASTIC];
};
#define AT(member) offsetof(struct given, member)
#define MODULUS(name, which, words)                                                                \
    {                                                                                              \
        name, KEY_NUMBER, AT(elastic[which]), "Pa", 1, 1e14, .usual = NAN, .otherwise = TWO,       \
                                                             .help = words                         \
    }
#define TWO "of the four two are given, of bond_based one modulus"

static const struct key keys[] = {
    {"model", KEY_CHOICE, AT(model), .required = true, .names = models,
     .help = "all phases of a body take models of one formulation: corner (a law of particles "
             "whose corners move), correspondence (a law of its nodes; correspondence_elastic is "
             "that with law: elastic), bond_based (central "
             "forces), ordinary (linear peridynamic solid; ordinary_plastic with Mitchell's "
             "plasticity, in three dimensions), madenci_oterkus (ordinary with the constants a, b, "
             "d of the continuum)"},
    {"density", KEY_NUMBER, AT(density), "kg/m3", 1e-3, 1e6, .required = true, .help = "at rest"},
    MODULUS("youngs_modulus", E, "E"),
    {"poissons_ratio", KEY_NUMBER, AT(elastic[NU]), "1", -0.99, 0.4999, .usual = NAN,
     .otherwise = TWO, .help = "nu; of bond_based it is 1/4, in plane stress 1/3"},
    MODULUS("bulk_modulus", K, "K"),
    MODULUS("shear_modulus", G, "G"),
};
const struct section section_materials = {
    .path = "materials.NAME",
    .help = "What the phase of that name is made of.",
    .keys = KEYS(keys),
    .chooser = "law",
    .variant = law_variant,
    .usual = LAW_j2,
};

/* Poisson's ratio of central forces: 1/4, in plane stress 1/3. */
static double central_ratio(enum plane plane)
{
    return plane == PLANE_STRESS ? 1.0 / 3 : 0.25;
}

/* E and nu from two of E, nu, K, G; of a material of central forces, which has its nu, from one. */
static void find_moduli(struct deck_node map, const struct kind *kind, enum plane plane,
                        const double given[ELASTIC], struct material *m)
{
    double value[ELASTIC];
    bool has[ELASTIC];
    int count = 0;
    for (int k = 0; k < ELASTIC; k++) {
        value[k] = given[k];
        has[k] = !isnan(value[k]);
        count += has[k];
    }
    if (kind->central) {
        const double ratio = central_ratio(plane);
        if (has[NU] && !(fabs(value[NU] - ratio) < 1e-3))
            deck_error(deck_get(map, "poissons_ratio"),
                       "%g: a bond-based material has Poisson's ratio %s, whatever its deck says; "
                       "leave it out, or take an ordinary one",
                       value[NU], plane == PLANE_STRESS ? "1/3 in plane stress" : "1/4");
        count += !has[NU];
        has[NU] = true;
        value[NU] = ratio;
    }
    if (count != 2)
        deck_error(map, "material '%s' needs %s", m->name,
                   kind->central ? "one of youngs_modulus, bulk_modulus and shear_modulus"
                                 : "two of youngs_modulus, poissons_ratio, bulk_modulus and "
                                   "shear_modulus");
    if (has[K] && has[G]) {
        value[E] = 9 * value[K] * value[G] / (3 * value[K] + value[G]);
        value[NU] = (3 * value[K] - 2 * value[G]) / (2 * (3 * value[K] + value[G]));
    } else if (!has[NU]) {
        value[NU] =
            has[K] ? (3 * value[K] - value[E]) / (6 * value[K]) : value[E] / (2 * value[G]) - 1;
    } else if (!has[E]) {
        value[E] = has[K] ? 3 * value[K] * (1 - 2 * value[NU]) : 2 * value[G] * (1 + value[NU]);
    }
    if (!(value[NU] >= -0.99 && value[NU] <= 0.4999))
        deck_error(
            map, "material '%s': its moduli give a Poisson's ratio of %g, expected -0.99 to 0.4999",
            m->name, value[NU]);
    m->youngs_modulus = value[E];
    m->poissons_ratio = value[NU];
    m->shear_modulus = value[E] / (2 * (1 + value[NU]));
    m->bulk_modulus = value[E] / (3 * (1 - 2 * value[NU]));
}

static int read_model(struct deck_node map)
{
    return keys_choice(deck_get(map, "model"), models);
}

/* Number of the law that the map's model has, or that it names. */
static int read_law(struct deck_node map, int model)
{
    int number = 0;
    if (!kinds[model].law) {
        number = keys_variant(map, &section_materials);
        if (!all_laws[number]->update)
            deck_error(deck_get(map, "law"), "%s is a law of bonds, which model: %s has",
                       all_laws[number]->words.name, models[ORDINARY_PLASTIC]);
        return number;
    }
    if (deck_has(map, "law"))
        deck_error(deck_get(map, "law"), "'law' belongs to model: %s, not to model: %s",
                   models[CORRESPONDENCE], models[model]);
    while (all_laws[number] != kinds[model].law) number++;
    return number;
}

static struct material read_material(struct deck_node map, const char *name, enum plane plane)
{
    const int model = read_model(map), law = read_law(map, model);
    const struct kind *kind = &kinds[model];
    struct given given;
    struct material m = {
        .name = name, .law = all_laws[law], .parameters = memory_new(all_laws[law]->parameters, 1)};
    keys_read(map, &section_materials, law, 0, &given, m.parameters);
    if (kind->spatial && plane != SPACE)
        deck_error(deck_get(map, "model"),
                   "%s is for bodies of three dimensions: in a plane its flow would keep the area, "
                   "which a metal's does not",
                   models[model]);
    if (kind->strained && plane == PLANE_STRESS)
        deck_error(deck_get(map, "model"),
                   "%s has no plane stress, since nothing moves across its plane: take 'plane: "
                   "strain', corner, or an ordinary material",
                   models[model]);
    m.density = given.density;
    find_moduli(map, kind, plane, given.elastic, &m);
    if (m.law->read) m.law->read(map, m.parameters);
    return m;
}

/* Which of all->laws a phase obeys. */
static int law_of_phase(const struct materials *all, int phase)
{
    int k = 0;
    while (all->laws[k].law != all->items[phase].law) k++;
    return k;
}

static void find_laws(struct materials *all)
{
    all->laws = memory_new(LAW_COUNT, sizeof *all->laws);
    for (int k = 0; k < LAW_COUNT; k++) {
        bool used = false;
        for (int p = 0; p < all->count; p++) used |= all->items[p].law == all_laws[k];
        if (used) all->laws[all->n_laws++].law = all_laws[k];
    }
    for (int k = 0; k < all->n_laws; k++) {
        int states = 0;
        while (law_state(states)) states++;
        all->laws[k].component = memory_new((size_t)states, sizeof(int));
        for (int i = 0; i < states; i++)
            all->laws[k].component[i] = law_component(all->laws[k].law, law_state(i)->name);
    }
}

/* Parameters of the phases of each pair that obeys this law: of a phase of another law those of the
 * pair's other end. */
static void find_parameters(const struct materials *all, int law, const void **first,
                            const void **second)
{
    const int n = all->count;
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            const int pair = a * n + b;
            first[pair] = second[pair] = NULL;
            if (all->law_of[pair] != law) continue;
            const bool of_a = law_of_phase(all, a) == law, of_b = law_of_phase(all, b) == law;
            first[pair] = all->items[of_a ? a : b].parameters;
            second[pair] = all->items[of_b ? b : a].parameters;
        }
}

static void make_pairs(struct materials *all)
{
    const int n = all->count;
    const size_t pairs = (size_t)(n * n);
    all->shear = memory_new(pairs, sizeof(double));
    all->bulk = memory_new(pairs, sizeof(double));
    all->law_of = memory_new(pairs, sizeof(int));
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            const struct material *ma = &all->items[a], *mb = &all->items[b];
            const int law[] = {law_of_phase(all, a), law_of_phase(all, b)};
            all->shear[a * n + b] = 0.5 * (ma->shear_modulus + mb->shear_modulus);
            all->bulk[a * n + b] = 0.5 * (ma->bulk_modulus + mb->bulk_modulus);
            all->law_of[a * n + b] = law[0] < law[1] ? law[0] : law[1];
        }
    const void **first = memory_new(2 * pairs, sizeof *first);
    for (int k = 0; k < all->n_laws; k++) {
        if (!all->laws[k].law->pairs) continue;
        find_parameters(all, k, first, first + pairs);
        all->laws[k].pairs = all->laws[k].law->pairs(n * n, first, first + pairs);
    }
    free(first);
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
        const struct formulation *formulation = kinds[read_model(map)].formulation;
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
    find_laws(&all);
    make_pairs(&all);
    return all;
}
