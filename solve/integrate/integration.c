#include "integration.h"

#include "balance.h"
#include "checkpoint.h"
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
    const double before = balance_staggered(integration, body, boundary);
    loads_set(&boundary->loads, body, integration->time);
    balance_shift(&integration->balance, balance_staggered(integration, body, boundary) - before);
    balance_reactions(body, boundary);
    return true;
}

static void visit_balance(struct integration *integration, struct checkpoint *checkpoint)
{
    struct energy_balance *b = &integration->balance;
    double *const parts[] = {&b->kinetic,   &b->stored,    &b->plastic,       &b->stabilisation,
                             &b->damping,   &b->fracture,  &b->initial,       &b->work,
                             &b->reference, &b->staggered, &integration->held};
    enum { PARTS = sizeof parts / sizeof *parts };
    double values[PARTS];
    for (int k = 0; k < PARTS; k++) values[k] = *parts[k];
    checkpoint_numbers(checkpoint, "energies", values, PARTS);
    for (int k = 0; k < PARTS; k++) *parts[k] = values[k];
}

void integration_visit(struct integration *integration, struct body *body,
                       struct checkpoint *checkpoint)
{
    checkpoint_flag(checkpoint, "moving", &integration->moving);
    checkpoint_numbers(checkpoint, "step length", &integration->dt, 1);
    checkpoint_numbers(checkpoint, "time", &integration->time, 1);
    checkpoint_numbers(checkpoint, "time of the force", &integration->force_time, 1);
    checkpoint_numbers(checkpoint, "time of the last commit", &integration->committed_time, 1);
    checkpoint_integer(checkpoint, "steps", &integration->step);
    checkpoint_integer(checkpoint, "evaluations", &integration->evaluations);
    checkpoint_numbers(checkpoint, "residual", &integration->residual, 1);
    visit_balance(integration, checkpoint);
    checkpoint_fields(checkpoint, "displacement", body->u, 3);
    checkpoint_fields(checkpoint, "velocity", body->v, 3);
    checkpoint_fields(checkpoint, "force", body->f, 3);
}
