/* plastic_strain.c - (plastic_strain.1): all bonds of a node break once its equivalent plastic strain is beyond a value. */
#include "damage.h"

#include <math.h>

static void read_range(struct deck_node entry, double spacing, double range[2])
{
    (void)spacing;
    deck_keys(entry, (const char *const[]){"phase", "law", "value", NULL});
    range[0] = INFINITY;
    range[1] = deck_number(deck_get(entry, "value"), "1", 0, 100);
}

const struct damage_law damage_plastic_strain = {
    .name = "plastic_strain",
    .read_range = read_range,
};
