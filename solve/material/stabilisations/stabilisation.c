#include "stabilisation.h"

#include "memory.h"

#define ADDRESS(name) &stabilisation_##name
static const struct stabilisation *const table[] = {STABILISATIONS(ADDRESS)};
enum { COUNT = sizeof table / sizeof *table };

static const struct variant *variant(int i)
{
    return i < COUNT ? &table[i]->words : NULL;
}

const struct section section_stabilisation = {
    .path = "solver.stabilisation",
    .help = "What resists motions that alternate from node to node; of correspondence.",
    .chooser = "law",
    .variant = variant,
};

const struct stabilisation *stabilisation_read(struct deck_node map, bool scattered, void **self)
{
    int i = map.index ? keys_variant(map, &section_stabilisation) : 0;
    if (!map.index && scattered)
        while (!table[i]->add_family) i++;
    *self = memory_new(1, table[i]->size);
    keys_read(map, &section_stabilisation, i, 0, NULL, *self);
    return table[i];
}
