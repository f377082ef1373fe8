#include "energy.h"

#include <math.h>

double energy_drift(const struct energy_balance *b)
{
    double held = b->kinetic + b->stored + b->plastic + b->stabilisation + b->damping;
    double given = b->initial + b->work;
    double largest = fmax(fmax(fabs(held), fabs(given)), b->reference);
    return largest > 0 ? (held - given) / largest : 0;
}

double energy_kinetic_to_internal(const struct energy_balance *b)
{
    double internal = b->stored + b->plastic + b->stabilisation;
    return internal > 0 ? b->kinetic / internal : 0;
}
