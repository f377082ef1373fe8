/* Whether what the deck does to a part of a body is done alike to its images. */
#include "scene.h"

#include <math.h>

static void check_selection(const struct selection *selection, const struct domain *domain,
                            const struct lattice *lattice, int axis)
{
    if (!selection_is_beyond(selection, domain, lattice->spacing, axis, lattice->origin[axis]))
        return;
    deck_error(selection->where,
               "this holds below the plane of symmetry across %c, at %c = %g m, where the body is "
               "the image of the part above, and not at the images: let it hold above the plane "
               "alone, or alike on both sides",
               'x' + axis, 'x' + axis, lattice->origin[axis]);
}

/* The largest magnitude that a value takes at a place, of what is no expression anywhere. */
static double largest_at(const struct value *value, const double x[3], double end_time)
{
    enum { TIMES = 3 };
    double largest = fmax(fabs(value->number), fabs(value->increment));
    for (int i = 0; i < value->n_rows; i++) largest = fmax(largest, fabs(value->values[i]));
    for (int i = 0; value->expression && i < TIMES; i++)
        largest = fmax(largest, fabs(value_at(value, x, end_time * i / (TIMES - 1))));
    return largest;
}

/* In the plane nothing acts across it; of an expression but for rounding. */
static void check_value(const struct scene_entry *entry, const struct domain *nodes,
                        const struct lattice *lattice, int axis, double end_time)
{
    const double rounding = 1e-6, plane = lattice->origin[axis], spacing = lattice->spacing;
    const int64_t *number = entry->nodes.numbers, *end = number + entry->nodes.count;
    struct domain_nodes some = {0};
    while (entry->direction == axis && number < end && domain_next(nodes, &some))
        for (; number < end && *number < some.first + some.count; number++) {
            const int64_t k = *number - some.first;
            double x[] = {some.x[0][k], some.x[1][k], some.x[2][k]};
            if (fabs(x[axis] - plane) > rounding * spacing) continue;
            const double here = largest_at(&entry->value, x, end_time);
            x[axis] += spacing;
            if (here > rounding * largest_at(&entry->value, x, end_time))
                deck_error(entry->where,
                           "this acts along %c on nodes in the plane of symmetry across %c, which "
                           "do not leave it: choose nodes beside the plane, let the value be 0 in "
                           "it, or solve the whole body",
                           'x' + axis, 'x' + axis);
        }
}

void scene_check_images(const struct scene *scene, const struct domain *domain,
                        const struct domain *nodes, const struct lattice *lattice)
{
    for (int axis = 0; axis < 3; axis++) {
        if (!lattice->mirror[axis]) continue;
        for (int i = 0; i < scene->n_boundary; i++)
            check_selection(&scene->boundary[i].nodes.selection, nodes, lattice, axis);
        for (int i = 0; i < scene->n_initial; i++)
            check_selection(&scene->initial[i].nodes.selection, nodes, lattice, axis);
        for (int i = 0; i < scene->n_quantities; i++)
            if (scene->quantities[i].place.index == 0)
                check_selection(&scene->quantities[i].nodes.selection, domain, lattice, axis);
    }
}

void scene_check_planes(const struct scene *scene, const struct domain *nodes,
                        const struct lattice *lattice, double end_time)
{
    for (int axis = 0; axis < 3; axis++) {
        if (!lattice->mirror[axis]) continue;
        for (int i = 0; i < scene->n_boundary; i++)
            check_value(&scene->boundary[i], nodes, lattice, axis, end_time);
        for (int i = 0; i < scene->n_initial; i++)
            check_value(&scene->initial[i], nodes, lattice, axis, end_time);
    }
}
