#include "symmetry.h"

#include "keys.h"

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
}

bool symmetry_keeps(const struct specimen *specimen, const double point[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (specimen->symmetry[axis] && point[axis] < 0) return false;
    return true;
}
