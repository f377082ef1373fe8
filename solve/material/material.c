#include "material.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The models a material may name.  hardened: the model has a key "hardening". */
static const struct model {
    const char *name;
    bool hardened;
} models[] = {
    {"correspondence", true},          /* finite-strain J2 in logarithmic strain */
    {"correspondence_elastic", false}, /* the same without a yield point */
};
enum { MODEL_COUNT = sizeof models / sizeof *models };

static struct material read_material(struct deck_node map, const char *name)
{
    const char *names[MODEL_COUNT];
    for (int i = 0; i < MODEL_COUNT; i++) names[i] = models[i].name;
    const struct model *model = &models[deck_choice(deck_get(map, "model"), names, MODEL_COUNT)];
    deck_keys(map, (const char *const[]){"model", "density", "youngs_modulus", "poissons_ratio",
                                         model->hardened ? "hardening" : NULL, NULL});
    struct material m = {.name = name};
    m.density = deck_number(deck_get(map, "density"), "kg/m3", 1e-3, 1e6);
    m.youngs_modulus = deck_number(deck_get(map, "youngs_modulus"), "Pa", 1, 1e14);
    m.poissons_ratio = deck_number(deck_get(map, "poissons_ratio"), "1", -0.99, 0.4999);
    m.shear_modulus = m.youngs_modulus / (2 * (1 + m.poissons_ratio));
    m.bulk_modulus = m.youngs_modulus / (3 * (1 - 2 * m.poissons_ratio));
    m.hardening = model->hardened ? hardening_read(deck_get(map, "hardening")) : hardening_none();
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

struct materials materials_read(struct deck_node section, int n_phases, char *const phase_names[])
{
    struct materials all = {.count = n_phases,
                            .items = memory_new((size_t)n_phases, sizeof(struct material))};
    for (int i = 0; i < n_phases; i++) {
        struct deck_node map = deck_find(section, phase_names[i]);
        if (map.index == 0)
            deck_error(section, "no material for the domain's phase '%s'", phase_names[i]);
        all.items[i] = read_material(map, phase_names[i]);
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
