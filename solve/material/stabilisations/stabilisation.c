#include "stabilisation.h"

static const struct stabilisation *const table[] = {&stabilisation_mix, &stabilisation_capped};
enum { TABLE_COUNT = sizeof table / sizeof *table };

const struct stabilisation *stabilisation_choose(struct deck_node map)
{
    const char *names[TABLE_COUNT];
    if (!map.index) return table[0];
    for (int i = 0; i < TABLE_COUNT; i++) names[i] = table[i]->name;
    const struct stabilisation *chosen =
        table[deck_choice(deck_get(map, "law"), names, TABLE_COUNT)];
    const char *known[8] = {"law"};
    for (int i = 0; chosen->keys[i]; i++) known[i + 1] = chosen->keys[i];
    deck_keys(map, known);
    return chosen;
}
