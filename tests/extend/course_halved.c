/* The halved course: explicit steps of half the length. */
#include "simulation_parts.h"

static void halved_begin(struct simulation *s)
{
    s->integration.dt *= 0.5;
    explicit_begin(s);
}

const struct course course_halved = {
    .moving = true, .begin = halved_begin, .advance = explicit_advance};
