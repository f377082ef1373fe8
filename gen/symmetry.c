#include "symmetry.h"

#include "keys.h"

#include <math.h>

/* Half a hole with its images is another body than the one asked for. */
static void check_hole(struct deck_node domain, const struct specimen *specimen)
{
    if (!(specimen->hole_diameter > 0)) return;
    for (int axis = 0; axis < 2; axis++)
        if (specimen->symmetry[axis] &&
            fabs(specimen->hole_centre[axis]) > 1e-6 * specimen->spacing[axis])
            deck_error(deck_get(deck_get(domain, "hole"), "centre"),
                       "the hole's %c, %g m, is not in the plane of symmetry across %c, which "
                       "would make other holes of it: set it to 0, or take %c out of 'symmetry'",
                       'x' + axis, specimen->hole_centre[axis], 'x' + axis, 'x' + axis);
}

void symmetry_read(struct deck_node domain, struct specimen *specimen)
{
    const struct deck_node list = deck_find(domain, "symmetry");
    if (list.index == 0) return;
    keys_axes(list, "symmetry", specimen->symmetry);
    if (specimen->angle != 0)
        deck_error(list, "a body turned against the lattice has no plane of symmetry along it");
    for (int axis = 0; axis < 3; axis++) {
        if (!specimen->symmetry[axis]) continue;
        if (specimen->periodic[axis])
            deck_error(list, "the body is periodic along %c, expected one of the two", 'x' + axis);
        if (axis == 2 && specimen_is_sheet(specimen))
            deck_error(list, "a sheet is one layer thick: its planes of symmetry are across x and "
                             "y");
        if (specimen->count[axis] % 2)
            deck_error(list,
                       "%lld cells along %c have a cell in the plane, expected an even number "
                       "of them: change size or spacing",
                       (long long)specimen->count[axis], 'x' + axis);
    }
    check_hole(domain, specimen);
}

void symmetry_check_layers(struct deck_node where, const struct specimen *specimen, int axis,
                           int64_t low, int64_t high)
{
    const int64_t count = specimen->count[axis];
    if (!specimen->symmetry[axis] || low > high) return;
    if (low >= count / 2 || low + high == count - 1) return;
    deck_error(where,
               "across %c the box is neither above the plane of symmetry, %c = 0, nor its own "
               "image below it: let it begin at 0 or above, or at minus its end, or take %c out of "
               "'symmetry'",
               'x' + axis, 'x' + axis, 'x' + axis);
}

bool symmetry_keeps(const struct specimen *specimen, const double point[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (specimen->symmetry[axis] && point[axis] < 0) return false;
    return true;
}
