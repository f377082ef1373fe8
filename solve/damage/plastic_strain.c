/* plastic_strain.c - (plastic_strain.1): all bonds of a node break once its equivalent plastic
 * strain is beyond a value. */
#include "damage.h"

static const struct key keys[] = {{"value", KEY_NUMBER, 0, "1", 0, 100, .required = true,
                                   .help = "the equivalent plastic strain"}};

static double value(const void *own)
{
    return *(const double *)own;
}

static double limit(const void *own, const double state[])
{
    (void)state;
    return value(own);
}

const struct damage_law damage_plastic_strain = {
    .words = {"plastic_strain",
              "All bonds of a node break once its equivalent plastic strain is beyond a value.",
              KEYS(keys)},
    .size = sizeof(double),
    .states = {"equivalent_plastic_strain"},
    .least = value,
    .limit = limit,
};
