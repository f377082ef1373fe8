/* parabolic.c - D = ((p - onset)/(full - onset))^2: a law of nodes. */
#include "damage.h"

struct parabolic {
    double onset, full;
};

static const struct key keys[] = {
    {"onset", KEY_NUMBER, offsetof(struct parabolic, onset), "1", 0, 100, .required = true,
     .help = "plastic strain at which D begins to rise"},
    {"full", KEY_NUMBER, offsetof(struct parabolic, full), "1", 0, 100, .required = true,
     .help = "plastic strain at which D is 1"},
};

static double least(const void *own)
{
    return ((const struct parabolic *)own)->onset;
}

static double degradation(const void *own, const double state[])
{
    const struct parabolic *law = own;
    const double part = (state[0] - law->onset) / (law->full - law->onset);
    return part * part;
}

static double limit(const void *own, const double state[])
{
    (void)state;
    return ((const struct parabolic *)own)->full;
}

const struct damage_law damage_parabolic = {
    .words = {"parabolic", "The stress of a node falls by a parabola.", KEYS(keys)},
    .size = sizeof(struct parabolic),
    .states = {"equivalent_plastic_strain"},
    .least = least,
    .degradation = degradation,
    .limit = limit,
};
