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

/* Of a place above the plane and its image: what a value does at both, and by how much the one is
 * not the image of the other. */
struct parity {
    double largest, off;
    double x[3], here, there; /* where it is off most */
};

static void compare(struct parity *parity, const struct scene_entry *entry, const double x[3],
                    double plane, int axis, double end_time)
{
    enum { TIMES = 3 };
    const struct value *value = &entry->value;
    double image[] = {x[0], x[1], x[2]};
    image[axis] = 2 * plane - x[axis];
    for (int i = 0; i < TIMES; i++) {
        const double time = end_time * i / (TIMES - 1);
        const double here = value->expression ? value_at(value, x, time) : largest_at(value, x, 0);
        const double there = value->expression ? value_at(value, image, time) : here;
        const double off = fabs(entry->direction == axis ? here + there : here - there);
        parity->largest = fmax(parity->largest, fmax(fabs(here), fabs(there)));
        if (off <= parity->off) continue;
        *parity = (struct parity){parity->largest, off, {x[0], x[1], x[2]}, here, there};
    }
}

/* At some of the nodes, above the plane, of what the deck means on both sides: of a block, of a set
 * that has nodes in the plane, else those whose image is meant, too. */
static struct parity parity_of(const struct scene_entry *entry, const struct domain *nodes,
                               const struct lattice *lattice, int axis, double end_time)
{
    const struct selection *selection = &entry->nodes.selection;
    enum { SOME = 1000 };
    const double rounding = 1e-6, plane = lattice->origin[axis], spacing = lattice->spacing;
    const int64_t *first = entry->nodes.numbers, *number = first, *end = first + entry->nodes.count;
    const int64_t stride = 1 + entry->nodes.count / SOME;
    const bool listed = selection->kind == SELECT_SET || selection->kind == SELECT_BLOCK;
    bool reaches = selection->kind != SELECT_SET;
    struct parity parity = {0};
    struct domain_nodes some = {0};
    while (number < end && domain_next(nodes, &some))
        for (; number < end && *number < some.first + some.count; number++) {
            const int64_t k = *number - some.first;
            const double x[] = {some.x[0][k], some.x[1][k], some.x[2][k]};
            double image[] = {x[0], x[1], x[2]};
            image[axis] = 2 * plane - x[axis];
            const bool within = fabs(x[axis] - plane) <= rounding * spacing;
            reaches = reaches || within;
            if (!within && (number - first) % stride == 0 &&
                (listed || selection_holds(selection, spacing, image)))
                compare(&parity, entry, x, plane, axis, end_time);
        }
    return reaches ? parity : (struct parity){0};
}

/* Across the plane the image of a motion or a force points the other way, else the same. */
static void check_parity(const struct scene_entry *entry, const struct domain *nodes,
                         const struct lattice *lattice, int axis, double end_time)
{
    const double rounding = 1e-6;
    const bool across = entry->direction == axis;
    const char name = (char)('x' + axis);
    const struct parity off = parity_of(entry, nodes, lattice, axis, end_time);
    if (off.off <= rounding * off.largest) return;
    deck_error(entry->where,
               "this acts along %c on both sides of the plane of symmetry across %c, by %.6g at "
               "(%.6g, %.6g, %.6g) m and by %.6g at its image, where the image of the body has "
               "%.6g: let the value be %s in %c, choose nodes above the plane alone, or solve the "
               "whole body",
               'x' + entry->direction, name, off.here, off.x[0], off.x[1], off.x[2], off.there,
               across ? -off.here : off.here, across ? "odd" : "even", name);
}

static void check_entry(const struct scene_entry *entry, const struct domain *nodes,
                        const struct lattice *lattice, int axis, double end_time)
{
    check_value(entry, nodes, lattice, axis, end_time);
    check_parity(entry, nodes, lattice, axis, end_time);
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
            check_entry(&scene->boundary[i], nodes, lattice, axis, end_time);
        for (int i = 0; i < scene->n_initial; i++)
            check_entry(&scene->initial[i], nodes, lattice, axis, end_time);
    }
}
