#include "loads.h"

#include "checkpoint.h"
#include "memory.h"
#include "ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Volume of the nodes [m^3]. */
static double volume_of(const struct members *members, const struct body *body)
{
    /* The volume of the whole body, with room for its rounding. */
    struct exact_sum sum = exact_sum_new(1.001 * body->volume * (double)body->n_nodes);
    double volume;
    for (int64_t i = 0; i < members->count; i++)
        exact_sum_add(&sum, body_volume(body, members->sites[i]));
    exact_sum_finish(&sum, 1, &volume);
    return volume;
}

/* Images of the part that the nodes of a force are one set with: across each plane of symmetry that
 * they reach, and of a block across all.  Across the force itself the image is pulled the other way
 * and has its own. */
static double images_of(const struct load *load, const struct scene_entry *entry,
                        const struct body *body)
{
    const bool whole = entry->nodes.selection.kind == SELECT_BLOCK;
    double images = 1, apart[3];
    for (int a = 0; a < 3; a++) apart[a] = whole ? 0 : 1;
    for (int64_t i = 0; i < load->members.count; i++) {
        int at[3];
        grid_position(&body->grid, load->members.sites[i], at);
        for (int a = 0; a < 3; a++) apart[a] = fmin(apart[a], at[a]);
    }
    ranks_minimum(apart, 3);
    for (int a = 0; a < 3; a++)
        if (body->lattice->mirror[a] && a != load->direction && apart[a] == 0) images *= 2;
    return images;
}

static struct load load_new(const struct scene_entry *entry, const struct body *body)
{
    struct load load = {.direction = entry->direction,
                        .value = entry->value,
                        .share = 1,
                        .members =
                            members_of_nodes(body, entry->nodes.numbers, entry->nodes.count)};
    if (entry->kind == SCENE_FORCE)
        load.share = 1 / (images_of(&load, entry, body) * volume_of(&load.members, body));
    size_t count = 1;
    if (value_depends_on_place(&entry->value)) {
        members_places(&load.members, body, load.place);
        count = (size_t)load.members.count;
    }
    load.density = memory_new(count, sizeof *load.density);
    return load;
}

struct loads loads_new(const struct scene *scene, struct body *body)
{
    struct loads loads = {.items = memory_new((size_t)scene->n_boundary, sizeof *loads.items)};
    for (int i = 0; i < scene->n_boundary; i++) {
        const struct scene_entry *entry = &scene->boundary[i];
        if (scene_holds(entry->kind)) continue;
        loads.items[loads.count++] = load_new(entry, body);
        loads.vary |= entry->value.kind != VALUE_STEPS && value_depends_on_time(&entry->value);
        double **b = &body->b[entry->direction];
        if (!*b) *b = memory_new((size_t)body->grid.n_sites, sizeof **b);
    }
    return loads;
}

void loads_free(struct loads *loads)
{
    for (int k = 0; k < loads->count; k++) {
        members_free(&loads->items[k].members);
        free(loads->items[k].density);
        for (int a = 0; a < 3; a++) free(loads->items[k].place[a]);
    }
    free(loads->items);
    *loads = (struct loads){0};
}

static double density(const struct load *load, int64_t i)
{
    return load->density[load->place[0] ? i : 0];
}

static void evaluate(struct load *load, double time)
{
    const int64_t count = load->place[0] ? load->members.count : 1;
    for (int64_t i = 0; i < count; i++) {
        double x[3] = {0, 0, 0};
        for (int a = 0; a < 3 && load->place[a]; a++) x[a] = load->place[a][i];
        load->density[i] = load->share * value_at(&load->value, x, time);
    }
}

void loads_set(struct loads *loads, struct body *body, double time)
{
    if (loads->count == 0 || (loads->current && !loads->vary)) return;
    loads->current = true;
    for (int a = 0; a < 3; a++)
        if (body->b[a]) memset(body->b[a], 0, (size_t)body->grid.n_sites * sizeof(double));
    for (int k = 0; k < loads->count; k++) {
        struct load *load = &loads->items[k];
        double *b = body->b[load->direction];
        evaluate(load, time);
        for (int64_t i = 0; i < load->members.count; i++)
            b[load->members.sites[i]] += density(load, i);
    }
}

void loads_add_work(const struct loads *loads, const struct body *body, double duration,
                    struct exact_sum *work)
{
    for (int k = 0; k < loads->count; k++) {
        const struct load *load = &loads->items[k];
        const double *v = body->v[load->direction];
        for (int64_t i = 0; i < load->members.count; i++) {
            const int64_t site = load->members.sites[i];
            exact_sum_add(work, density(load, i) * body_volume(body, site) * v[site] * duration);
        }
    }
}

bool loads_raise(struct loads *loads, int64_t steps, bool equilibrium)
{
    bool raised = false;
    for (int k = 0; k < loads->count; k++)
        raised |= value_raise(&loads->items[k].value, steps, equilibrium);
    if (raised) loads->current = false;
    return raised;
}

void loads_visit(struct loads *loads, struct body *body, double time, struct checkpoint *checkpoint)
{
    static const char *const names[] = {"loads along x", "loads along y", "loads along z"};
    for (int k = 0; k < loads->count; k++) {
        checkpoint_integer(checkpoint, "increments of a load", &loads->items[k].value.raised);
        if (checkpoint_reads(checkpoint)) evaluate(&loads->items[k], time);
    }
    for (int a = 0; a < 3; a++)
        if (body->b[a]) checkpoint_fields(checkpoint, names[a], &body->b[a], 1);
    checkpoint_flag(checkpoint, "loads are current", &loads->current);
}
