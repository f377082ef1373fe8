#include "damage.h"

#include "die.h"
#include "laws.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

#define ADDRESS(name) &damage_##name
#define NUMBER(name)  NUMBER_##name
static const struct damage_law *const table[] = {DAMAGE_BOND_LAWS(ADDRESS),
                                                 DAMAGE_NODE_LAWS(ADDRESS)};
enum { DAMAGE_BOND_LAWS(NUMBER), BOND_LAWS };
enum { LAWS = sizeof table / sizeof *table };
enum { OF_BONDS = (1 << BOND_LAWS) - 1, OF_NODES = (1 << LAWS) - 1 - OF_BONDS }; /* sets of them */

static const struct variant *law_words(int i)
{
    return i < LAWS ? &table[i]->words : NULL;
}

/* How the bonds between two phases get their value from those within each. */
static const char *const combinations[COMBINATIONS + 1] = {"min", "max", "mean", "harmonic"};

/* What is said by entries of all laws of bonds or of nodes, and by rules. */
struct entry {
    struct deck_node pair, phase;
    double fracture_energy;
    enum combination rule;
};
#define AT(member) offsetof(struct entry, member)

static const struct key law_keys[] = {
    {"pair", KEY_NODE, AT(pair), .form = "[A, B]", .required = true, .users = OF_BONDS,
     .help = "two phases, also the same twice; bonds of pairs that are not named never break by "
             "such a law"},
    {"fracture_energy", KEY_NUMBER, AT(fracture_energy), "J/m2", 1e-12, 1e12, .users = OF_BONDS,
     .otherwise = "by value",
     .help = "in place of value, which then follows from it; not for correspondence"},
    {"phase", KEY_NODE, AT(phase), .form = "NAME", .required = true, .users = OF_NODES,
     .help = "one that yields"},
};
const struct section section_damage = {
    .path = "damage",
    .help = "A list of laws, of the bonds between two phases, pair by pair, and of nodes, phase by "
            "phase; without it nothing breaks.  The history counts removed_nodes; damage as field "
            "or quantity is D or the share of broken bonds, whichever is more.",
    .keys = KEYS(law_keys),
    .chooser = "law",
    .variant = law_words,
    .usual = -1};

static const struct key rule_keys[] = {
    {"pair", KEY_NODE, AT(pair), .form = "[A, B]", .required = true, .help = "two phases"},
    {"rule", KEY_CHOICE, AT(rule), .names = combinations, .required = true,
     .help = "how their values become one: as much as the smaller, the larger, and so on"},
};
const struct section section_damage_rule = {
    .path = "damage (rule)",
    .help =
        "An entry of damage without a law.  Where [A, A] and [B, B] have the same law of bonds, "
        "those of [A, B] have both values combined.  Where either phase is ductile and the "
        "material correspondence, the rule also says what a bond of the stabilisation has of "
        "the stress at its ends; without one min.",
    .keys = KEYS(rule_keys)};

static int read_phase(struct deck_node node, const struct materials *materials)
{
    const char **names = memory_new((size_t)materials->count, sizeof *names);
    for (int p = 0; p < materials->count; p++) names[p] = materials->items[p].name;
    int phase = deck_choice(node, names, materials->count);
    free(names);
    return phase;
}

static void read_pair(struct deck_node pair, const struct materials *materials, int *a, int *b)
{
    if (!deck_is_list(pair) || deck_count(pair) != 2)
        deck_error(pair, "a pair is a list of two phases, such as [%s, %s]",
                   materials->items[0].name, materials->items[materials->count - 1].name);
    *a = read_phase(deck_item(pair, 0), materials);
    *b = read_phase(deck_item(pair, 1), materials);
}

/* The law among those in use, whose states are looked up when it first comes. */
static struct node_law *use_law(struct damage_rules *rules, const struct damage_law *law)
{
    int k = 0;
    while (k < rules->n_node_laws && rules->node_laws[k].law != law) k++;
    struct node_law *used = &rules->node_laws[k];
    if (k < rules->n_node_laws) return used;
    *used = (struct node_law){.law = law, .least = INFINITY};
    for (; law->states[used->count]; used->count++)
        used->state[used->count] = law_state_number(law->states[used->count]);
    rules->n_node_laws++;
    return used;
}

static void take_node_law(struct damage_rules *rules, const struct damage_law *law, void *own,
                          struct deck_node entry, const struct entry *said,
                          const struct damage_view *see)
{
    const int phase = read_phase(said->phase, see->materials);
    struct node_rule *rule = &rules->node[phase];
    if (rule->law)
        deck_error(entry, "phase '%s' is named twice", see->materials->items[phase].name);
    struct node_law *used = use_law(rules, law);
    const struct material *material = &see->materials->items[phase];
    for (int k = 0; k < used->count; k++)
        if (law_component(material->law, law->states[k]) < 0)
            deck_error(said->phase, "phase '%s' has no %s: its law, %s, does not yield",
                       material->name, law->states[k], material->law->words.name);
    if (law->read) law->read(own, entry, see->body->lattice->spacing);
    *rule = (struct node_rule){law, own, law->least(own)};
    used->least = fmin(used->least, rule->least);
    rules->degrading |= law->degradation != NULL;
}

