#include "requirements.h"

#include "keys.h"

const char *const requirement_names[] = {"ufg_connected", "cg_connected", "cores_apart", NULL};

unsigned requirements_read(struct deck_node list, unsigned usual)
{
    unsigned wanted = 0;
    if (list.index == 0) return usual;
    if (!deck_is_list(list))
        deck_error(list, "require is a list of ufg_connected, cg_connected and cores_apart, or []");
    for (int i = 0; i < deck_count(list); i++)
        wanted |= 1u << keys_choice(deck_item(list, i), requirement_names);
    return wanted;
}
