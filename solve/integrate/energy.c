#include "energy.h"

#include <math.h>

double energy_total(const struct energy_balance *b)
{
    return b->kinetic + b->staggered + b->stored + b->plastic + b->stabilisation + b->damping +
           b->fracture;
}

double energy_drift(const struct energy_balance *b)
{
    double held = energy_total(b);
    double given = b->initial + b->work;
    double largest = fmax(fmax(fabs(held), fabs(given)), b->reference);
    double missing = fabs(held - given);
    missing = missing <= b->rounding ? 0 : missing - b->rounding; /* what is no number stays so */
    return largest > 0 ? copysign(missing, held - given) / largest : 0;
}

double energy_internal(const struct energy_balance *b)
{
    return b->stored + b->plastic + b->stabilisation;
}