static void take_bond_law(struct damage_rules *rules, const struct damage_law *law, double value,
                          struct deck_node entry, const struct entry *said,
                          const struct damage_view *see)
{
    const int n = rules->n_phases;
    const struct deck_node energy = deck_find(entry, "fracture_energy");
    int a, b;
    if (see->materials->formulation->corners)
        deck_error(deck_get(entry, "law"),
                   "corner has no bonds that could break: its particles are removed by ductile or "
                   "plastic_strain");
    read_pair(said->pair, see->materials, &a, &b);
    if (rules->law[a * n + b])
        deck_error(entry, "the pair '%s', '%s' is named twice", see->materials->items[a].name,
                   see->materials->items[b].name);
    if (law->check) law->check(see, deck_get(entry, "law"));
    if ((value > 0) == (energy.index != 0))
        deck_error(entry, "give one of value and fracture_energy");
    if (energy.index) value = law->from_fracture_energy(see, a, b, said->fracture_energy, energy);
    rules->law[a * n + b] = rules->law[b * n + a] = law;
    rules->value[a * n + b] = rules->value[b * n + a] = value;
    rules->bonds = true;
}

static void read_law(struct damage_rules *rules, struct deck_node entry,
                     const struct damage_view *see)
{
    const int variant = keys_variant(entry, &section_damage);
    const struct damage_law *law = table[variant];
    struct entry said;
    void *own = memory_new(1, law->size);
    keys_read(entry, &section_damage, variant, see->body->lattice->spacing, &said, own);
    if (law->states[0]) {
        take_node_law(rules, law, own, entry, &said, see);
    } else {
        take_bond_law(rules, law, *(double *)own, entry, &said, see);
        free(own);
    }
}

static bool degrades(const struct damage_rules *rules, int phase)
{
    return rules->node[phase].law && rules->node[phase].law->degradation;
}

/* Whether bonds between two phases have an integrity of their own that a rule may be for. */
static bool bonds_degrade(const struct damage_rules *rules, const struct damage_view *see, int a,
                          int b)
{
    return see->materials->formulation->stress_of == STRESS_OF_NODES &&
           (degrades(rules, a) || degrades(rules, b));
}

/* Entries with a rule come after all those with a law, wherever they stand. */
static void read_rule(struct damage_rules *rules, struct deck_node entry,
                      const struct damage_view *see)
{
    const int n = rules->n_phases;
    struct entry said;
    int a, b;
    keys_read(entry, &section_damage_rule, 0, 0, &said, NULL);
    read_pair(said.pair, see->materials, &a, &b);
    const char *first = see->materials->items[a].name, *second = see->materials->items[b].name;
    const struct damage_law *of_a = rules->law[a * n + a], *of_b = rules->law[b * n + b];
    if (a == b) deck_error(entry, "a rule is for two different phases, not '%s' twice", first);
    if (rules->law[a * n + b] || rules->integrity[a * n + b] != COMBINATIONS)
        deck_error(entry, "the pair '%s', '%s' is named twice", first, second);
    if (bonds_degrade(rules, see, a, b)) {
        rules->integrity[a * n + b] = rules->integrity[b * n + a] = said.rule;
        if (!of_a || of_a != of_b) return;
    }
    if (!of_a || of_a != of_b)
        deck_error(entry, "a rule needs the pairs [%s, %s] and [%s, %s] with the same law", first,
                   first, second, second);
    const double value = combine(said.rule, rules->value[a * n + a], rules->value[b * n + b]);
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

/* The stress of a correspondence material comes from its nodes, whose shape tensors make up for
 * lost bonds. */
static void tell_weak(const struct damage_rules *rules, const struct materials *materials)
{
    if (materials->formulation->stress_of == STRESS_OF_NODES && rules->n_node_laws == 0)
        warn("damage: broken bonds alone hardly unload a correspondence material, since the "
             "families left take over; '%s' or '%s' does",
             damage_ductile.words.name, damage_plastic_strain.words.name);
}

struct damage_rules damage_rules_read(struct deck_node section, const struct damage_view *see)
{
    const int n = see->materials->count;
    struct damage_rules rules = {.n_phases = n};
    rules.law = memory_new((size_t)(n * n), sizeof *rules.law);
    rules.value = memory_new((size_t)(n * n), sizeof *rules.value);
    rules.node = memory_new((size_t)n, sizeof *rules.node);
    rules.node_laws = memory_new((size_t)n, sizeof *rules.node_laws);
    rules.integrity = memory_new((size_t)(n * n), sizeof *rules.integrity);
    for (int k = 0; k < n * n; k++) rules.integrity[k] = COMBINATIONS; /* no rule */
    for (int p = 0; p < n; p++) rules.node[p].least = INFINITY;
    if (section.index == 0) return rules;
    if (!deck_is_list(section)) deck_error(section, "damage is a list of laws");
    for (int i = 0; i < deck_count(section); i++)
        if (!deck_has(deck_item(section, i), "rule")) read_law(&rules, deck_item(section, i), see);
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
    for (int p = 0; p < rules->n_phases; p++) free(rules->node[p].own);
    free(rules->node);
    free(rules->node_laws);
    free(rules->integrity);
    *rules = (struct damage_rules){0};
}
