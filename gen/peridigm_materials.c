#include "die.h"
#include "memory.h"
#include "peridigm_deck.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct model {
    const char *name, *ours;
    bool flows, hardens, ordinary, bonds;
};

static const struct model models[] = {
    {"Elastic", "model: ordinary", false, false, true, false},
    {"Elastic Bond Based", "model: bond_based", false, false, false, true},
    {"Elastic Correspondence", "model: correspondence_elastic", false, false, false, false},
    {"Elastic Plastic", "model: ordinary_plastic, law: mitchell", true, false, true, false},
    {"Elastic Plastic Hardening", "model: ordinary_plastic, law: mitchell", true, true, true,
     false},
    {"Elastic Plastic Correspondence", "model: correspondence, law: j2", true, false, false, false},
    {"Isotropic Hardening Correspondence", "model: correspondence, law: j2", true, true, false,
     false},
};

static const struct model *find_model(struct translation *t, struct deck_node material,
                                      const char *name)
{
    const struct deck_node given = take(t, material, "Material Model");
    if (given.index == 0) deck_error(material, "material '%s' has no 'Material Model'", name);
    for (size_t i = 0; i < sizeof models / sizeof *models; i++)
        if (strcmp(deck_string(given), models[i].name) == 0) return &models[i];
    deck_error(given,
               "the material model '%.60s' has no counterpart; of Peridigm's there are Elastic, "
               "Elastic Bond Based, Elastic Correspondence, Elastic Plastic, Elastic Plastic "
               "Hardening, Elastic Plastic Correspondence, Isotropic Hardening Correspondence",
               deck_string(given));
}

static double pressure(const struct translation *t)
{
    return t->mass / (t->length * t->time * t->time);
}

static void write_moduli(struct translation *t, struct deck_node material, bool bonds)
{
    static const char *const keys[4][2] = {{"Bulk Modulus", "bulk_modulus"},
                                           {"Shear Modulus", "shear_modulus"},
                                           {"Young's Modulus", "youngs_modulus"},
                                           {"Poisson's Ratio", "poissons_ratio"}};
    double value[4];
    bool found[4];
    for (int k = 0; k < 4; k++)
        found[k] = take_number(t, material, keys[k][0], k == 3 ? 1 : pressure(t), &value[k]);
    /* Bonds between all points of a solid have one modulus, and Poisson's ratio 1/4. */
    if (bonds && !found[2]) {
        if (!found[0]) deck_error(material, "expected 'Bulk Modulus' or 'Young's Modulus'");
        value[2] = 1.5 * value[0];
        found[2] = true;
    }
    for (int k = 0; k < 4; k++)
        if (found[k] && (!bonds || k == 2)) fprintf(t->out, ", %s: %.15g", keys[k][1], value[k]);
}

static void write_hardening(struct translation *t, struct deck_node material, bool hardens)
{
    double yield, modulus = 0;
    if (!take_number(t, material, "Yield Stress", pressure(t), &yield))
        deck_error(material, "expected a number as 'Yield Stress'");
    if (hardens) take_number(t, material, "Hardening Modulus", pressure(t), &modulus);
    fprintf(t->out, ", hardening: {law: linear, yield: %.15g, modulus: %.15g}", yield, modulus);
}

static const struct model *write_material(struct translation *t, const struct peridigm_block *block,
                                          struct deck_node materials)
{
    const struct deck_node material = take(t, materials, block->material);
    double density;
    if (material.index == 0)
        deck_error(block->where, "no material '%s' in this deck", block->material);
    const struct model *model = find_model(t, material, block->material);
    char *name = quoted(block->phase);
    if (!take_number(t, material, "Density", t->mass / pow(t->length, 3), &density))
        deck_error(material, "expected a number as 'Density'");
    fprintf(t->out, "  %s: {%s, density: %.15g", name, model->ours, density);
    write_moduli(t, material, model->bonds);
    if (model->flows) write_hardening(t, material, model->hardens);
    fprintf(t->out, "}\n");
    free(name);
    return model;
}

/* Critical stretch of a block's bonds; 0: they do not break. */
static double stretch_of(struct translation *t, const struct peridigm_block *block)
{
    double stretch = 0;
    const struct deck_node all = take(t, t->root, "Damage Models");
    if (!block->damage) return 0;
    const struct deck_node model = take(t, all, block->damage);
    if (model.index == 0)
        deck_error(block->where, "no damage model '%s' in this deck", block->damage);
    const char *name = take_text(t, model, "Damage Model");
    if (!name || strcmp(name, "Critical Stretch") != 0 ||
        !take_number(t, model, "Critical Stretch", 1, &stretch))
        cannot_take(t, model, block->damage, "damage is by 'Critical Stretch', a number, alone");
    return stretch;
}

/* Of blocks with different ones, the bonds between them: the smaller. */
static void write_damage(struct translation *t, const struct peridigm_blocks *blocks)
{
    bool begun = false;
    for (int i = 0; i < blocks->count; i++)
        for (int k = 0; k <= i; k++) {
            const double a = stretch_of(t, &blocks->items[i]), b = stretch_of(t, &blocks->items[k]);
            const double both = a > 0 && b > 0 ? fmin(a, b) : fmax(a, b);
            if (!(both > 0)) continue;
            char *one = quoted(blocks->items[k].phase), *other = quoted(blocks->items[i].phase);
            fprintf(t->out, "%s  - {law: critical_stretch, pair: [%s, %s], value: %.15g}\n",
                    begun ? "" : "damage:\n", one, other, both);
            free(one);
            free(other);
            begun = true;
        }
}

bool peridigm_materials(struct translation *t, const struct peridigm_blocks *blocks)
{
    const struct deck_node materials = take(t, t->root, "Materials");
    if (materials.index == 0) deck_error(t->root, "no 'Materials' in this deck");
    bool ordinary = false;
    fprintf(t->out, "materials:\n");
    for (int i = 0; i < blocks->count; i++)
        ordinary |= write_material(t, &blocks->items[i], materials)->ordinary;
    write_damage(t, blocks);
    return ordinary;
}
