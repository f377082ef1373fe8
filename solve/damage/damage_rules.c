#include "damage.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

static const struct damage_law *const table[] = {&damage_critical_stretch, &damage_bond_energy,
                                                 &damage_plastic_strain, &damage_ductile};
enum { LAWS = sizeof table / sizeof *table };

/* How the bonds between two phases get their value from those within each. */
static const char *const combinations[COMBINATIONS] = {"min", "max", "mean", "harmonic"};

static int read_phase(struct deck_node node, const struct materials *materials)
{
    const char **names = memory_new((size_t)materials->count, sizeof *names);
    for (int p = 0; p < materials->count; p++) names[p] = materials->items[p].name;
    int phase = deck_choice(node, names, materials->count);
    free(names);
    return phase;
}

static void read_pair(struct deck_node entry, const struct materials *materials, int *a, int *b)
{
    struct deck_node pair = deck_get(entry, "pair");
    if (!deck_is_list(pair) || deck_count(pair) != 2)
        deck_error(pair, "a pair is a list of two phases, such as [%s, %s]",
                   materials->items[0].name, materials->items[materials->count - 1].name);
    *a = read_phase(deck_item(pair, 0), materials);
    *b = read_phase(deck_item(pair, 1), materials);
}

static const struct damage_law *read_law(struct deck_node entry, const struct damage_view *see)
{
    const char *names[LAWS];
    for (int k = 0; k < LAWS; k++) names[k] = table[k]->name;
    struct deck_node node = deck_get(entry, "law");
    const struct damage_law *law = table[deck_choice(node, names, LAWS)];
    if (law->read_range && !see->materials->formulation->plastic_strain)
        deck_error(node, "%s materials have no plastic strain", see->materials->formulation->name);
    if (law->check) law->check(see, node);
    return law;
}

static double read_value(struct deck_node entry, const struct damage_law *law,
                         const struct damage_view *see, int a, int b)
{
    if (deck_has(entry, "value") == deck_has(entry, "fracture_energy"))
        deck_error(entry, "give one of value and fracture_energy");
    if (deck_has(entry, "value"))
        return deck_number(deck_get(entry, "value"), law->unit, 1e-12, law->most);
    struct deck_node node = deck_get(entry, "fracture_energy");
    return law->from_fracture_energy(see, a, b, deck_number(node, "J/m2", 1e-12, 1e12), node);
}

static void read_node_law(struct damage_rules *rules, struct deck_node entry,
                          const struct damage_view *see)
{
    double range[2];
    const int phase = read_phase(deck_get(entry, "phase"), see->materials);
    const struct damage_law *law = read_law(entry, see);
    if (!law->read_range)
        deck_error(deck_get(entry, "law"), "%s is a law of bonds: it goes with 'pair: [A, B]'",
                   law->name);
    if (!see->materials->items[phase].yields)
        deck_error(deck_get(entry, "phase"), "phase '%s' does not yield",
                   see->materials->items[phase].name);
    if (isfinite(rules->full[phase]))
        deck_error(entry, "phase '%s' is named twice", see->materials->items[phase].name);
    law->read_range(entry, see->body->lattice->spacing, range);
    rules->onset[phase] = range[0];
    rules->full[phase] = range[1];
    rules->least = fmin(rules->least, fmin(range[0], range[1]));
    rules->nodes = true;
    rules->degrading |= isfinite(range[0]);
}

static void read_bond_law(struct damage_rules *rules, struct deck_node entry,
                          const struct damage_view *see)
{
    const int n = rules->n_phases;
    int a, b;
    read_pair(entry, see->materials, &a, &b);
    if (rules->law[a * n + b])
        deck_error(entry, "the pair '%s', '%s' is named twice", see->materials->items[a].name,
                   see->materials->items[b].name);
    if (deck_has(entry, "rule")) return;
    deck_keys(entry, (const char *const[]){"pair", "law", "value", "fracture_energy", NULL});
    const struct damage_law *law = read_law(entry, see);
    if (law->read_range)
        deck_error(deck_get(entry, "law"), "%s is a law of nodes: it goes with 'phase: NAME'",
                   law->name);
    rules->law[a * n + b] = rules->law[b * n + a] = law;
    rules->value[a * n + b] = rules->value[b * n + a] = read_value(entry, law, see, a, b);
    rules->bonds = true;
}

/* Whether bonds between two phases have an integrity of their own that a rule may be for. */
static bool bonds_degrade(const struct damage_rules *rules, const struct damage_view *see, int a,
                          int b)
{
    return see->materials->formulation->stress_of == STRESS_OF_NODES &&
           (isfinite(rules->onset[a]) || isfinite(rules->onset[b]));
}

