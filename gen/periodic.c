#include "periodic.h"

#include "die.h"
#include "keys.h"

#include <math.h>

static const char *const axis_names[] = {"x", "y", "z"};

/* --- the key ------------------------------------------------------------------------------------
 */

static void refuse_key(struct deck_node domain, const char *key, const char *why)
{
    const struct deck_node found = deck_find(domain, key);
    if (found.index) deck_error(found, "%s; leave out '%s' or this axis of 'periodic'", why, key);
}

static void check_x(struct deck_node domain)
{
    static const char ends[] = "a body that is periodic along x has no ends to be held, and no "
                               "planes to measure between";
    refuse_key(domain, "grips", ends);
    refuse_key(domain, "gauge", ends);
}

static void check_axis(struct deck_node domain, const struct specimen *specimen, int axis)
{
    const struct deck_node where = deck_get(domain, "periodic");
    if (specimen_is_round(specimen))
        deck_error(where, "a round body is not periodic; a plate is, or a flat dog-bone along z");
    if (axis == 2 && specimen_is_sheet(specimen))
        deck_error(where, "a sheet is one layer thick: it is periodic along x and y at most");
    if (axis == 2) return;
    if (specimen->shape != SPECIMEN_PLATE)
        deck_error(where, "a %s is not everywhere as wide: it is periodic along z at most",
                   specimen_shapes[specimen->shape]);
    if (specimen->angle != 0)
        deck_error(where, "a body turned against the lattice is periodic along z at most");
    refuse_key(domain, "notch", "a notched body is periodic along z at most");
    refuse_key(domain, "hole", "a body with a hole is periodic along z at most");
}

void periodic_read(struct deck_node domain, struct specimen *specimen)
{
    const struct deck_node list = deck_find(domain, "periodic");
    if (list.index == 0) return;
    keys_axes(list, "periodic", specimen->periodic);
    for (int axis = 0; axis < 3; axis++)
        if (specimen->periodic[axis]) check_axis(domain, specimen, axis);
    if (specimen->periodic[0]) check_x(domain);
}

/* --- whole cells of cores -----------------------------------------------------------------------
 */

/* Two counts of cells to choose from, the lower one at least 1. */
static void counts_around(double cells, double counts[2])
{
    counts[0] = fmax(1, floor(cells));
    counts[1] = counts[0] + 1;
}

static _Noreturn void refuse_distance(struct deck_node domain, const struct specimen *specimen,
                                      int axis, const char *lattice, double edge, double distance)
{
    const double size = specimen->size[axis];
    double counts[2];
    counts_around(size / (edge * distance), counts);
    deck_error(
        deck_get(domain, "core_distance"),
        "a periodic body holds whole cells of the lattice, which repeats along each axis "
        "after %.9g core distances (%s), here %.9g m: %.9g m along %s are %.6f of them; use the "
        "core_distance %.9g m (%g cells) or %.9g m (%g), or the size %.9g m or %.9g m",
        edge, lattice, edge * distance, size, axis_names[axis], size / (edge * distance),
        size / counts[0] / edge, counts[0], size / counts[1] / edge, counts[1],
        counts[0] * edge * distance, counts[1] * edge * distance);
}

static void check_size(struct deck_node domain, const struct specimen *specimen, int axis,
                       double cell)
{
    const double rounding = 1e-6, cells = specimen->size[axis] / cell;
    double counts[2];
    if (cells > 0.5 && fabs(cells - round(cells)) <= rounding * cells) return;
    counts_around(cells, counts);
    deck_error(
        deck_item(deck_get(domain, "size"), axis),
        "a periodic body holds whole cells of the lattice: %.9g m along %s are %.6f cells of "
        "%.9g m; use %.9g m or %.9g m",
        specimen->size[axis], axis_names[axis], cells, cell, counts[0] * cell, counts[1] * cell);
}

double periodic_distance(struct deck_node domain, const struct specimen *specimen,
                         const char *lattice, double edge, double distance)
{
    double fitted = 0;
    for (int axis = 0; axis < 3; axis++) {
        if (!specimen->periodic[axis]) continue;
        const double count = fmax(1, round(specimen->size[axis] / (edge * distance)));
        if (fitted == 0) {
            fitted = specimen->size[axis] / count / edge;
            if (fabs(fitted / distance - 1) > PERIODIC_SLACK)
                refuse_distance(domain, specimen, axis, lattice, edge, distance);
        }
        check_size(domain, specimen, axis, fitted * edge);
    }
    if (fitted == 0) return distance;
    if (fabs(fitted / distance - 1) > 1e-9)
        note("core distance taken as %.9g um (said: %.9g um), so that whole cells fill the body",
             1e6 * fitted, 1e6 * distance);
    return fitted;
}
