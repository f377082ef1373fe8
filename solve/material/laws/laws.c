#include "laws.h"

#include <string.h>

#define LAW(name) &law_##name,
const struct law *const laws[] = {LAWS NULL};
#undef LAW

int law_components(const struct law *law)
{
    int count = 0;
    for (int i = 0; i < law->n_states; i++) count += law->states[i].components;
    return count;
}

int law_component(const struct law *law, const char *state)
{
    for (int i = 0, first = 0; i < law->n_states; first += law->states[i++].components)
        if (strcmp(law->states[i].name, state) == 0) return first;
    return -1;
}

static const struct variant *words(int i)
{
    return laws[i] ? &laws[i]->words : NULL;
}

#define LAW(name) LAW_##name,
enum { LAWS };

const struct section section_laws = {
    .path = "materials.NAME, model: correspondence",
    .help = "The law of a phase; a bond between phases of different laws obeys the one that is listed first.",
    .chooser = "law",
    .variant = words,
    .usual = LAW_j2,
};