/* Entries with a rule come after all those with a law, wherever they stand. */
static void read_rule(struct damage_rules *rules, struct deck_node entry,
                      const struct damage_view *see)
{
    const int n = rules->n_phases;
    int a, b;
    deck_keys(entry, (const char *const[]){"pair", "rule", NULL});
    read_pair(entry, see->materials, &a, &b);
    const char *first = see->materials->items[a].name, *second = see->materials->items[b].name;
    const struct damage_law *of_a = rules->law[a * n + a], *of_b = rules->law[b * n + b];
    const int chosen = deck_choice(deck_get(entry, "rule"), combinations, COMBINATIONS);
    if (a == b) deck_error(entry, "a rule is for two different phases, not '%s' twice", first);
    if (rules->law[a * n + b] || rules->integrity[a * n + b] != COMBINATIONS)
        deck_error(entry, "the pair '%s', '%s' is named twice", first, second);
    if (bonds_degrade(rules, see, a, b)) {
        rules->integrity[a * n + b] = rules->integrity[b * n + a] = (enum combination)chosen;
        if (!of_a || of_a != of_b) return;
    }
    if (!of_a || of_a != of_b)
        deck_error(entry, "a rule needs the pairs [%s, %s] and [%s, %s] with the same law", first,
                   first, second, second);
    const double value =
        combine((enum combination)chosen, rules->value[a * n + a], rules->value[b * n + b]);
    rules->law[a * n + b] = rules->law[b * n + a] = of_a;
    rules->value[a * n + b] = rules->value[b * n + a] = value;
}

static void tell_unbroken(const struct damage_rules *rules, const struct materials *materials)
{
    const int n = rules->n_phases;
    for (int a = 0; a < n; a++)
        for (int b = a; b < n; b++)
            if (!rules->law[a * n + b])
                note("damage: no law for the pair '%s', '%s': its bonds do not break by stretch or "
                     "energy",
                     materials->items[a].name, materials->items[b].name);
}

/* The stress of a correspondence material comes from its nodes, whose shape tensors make up for lost bonds. */
static void tell_weak(const struct damage_rules *rules, const struct materials *materials)
{
    if (materials->formulation->stress_of == STRESS_OF_NODES && !rules->nodes)
        warn("damage: broken bonds alone hardly unload a correspondence material, since the "
             "families "
             "left take over; '%s' or '%s' does",
             damage_ductile.name, damage_plastic_strain.name);
}

struct damage_rules damage_rules_read(struct deck_node section, const struct damage_view *see)
{
    const int n = see->materials->count;
    struct damage_rules rules = {.n_phases = n, .least = INFINITY};
    rules.law = memory_new((size_t)(n * n), sizeof *rules.law);
    rules.value = memory_new((size_t)(n * n), sizeof *rules.value);
    rules.onset = memory_new((size_t)n, sizeof *rules.onset);
    rules.full = memory_new((size_t)n, sizeof *rules.full);
    rules.integrity = memory_new((size_t)(n * n), sizeof *rules.integrity);
    for (int k = 0; k < n * n; k++) rules.integrity[k] = COMBINATIONS; /* no rule */
    for (int p = 0; p < n; p++) rules.onset[p] = rules.full[p] = INFINITY;
    if (section.index == 0) return rules;
    if (!deck_is_list(section)) deck_error(section, "damage is a list of laws");
    for (int i = 0; i < deck_count(section); i++) {
        struct deck_node entry = deck_item(section, i);
        if (deck_has(entry, "phase"))
            read_node_law(&rules, entry, see);
        else
            read_bond_law(&rules, entry, see);
    }
    for (int i = 0; i < deck_count(section); i++)
        if (deck_has(deck_item(section, i), "rule")) read_rule(&rules, deck_item(section, i), see);
    for (int k = 0; k < n * n; k++)
        if (rules.integrity[k] == COMBINATIONS) rules.integrity[k] = COMBINE_SMALLER;
    if (rules.bonds && see->body->ranks.rank == 0) {
        tell_unbroken(&rules, see->materials);
        tell_weak(&rules, see->materials);
    }
    return rules;
}

void damage_rules_free(struct damage_rules *rules)
{
    free(rules->law);
    free(rules->value);
    free(rules->onset);
    free(rules->full);
    free(rules->integrity);
    *rules = (struct damage_rules){0};
}
