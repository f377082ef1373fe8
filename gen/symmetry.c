#include "symmetry.h"

void symmetry_read(struct deck_node domain, struct specimen *specimen)
{
    static const char *const axes[] = {"x", "y", "z"};
    const struct deck_node list = deck_find(domain, "symmetry");
    if (list.index == 0) return;
    if (!deck_is_list(list) || deck_count(list) == 0)
        deck_error(list, "symmetry is a list of axes: [y, z], or others of x, y, z");
    if (specimen->angle != 0)
        deck_error(list, "a body turned against the lattice has no plane of symmetry along it");
    for (int i = 0; i < deck_count(list); i++) {
        const struct deck_node item = deck_item(list, i);
        const int axis = deck_choice(item, axes, 3);
        if (specimen->symmetry[axis]) deck_error(item, "%s is in the list already", axes[axis]);
        if (specimen->periodic[axis])
            deck_error(item, "the body is periodic along %s, expected one of the two", axes[axis]);
        if (axis == 2 && specimen_is_sheet(specimen))
            deck_error(item, "a sheet is one layer thick: its planes of symmetry are across x and "
                             "y");
        if (specimen->count[axis] % 2)
            deck_error(item,
                       "%lld cells along %s have a cell in the plane, expected an even number "
                       "of them: change size or spacing",
                       (long long)specimen->count[axis], axes[axis]);
        specimen->symmetry[axis] = true;
    }
}

bool symmetry_keeps(const struct specimen *specimen, const double point[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (specimen->symmetry[axis] && point[axis] < 0) return false;
    return true;
}
