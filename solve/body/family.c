#include "family.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double constant(double length)
{
    (void)length;
    return 1;
}

/* w = |xi|^-8 (xi in spacings): nearly the nearest neighbours alone, which keeps thin shells apart at
 * horizons of two and three spacings. */
static double steep(double length)
{
    return pow(length, -8);
}

static double (*const influences[])(double length) = {constant, steep};
const char *const family_influences[] = {"constant", "steep"};
const int family_influence_count = 2;

static bool in_half(int x, int y, int z)
{
    return z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
}

struct family family_new(double horizon, int influence)
{
    const double limit = horizon * (1 + 1e-9);
    const int reach = (int)floor(limit), width = 2 * reach + 1;
    struct family family = {.horizon = horizon,
                            .reach = reach,
                            .half =
                                memory_new((size_t)(width * width * width), sizeof(struct offset))};
    for (int z = 0; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double length = sqrt(x * x + y * y + z * z);
                if (!in_half(x, y, z) || length > limit) continue;
                family.half[family.n_half++] =
                    (struct offset){{x, y, z}, influences[influence](length)};
            }
    return family;
}

void family_free(struct family *family)
{
    free(family->half);
    *family = (struct family){0};
}

static bool invert(const double K[6], double inverse[6])
{
    double xx = K[1] * K[2] - K[4] * K[4], xy = K[4] * K[5] - K[3] * K[2],
           zx = K[3] * K[4] - K[1] * K[5];
    double determinant = K[0] * xx + K[3] * xy + K[5] * zx, mean = (K[0] + K[1] + K[2]) / 3;
    memset(inverse, 0, 6 * sizeof *inverse);
    if (!(determinant > 1e-4 * mean * mean * mean)) return false;
    inverse[0] = xx / determinant;
    inverse[1] = (K[0] * K[2] - K[5] * K[5]) / determinant;
    inverse[2] = (K[0] * K[1] - K[3] * K[3]) / determinant;
    inverse[3] = xy / determinant;
    inverse[4] = (K[3] * K[5] - K[0] * K[4]) / determinant;
    inverse[5] = zx / determinant;
    return true;
}

bool family_shape(const struct family *family, const struct lattice *lattice, const int at[3],
                  double inverse[6], double first[3])
{
    double K[6] = {0};
    first[0] = first[1] = first[2] = 0;
    for (int o = 0; o < family->n_half; o++) {
        const int *step = family->half[o].step;
        const double w = family->half[o].weight;
        for (int sign = -1; sign <= 1; sign += 2) {
            if (lattice_phase(lattice, at[0] + sign * step[0], at[1] + sign * step[1],
                              at[2] + sign * step[2]) == ABSENT)
                continue;
            K[0] += w * step[0] * step[0];
            K[1] += w * step[1] * step[1];
            K[2] += w * step[2] * step[2];
            K[3] += w * step[0] * step[1];
            K[4] += w * step[1] * step[2];
            K[5] += w * step[2] * step[0];
            for (int a = 0; a < 3; a++) first[a] += w * sign * step[a];
        }
    }
    return invert(K, inverse);
}

int64_t family_bonds(const struct family *family, const struct lattice *lattice)
{
    int64_t bonds = 0;
    for (int z = 0; z < lattice->size[2]; z++)
        for (int y = 0; y < lattice->size[1]; y++)
            for (int x = 0; x < lattice->size[0]; x++) {
                if (lattice_phase(lattice, x, y, z) == ABSENT) continue;
                for (int o = 0; o < family->n_half; o++) {
                    const int *s = family->half[o].step;
                    bonds += lattice_phase(lattice, x + s[0], y + s[1], z + s[2]) != ABSENT;
                }
            }
    return bonds;
}
