#include "damping.h"

#include <math.h>

/* The affine motion between the grips at a node: what damping leaves alone. */
struct affine {
    int axis;
    double left_velocity, rate, left, right, contraction, centre[3];
};

static struct affine affine_motion(const struct boundary *boundary, const struct body *body,
                                   double time, double dt)
{
    struct affine affine = {.axis = body->lattice->axis,
                            .contraction = 0.5}; /* of plastic flow, which lasts longest */
    if (!boundary_has_grips(boundary)) return affine;
    const struct boundary_set *left = &boundary->sets[boundary->left];
    affine.left_velocity = boundary_speed(left, time, dt);
    affine.rate = boundary_strain_rate(boundary, time, dt);
    affine.left = left->inner;
    affine.right = boundary->sets[boundary->right].inner;
    for (int a = 0; a < 3; a++) affine.centre[a] = lattice_middle(body->lattice, a);
    return affine;
}

/* The affine velocity of the node at a site. */
static void affine_velocity(const struct affine *affine, const struct body *body, int64_t site,
                            double velocity[3])
{
    double x[3];
    body_position(body, site, x);
    double along = fmin(fmax(x[affine->axis], affine->left), affine->right) - affine->left;
    for (int a = 0; a < 3; a++)
        velocity[a] = a == affine->axis
                          ? affine->left_velocity + affine->rate * along
                          : -affine->contraction * affine->rate * (x[a] - affine->centre[a]);
}

/* What a velocity beyond the affine one loses of itself in half a step: a share, then the speed
 * that a force of `force` [N/m^3] gives in that time, and no more than there is. */
static double damped(const struct integration *integration, double beyond, double keep,
                     double force, double inverse_density)
{
    const double kept = keep * beyond;
    if (!(integration->local_damping > 0)) return kept;
    const double speed =
        integration->local_damping * fabs(force) * inverse_density * 0.5 * integration->dt;
    return copysign(fmax(fabs(kept) - speed, 0), kept);
}

void damping_apply(const struct integration *integration, struct body *body,
                   const struct boundary *boundary, double time, double kicked,
                   struct exact_sum *lost)
{
    const struct affine affine = affine_motion(boundary, body, time, integration->dt);
    const double keep = exp(-0.5 * integration->damping * integration->dt);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            const double inverse_density = integration_inverse_density(integration, body, site);
            double target[3];
            affine_velocity(&affine, body, site, target);
            for (int a = 0; a < 3; a++) {
                if (boundary->held && (boundary->held[site] >> a & 1)) continue;
                const double before = body->v[a][site],
                             force = body->f[a][site] + (body->b[a] ? body->b[a][site] : 0);
                const double after = target[a] + damped(integration, before - target[a], keep,
                                                        force, inverse_density);
                body->v[a][site] = after;
                exact_sum_add(lost,
                              integration_node_mass(integration, body, site) * (before - after) *
                                  (0.5 * (before + after) - kicked * force * inverse_density));
            }
        }
}

double damping_unsteady_energy(const struct integration *integration, const struct body *body,
                               const struct boundary *boundary)
{
    const struct affine affine = affine_motion(boundary, body, integration->time, integration->dt);
    struct exact_sum sum = integration->kinetic_zero;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            double steady[3], square = 0;
            affine_velocity(&affine, body, site, steady);
            for (int a = 0; a < 3; a++) {
                double beyond = body->v[a][site] - steady[a];
                square += beyond * beyond;
            }
            exact_sum_add(&sum, 0.5 * integration_node_mass(integration, body, site) * square);
        }
    double energy;
    exact_sum_finish(&sum, 1, &energy);
    return energy;
}
