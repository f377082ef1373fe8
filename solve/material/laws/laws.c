#include "laws.h"

#include <string.h>

#define ADDRESS(name) &law_##name
const struct law *const all_laws[LAW_COUNT] = {LAWS(ADDRESS)};

const struct variant *law_variant(int i)
{
    return i < LAW_COUNT ? &all_laws[i]->words : NULL;
}

void law_start(const struct law *law, const void *pairs, const struct points *points, double *state,
               int64_t stride)
{
    double *component = state;
    for (int s = 0; s < law->n_states; s++)
        for (int k = 0; k < law->states[s].components; k++, component += stride)
            for (int i = 0; i < points->count; i++)
                component[i] = state_initial(&law->states[s], k);
    if (law->start) law->start(pairs, points, state, stride);
}

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

/* Whether an earlier law has a state of that name. */
static bool is_known(int law, const char *name)
{
    for (int earlier = 0; earlier < law; earlier++)
        if (law_component(all_laws[earlier], name) >= 0) return true;
    return false;
}

const struct state *law_state(int i)
{
    for (int law = 0; law < LAW_COUNT; law++)
        for (int k = 0; k < all_laws[law]->n_states; k++)
            if (!is_known(law, all_laws[law]->states[k].name) && i-- == 0)
                return &all_laws[law]->states[k];
    return NULL;
}

int law_state_number(const char *name)
{
    const struct state *state;
    for (int i = 0; (state = law_state(i)); i++)
        if (strcmp(state->name, name) == 0) return i;
    return -1;
}
