#include "family.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double constant(double length, double horizon)
{
    (void)length, (void)horizon;
    return 1;
}

/* w = |xi|^-8 (xi in spacings): nearly the nearest neighbours alone, which keeps thin shells apart
 * at horizons of two and three spacings. */
static double steep(double length, double horizon)
{
    (void)horizon;
    return pow(length, -8);
}

static double inverse(double length, double horizon)
{
    (void)horizon;
    return 1 / length;
}

static double linear(double length, double horizon)
{
    return length < horizon ? 1 - length / horizon : 0;
}

static double gaussian(double length, double horizon)
{
    return exp(-4 * length * length / (horizon * horizon));
}

/* The cubic B-spline with its support on the horizon. */
static double spline(double length, double horizon)
{
    const double q = length / horizon, inside = q < 1 ? 1 - q : 0;
    return q < 0.5 ? 1 - 6 * q * q * (1 - q) : 2 * inside * inside * inside;
}

/* All of them, in the order of their numbers. */
#define INFLUENCES(DO) DO(constant), DO(steep), DO(inverse), DO(linear), DO(gaussian), DO(spline)
#define ITSELF(name)   name
#define IN_DECK(name)  #name
static double (*const influences[])(double length, double horizon) = {INFLUENCES(ITSELF)};
const char *const family_influences[] = {INFLUENCES(IN_DECK), NULL};

int family_influence(const char *name)
{
    int number = 0;
    while (strcmp(family_influences[number], name) != 0) number++;
    return number;
}

double family_moment(const struct family *family, int power)
{
    /* Simpson's rule; the functions are smooth but for the middle of the spline, which is a node.
     */
    enum { INTERVALS = 4096 };
    const double step = family->horizon / INTERVALS;
    double sum = 0;
    if (family->influence == family_influence("steep")) return INFINITY;
    for (int k = 1; k <= INTERVALS; k++) {
        const double r = k * step, weight = k == INTERVALS ? 1 : k % 2 ? 4 : 2;
        sum += weight * influences[family->influence](r, family->horizon) * pow(r, power);
    }
    return sum * step / 3;
}

static bool in_half(int x, int y, int z)
{
    return z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
}

double family_weight(const struct family *family, double length)
{
    double part = family->partial ? fmin(1, fmax(0, family->horizon + 0.5 - length)) : 1;
    return part * influences[family->influence](length, family->horizon);
}

static double weight_at(const struct family *family, int x, int y, int z)
{
    const double length = sqrt(x * x + y * y + z * z);
    if (length > 0 && length <= family->horizon * (1 + 1e-9)) return family_weight(family, length);
    return 0;
}

/* (family_sums.2): what the columns have at |x| = k and not yet at k + 1. */
static struct columns columns_new(const struct family *family, int component, int k)
{
    const int reach = family->reach;
    struct columns columns = {
        .items = memory_new((size_t)((2 * reach + 1) * (reach + 1)), sizeof *columns.items)};
    for (int z = 0; z <= reach; z++)
        for (int y = -reach; y <= reach; y++) {
            const double weight = weight_at(family, k, y, z) - weight_at(family, k + 1, y, z),
                         factor = component == 0   ? 1
                                  : component == 1 ? y
                                                   : z;
            if (y == 0 && z == 0 && component == 0) columns.own = weight;
            if (in_half(0, y, z) && weight * factor != 0)
                columns.items[columns.count++] = (struct column){y, z, weight * factor};
        }
    return columns;
}

struct family family_new(double horizon, int influence, bool partial)
{
    const double limit = horizon * (1 + 1e-9);
    const int reach = (int)floor(limit), width = 2 * reach + 1;
    struct family family = {.horizon = horizon,
                            .influence = influence,
                            .partial = partial,
                            .reach = reach,
                            .half =
                                memory_new((size_t)(width * width * width), sizeof(struct offset))};
    for (int z = 0; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double length = sqrt(x * x + y * y + z * z);
                if (!in_half(x, y, z) || length > limit) continue;
                family.half[family.n_half++] =
                    (struct offset){{x, y, z}, family_weight(&family, length)};
            }
    for (int b = 0; b < 3; b++) {
        family.columns[b] = memory_new((size_t)reach + 1, sizeof *family.columns[b]);
        for (int k = 0; k <= reach; k++) family.columns[b][k] = columns_new(&family, b, k);
    }
    return family;
}

int family_number(const struct family *family, const int step[3])
{
    for (int o = 0; o < family->n_half; o++)
        if (memcmp(family->half[o].step, step, 3 * sizeof *step) == 0) return o;
    return -1;
}

void family_free(struct family *family)
{
    free(family->half);
    for (int b = 0; b < 3; b++) {
        for (int k = 0; k <= family->reach; k++) free(family->columns[b][k].items);
        free(family->columns[b]);
    }
    *family = (struct family){0};
}

bool family_invert_shape(const double members[6], int dimensions, double inverse[6])
{
    /* In a plane nothing moves across it: any K_zz will do, and this leaves the measure of the
     * family to the plane. */
    const double across = dimensions == 2 ? 0.5 * (members[0] + members[1]) : members[2];
    const double K[6] = {members[0], members[1], across, members[3], members[4], members[5]};
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

void family_add_shape(const struct offset *offset, int sign, double K[6], double first[3])
{
    const int *step = offset->step;
    const double w = offset->weight;
    K[0] += w * step[0] * step[0];
    K[1] += w * step[1] * step[1];
    K[2] += w * step[2] * step[2];
    K[3] += w * step[0] * step[1];
    K[4] += w * step[1] * step[2];
    K[5] += w * step[2] * step[0];
    for (int a = 0; a < 3; a++) first[a] += w * sign * step[a];
}

bool family_shape(const struct family *family, const struct lattice *lattice, const int at[3],
                  double inverse[6], double first[3])
{
    double K[6] = {0};
    first[0] = first[1] = first[2] = 0;
    for (int o = 0; o < family->n_half; o++) {
        const int *step = family->half[o].step;
        for (int sign = -1; sign <= 1; sign += 2) {
            if (lattice_phase(lattice, at[0] + sign * step[0], at[1] + sign * step[1],
                              at[2] + sign * step[2]) == ABSENT)
                continue;
            family_add_shape(&family->half[o], sign, K, first);
        }
    }
    return family_invert_shape(K, lattice->dimensions, inverse);
}
