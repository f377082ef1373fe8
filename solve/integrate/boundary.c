#include "boundary.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

static void find_grips(struct boundary *boundary)
{
    boundary->left = boundary->right = -1;
    for (int i = 0; i < boundary->count; i++) {
        if (boundary->sets[i].direction != 0) continue;
        if (boundary->left < 0 ||
            boundary->sets[i].members.mean_x < boundary->sets[boundary->left].members.mean_x)
            boundary->left = i;
        if (boundary->right < 0 ||
            boundary->sets[i].members.mean_x > boundary->sets[boundary->right].members.mean_x)
            boundary->right = i;
    }
    if (boundary->left == boundary->right) boundary->left = boundary->right = -1;
}

struct boundary boundary_new(const struct scene *scene, const struct body *body,
                             const struct domain *domain, double largest_stress)
{
    struct boundary boundary = {
        .count = scene->n_boundary,
        .sets = memory_new((size_t)scene->n_boundary, sizeof(struct boundary_set)),
        .ramp = scene->ramp};
    const double spacing = body->lattice->spacing, middle = lattice_middle(body->lattice, 0);
    for (int i = 0; i < boundary.count; i++) {
        const struct scene_boundary *wanted = &scene->boundary[i];
        struct members members = members_new(body, domain, wanted->set);
        boundary.sets[i] = (struct boundary_set){
            .name = wanted->set,
            .direction = wanted->direction,
            .velocity = wanted->velocity,
            .members = members,
            .inner = members.mean_x < middle ? members.high_x : members.low_x,
            .zero = exact_sum_new((double)members.n_all * largest_stress * spacing * spacing)};
    }
    find_grips(&boundary);
    if (boundary.left < 0)
        deck_error(deck_find(deck_root(scene->deck), "boundary"),
                   "a tension test needs two sets with a velocity along x");
    return boundary;
}

void boundary_free(struct boundary *boundary)
{
    for (int i = 0; i < boundary->count; i++) members_free(&boundary->sets[i].members);
    free(boundary->sets);
    *boundary = (struct boundary){0};
}

double boundary_factor(const struct boundary *boundary, double time)
{
    if (boundary->ramp <= 0 || time >= boundary->ramp) return 1;
    double s = time / boundary->ramp;
    return s * s * s * (10 + s * (6 * s - 15));
}

void boundary_set_velocities(const struct boundary *boundary, struct body *body, double time)
{
    const double factor = boundary_factor(boundary, time);
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        double *v = body->v[set->direction];
        for (int64_t i = 0; i < set->members.count; i++)
            v[set->members.sites[i]] = factor * set->velocity;
    }
}

void boundary_reactions(const struct boundary *boundary, const struct body *body,
                        struct exact_sum *sums)
{
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        const double *f = body->f[set->direction];
        sums[b] = set->zero;
        for (int64_t i = 0; i < set->members.count; i++)
            exact_sum_add(&sums[b],
                          -f[set->members.sites[i]] * body_volume(body, set->members.sites[i]));
    }
}

double boundary_strain_rate(const struct boundary *boundary)
{
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const struct boundary_set *right = &boundary->sets[boundary->right];
    double length = right->inner - left->inner;
    return length > 0 ? (right->velocity - left->velocity) / length : 0;
}

void boundary_affine_start(const struct boundary *boundary, struct body *body,
                           double poissons_ratio)
{
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const struct boundary_set *right = &boundary->sets[boundary->right];
    const double rate = boundary_strain_rate(boundary);
    double centre[3];
    for (int a = 0; a < 3; a++) centre[a] = lattice_middle(body->lattice, a);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            int64_t site = body->owned.items[s].site + i;
            double x[3];
            body_position(body, site, x);
            double along = fmin(fmax(x[0], left->inner), right->inner);
            body->v[0][site] = left->velocity + rate * (along - left->inner);
            bool gripped = x[0] < left->inner || x[0] > right->inner;
            for (int a = 1; a < 3; a++)
                body->v[a][site] = gripped ? 0 : -poissons_ratio * rate * (x[a] - centre[a]);
        }
    boundary_set_velocities(boundary, body, 0);
}
