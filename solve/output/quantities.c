#include "quantities.h"

#include "corners.h"
#include "members.h"
#include "memory.h"
#include "node_values.h"

#include <math.h>
#include <stdlib.h>

struct quantity {
    struct node_component which;
    enum scene_reduction reduction;
    bool corners; /* the members are the corners of particles, each once */
    struct members members;
    double *values; /* [members.count] at a record */
};

struct quantities {
    int count;
    bool states; /* some are observed */
    struct quantity *items;
    struct node_values *nodes;
};

/* A force acts on corners: of a part of the body it is that on all of its corners, those that it
 * shares with others, too, where a neighbour or a support pulls at it. */
static struct members members_of_corners(const struct body *body, const int64_t *particles,
                                         int64_t count)
{
    int64_t *corners = particles ? corners_of_particles(body->lattice, particles, &count) : NULL;
    const struct members members = members_of_nodes(body, corners, corners ? count : 0);
    free(corners);
    return members;
}

struct quantities *quantities_new(const struct scene *scene, const struct body *body,
                                  const struct damage *damage)
{
    struct quantities *quantities = memory_new(1, sizeof *quantities);
    quantities->count = scene->n_quantities;
    quantities->items = memory_new((size_t)scene->n_quantities, sizeof *quantities->items);
    for (int k = 0; k < scene->n_quantities; k++) {
        const struct scene_quantity *wanted = &scene->quantities[k];
        struct quantity *item = &quantities->items[k];
        item->which = node_component(wanted->value);
        item->reduction = wanted->reduction;
        item->corners =
            body->lattice->corner && item->which.value.density && item->reduction == REDUCE_SUM;
        item->members = (item->corners ? members_of_corners : members_of_particles)(
            body, wanted->nodes.numbers, wanted->nodes.count);
        item->values = memory_new((size_t)item->members.count, sizeof *item->values);
        quantities->states |= item->which.value.observe != NULL;
    }
    if (quantities->count > 0) quantities->nodes = node_values_new(body, damage);
    return quantities;
}

void quantities_free(struct quantities *quantities)
{
    if (!quantities) return;
    for (int k = 0; k < quantities->count; k++) {
        members_free(&quantities->items[k].members);
        free(quantities->items[k].values);
    }
    free(quantities->items);
    node_values_free(quantities->nodes);
    free(quantities);
}

int quantities_count(const struct quantities *quantities)
{
    return quantities->count;
}

bool quantities_need_states(const struct quantities *quantities)
{
    return quantities->states;
}

/* Of this rank's members: smallest value, minus the largest, and both of what is summed up. */
struct range {
    double low, minus_high, low_term, minus_high_term;
};
enum { RANGE = sizeof(struct range) / sizeof(double) };

/* Sums: of the values; means: of values times volumes. */
static double term(const struct quantity *quantity, int64_t i, double volume)
{
    return quantity->reduction == REDUCE_MEAN ? quantity->values[i] * volume : quantity->values[i];
}

static struct range find_range(struct quantity *quantity, const struct body *body,
                               const double *field)
{
    struct range range = {INFINITY, INFINITY, INFINITY, INFINITY};
    for (int64_t i = 0; i < quantity->members.count; i++) {
        const int64_t site = quantity->members.sites[i];
        const double volume = quantity->corners ? body_volume(body, site)
                                                : body_particle_volume(body, site),
                     value = field[site] * (quantity->which.value.density ? volume : 1);
        quantity->values[i] = value;
        const double t = term(quantity, i, volume);
        range.low = fmin(range.low, value);
        range.minus_high = fmin(range.minus_high, -value);
        range.low_term = fmin(range.low_term, t);
        range.minus_high_term = fmin(range.minus_high_term, -t);
    }
    return range;
}

/* Sum of the terms, and of the volumes. */
static void add_up(const struct quantity *quantity, const struct body *body,
                   const struct range *range, struct exact_sum sums[2])
{
    const double largest = fmax(fabs(range->low_term), fabs(range->minus_high_term));
    sums[0] = exact_sum_new((double)quantity->members.n_all * largest);
    sums[1] = exact_sum_new(1.001 * body->volume * (double)body->n_nodes);
    for (int64_t i = 0; i < quantity->members.count; i++) {
        const double volume = body_particle_volume(body, quantity->members.sites[i]);
        exact_sum_add(&sums[0], term(quantity, i, volume));
        exact_sum_add(&sums[1], volume);
    }
}

/* Two messages for all quantities: their ranges, which bound their sums, and the sums. */
void quantities_measure(struct quantities *quantities, struct model *model, struct body *body,
                        double *values)
{
    const int count = quantities->count;
    if (count == 0) return;
    struct range *ranges = memory_new((size_t)count, sizeof *ranges);
    struct exact_sum *sums = memory_new(2 * (size_t)count, sizeof *sums);
    double *totals = memory_new(2 * (size_t)count, sizeof *totals);
    for (int k = 0; k < count; k++) {
        struct quantity *item = &quantities->items[k];
        ranges[k] = find_range(
            item, body,
            item->corners ? node_values_at_corners(quantities->nodes, item->which, body)
                          : node_values_field(quantities->nodes, item->which, model, body));
    }
    ranks_minimum((double *)ranges, RANGE * count);
    for (int k = 0; k < count; k++) add_up(&quantities->items[k], body, &ranges[k], sums + 2 * k);
    exact_sum_finish(sums, 2 * count, totals);
    for (int k = 0; k < count; k++) {
        const double reduced[] = {[REDUCE_SUM] = totals[2 * k],
                                  [REDUCE_MEAN] = totals[2 * k] / totals[2 * k + 1],
                                  [REDUCE_MINIMUM] = ranges[k].low,
                                  [REDUCE_MAXIMUM] = -ranges[k].minus_high};
        values[k] = reduced[quantities->items[k].reduction];
    }
    free(ranges);
    free(sums);
    free(totals);
}
