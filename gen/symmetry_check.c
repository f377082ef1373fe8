#include "symmetry_check.h"

#include "die.h"
#include "topology.h"

#include <math.h>

/* Cells of a random structure are coarse in an order that knows of no image. */
static bool are_cores_own_image(const struct recipe *recipe, const struct cores *cores, int axis)
{
    const double rounding = 1e-6;
    if (!recipe->topology->cores_apart) return false;
    for (int64_t c = 0; c < cores->own; c++) {
        const double *centre = cores->centre[c];
        double image[3] = {centre[0], centre[1], centre[2]};
        image[axis] = -image[axis];
        if (cores_place(cores, image, 0).distance > rounding * cores->distance) return false;
    }
    return true;
}

static bool is_image_own_image(const struct recipe *recipe, int axis)
{
    const struct specimen *specimen = &recipe->specimen;
    const int64_t *count = specimen->count;
    for (int64_t k = 0; k < count[2]; k++)
        for (int64_t j = 0; j < count[1]; j++)
            for (int64_t i = 0; i < count[0]; i++) {
                const int64_t cell[] = {i, j, k};
                if (2 * cell[axis] >= count[axis]) continue;
                double point[3];
                for (int a = 0; a < 3; a++)
                    point[a] = 0.5 * (double)(2 * cell[a] + 1 - count[a]) * specimen->spacing[a];
                const int here = recipe_voxel(recipe, point).phase;
                point[axis] = -point[axis];
                if (recipe_voxel(recipe, point).phase != here) return false;
            }
    return true;
}

void symmetry_warn(const struct recipe *recipe, const struct cores *cores)
{
    const char *source = recipe->cores_file     ? recipe->cores_file
                         : recipe->voxels.phase ? recipe->measured.file
                                                : "the deck";
    for (int axis = 0; axis < 3; axis++) {
        if (!recipe->specimen.symmetry[axis]) continue;
        if (recipe->voxels.phase
                ? is_image_own_image(recipe, axis)
                : recipe->topology->no_cores || are_cores_own_image(recipe, cores, axis))
            continue;
        warn("below the plane of symmetry across %c the structure is the image of that above, not "
             "what %s has there without it",
             'x' + axis, source);
    }
}
