#include "integration.h"

#include "balance.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

struct integration integration_new(bool moving, double dt, double damping,
                                   const struct materials *materials, struct body *body,
                                   struct boundary *boundary, struct model *model)
{
    struct integration integration = {.moving = moving, .dt = dt, .damping = damping};
    integration.inverse_density = memory_new((size_t)materials->count, sizeof(double));
    for (int i = 0; i < materials->count; i++)
        integration.inverse_density[i] = 1 / materials->items[i].density;
    /* No energy density of a metal exceeds its Young's modulus. */
    const double bound = (double)body->n_nodes * body->volume * materials_stiffest(materials);
    const struct exact_sum zero = exact_sum_new(4 * bound);
    integration.zero = (struct force_energy){zero, zero, zero};
    integration.kinetic_zero = zero;

    balance_masses(&integration, body, boundary);
    boundary_set_displacements(boundary, body);
    if (moving) boundary_set_velocities(boundary, body, 0, dt);
    loads_set(&boundary->loads, body, 0);
    struct force_energy energy = integration.zero;
    integration_force(&integration, model, body,
                      (struct force_mode){.commit = true, .energy = true}, &energy);
    balance_start(&integration, body, boundary, &energy);
    return integration;
}

void integration_free(struct integration *integration)
{
    free(integration->inverse_density);
    *integration = (struct integration){0};
}

bool integration_raise_loads(struct integration *integration, struct body *body,
                             struct boundary *boundary, bool equilibrium)
{
    if (!loads_raise(&boundary->loads, integration->step, equilibrium)) return false;
    loads_set(&boundary->loads, body, integration->time);
    balance_reactions(body, boundary);
    return true;
}
