#include "transform.h"

#include "box.h"
#include "memory.h"
#include "placement.h"
#include "simd.h"
#include "slabs.h"
#include "waves.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = WAVES_WIDTH };

struct transform {
    bool crowded;
    double filled;
    bool coupled; /* the three components are inverted together */
    struct slabs slabs;
    struct placement *placement;
    struct waves *waves[3][3]; /* of a component; along a row, across rows, across planes */
    float
        *inverse[SYMBOL_ENTRIES]; /* [tile][size[2]][WIDTH] of this rank's columns, WIDTH a tile */
    float (*room)[WIDTH], (*other)[WIDTH]; /* [the longest axis], the second three times as long */
    int longest;
};

static int64_t tiles(const struct slab *slab)
{
    return (slab->columns + WIDTH - 1) / WIDTH;
}

static void make_waves(struct transform *transform, const struct box *box, int a,
                       const struct lattice *lattice)
{
    for (int b = 0; b < 3; b++) {
        const int axis = transform->slabs.axis[b], n = box->size[axis];
        const bool low = box->held[axis][0], high = box->held[axis][1];
        /* Across the one layer of a plane there are no corners, and those of a mesh that is flatter
         * than the lattice they are put on fall into one. */
        const bool corners =
            lattice->corner && axis < lattice->dimensions && (n > 1 || low || high);
        transform->waves[a][b] = box->periodic[axis]
                                     ? waves_new_periodic(n, transform->coupled && axis == a)
                                     : waves_new(n, corners, low, high);
    }
}

/* Of the rows across which this rank's columns lie; values as in symbol_evaluate. */
static double *stiffness_new(const struct transform *transform, const struct symbol *symbol,
                             int entry, int first_row, int rows)
{
    const int a = entry < 3 ? entry : 0; /* coupled components have the same wave numbers */
    const struct slab *slab = &transform->slabs.slab[a];
    const int *axis = transform->slabs.axis, counts[3] = {slab->size[0], rows, slab->size[2]};
    double *k[3], *values = memory_new((size_t)slab->size[0] * (size_t)rows * (size_t)slab->size[2],
                                       sizeof *values);
    int n[3];
    for (int b = 0; b < 3; b++) {
        n[axis[b]] = counts[b];
        k[axis[b]] = memory_new((size_t)counts[b], sizeof *k[0]);
        for (int i = 0; i < counts[b]; i++)
            k[axis[b]][i] = waves_number(transform->waves[a][b], i + (b == 1 ? first_row : 0));
    }
    symbol_evaluate(symbol, entry, n, k, values);
    for (int b = 0; b < 3; b++) free(k[b]);
    return values;
}

static void find_inverse(struct transform *transform, const struct symbol *symbol, int a,
                         bool floats)
{
    const struct slab *slab = &transform->slabs.slab[a];
    const int across_rows = transform->slabs.axis[1], planes = slab->size[2],
              first_row = (int)(slab->first / slab->size[0]),
              rows = (int)((slab->first + slab->columns - 1) / slab->size[0]) + 1 - first_row;
    double *stiffness = stiffness_new(transform, symbol, a, first_row, rows);
    /* Motions of the whole body, and across a layer, have no stiffness of their own. */
    const double own = symbol->answer[a][0], least = own > 0 ? 3e-6 * own : 1;
    float *inverse = memory_new((size_t)(tiles(slab) * planes) * WIDTH, sizeof *inverse);
    for (int64_t c = 0; c < slab->columns; c++)
        for (int p = 0; p < planes; p++) {
            const int64_t x = (slab->first + c) % slab->size[0],
                          row = (slab->first + c) / slab->size[0] - first_row,
                          line = across_rows == 1 ? (int64_t)p * rows + row : row * planes + p;
            inverse[(c / WIDTH * planes + p) * WIDTH + c % WIDTH] =
                (float)(1 / (fmax(stiffness[line * slab->size[0] + x], 0) + least));
        }
    /* Forces on what is held nowhere have no sum but that of rounding. */
    if (floats && slab->first == 0) inverse[0] = 0;
    transform->inverse[a] = inverse;
    free(stiffness);
}

/* 1, or -1 where the waves of a number are sines. */
static double sign_of(int k, int n)
{
    return 2 * k >= n ? -1 : 1;
}

/* out: the inverse of a symmetric matrix, both in the order of the symbol's entries. */
static void invert_symmetric(const double m[SYMBOL_ENTRIES], double out[SYMBOL_ENTRIES])
{
    const double xx = m[1] * m[2] - m[3] * m[3], xy = m[3] * m[4] - m[5] * m[2],
                 xz = m[5] * m[3] - m[1] * m[4];
    const double determinant = m[0] * xx + m[5] * xy + m[4] * xz;
    const double minors[] = {
        xx, m[0] * m[2] - m[4] * m[4], m[0] * m[1] - m[5] * m[5], m[4] * m[5] - m[0] * m[3], xz,
        xy};
    for (int e = 0; e < SYMBOL_ENTRIES; e++) out[e] = minors[e] / determinant;
}

/* Where (symbol.2) takes a wave of one component to one of another, its sign is that of what a
 * product of sines with it leaves: the waves of a component along its own axis are exchanged, so
 * that those which answer to each other have the same place. */
static void find_coupled(struct transform *transform, const struct symbol *symbol)
{
    const struct slab *slab = &transform->slabs.slab[0];
    const int *axis = transform->slabs.axis, planes = slab->size[2],
              first_row = (int)(slab->first / slab->size[0]),
              rows = (int)((slab->first + slab->columns - 1) / slab->size[0]) + 1 - first_row;
    double *stiffness[SYMBOL_ENTRIES];
    for (int e = 0; e < SYMBOL_ENTRIES; e++) {
        stiffness[e] = stiffness_new(transform, symbol, e, first_row, rows);
        transform->inverse[e] = memory_new((size_t)(tiles(slab) * planes) * WIDTH, sizeof(float));
    }
    for (int64_t c = 0; c < slab->columns; c++)
        for (int p = 0; p < planes; p++) {
            const int64_t x = (slab->first + c) % slab->size[0],
                          row = (slab->first + c) / slab->size[0],
                          line = axis[1] == 1 ? (int64_t)p * rows + row - first_row
                                              : (row - first_row) * planes + p;
            double sign[3], m[SYMBOL_ENTRIES], inverse[SYMBOL_ENTRIES];
            sign[axis[0]] = sign_of((int)x, slab->size[0]);
            sign[axis[1]] = sign_of((int)row, slab->size[1]);
            sign[axis[2]] = sign_of(p, planes);
            for (int e = 0; e < SYMBOL_ENTRIES; e++) {
                const double value = stiffness[e][line * slab->size[0] + x];
                const double own = e < 3 ? symbol->answer[e][0] : 0,
                             least = own > 0 ? 3e-6 * own : 1;
                m[e] =
                    e < 3 ? fmax(value, 0) + least : -sign[(e + 1) % 3] * sign[(e + 2) % 3] * value;
            }
            invert_symmetric(m, inverse);
            const bool whole = x == 0 && row == 0 && p == 0; /* a motion as a whole */
            for (int e = 0; e < SYMBOL_ENTRIES; e++)
                transform->inverse[e][(c / WIDTH * planes + p) * WIDTH + c % WIDTH] =
                    whole ? 0 : (float)inverse[e];
        }
    for (int e = 0; e < SYMBOL_ENTRIES; e++) free(stiffness[e]);
}

/* Of a body that is periodic along all of its axes, and held nowhere. */
static bool is_coupled(const struct lattice *lattice, const struct box box[3])
{
    bool coupled = true;
    for (int a = 0; a < 3; a++)
        coupled = coupled && box[a].floats && (lattice->periodic[a] || a >= lattice->dimensions);
    return coupled;
}

/* Nodes of a mesh stand for more or fewer places than one. */
static double filled_share(const struct unknowns *unknowns, const struct box *box, int a)
{
    const struct lattice *lattice = unknowns->body->lattice;
    const double ratio =
        lattice->hexahedron ? (double)lattice->n_particles / (double)lattice->n_nodes : 1;
    double count = 0;
    for (int64_t i = 0; i < unknowns->n_nodes; i++)
        count += unknowns->free[a * unknowns->n_nodes + i] > 0;
    ranks_sum(&count, 1);
    return ratio * count / (double)box->count;
}

struct transform *transform_new(const struct unknowns *unknowns, const struct box box[3],
                                const struct symbol *symbol, bool held)
{
    struct transform *transform = memory_new(1, sizeof *transform);
    int longest = 0;
    transform->filled = 1;
    transform->coupled = is_coupled(unknowns->body->lattice, box);
    transform->slabs = slabs_new(box, unknowns->body->ranks);
    transform->placement = placement_new(unknowns, box, &transform->slabs, held);
    transform->crowded = placement_is_crowded(transform->placement);
    for (int a = 0; a < 3; a++) {
        if (box[a].count == 0) continue;
        transform->filled = fmin(transform->filled, filled_share(unknowns, &box[a], a));
        make_waves(transform, &box[a], a, unknowns->body->lattice);
        if (transform->slabs.slab[a].columns > 0 && !transform->coupled)
            find_inverse(transform, symbol, a, box[a].floats);
        for (int b = 0; b < 3; b++) longest = box[a].size[b] > longest ? box[a].size[b] : longest;
    }
    if (transform->coupled && transform->slabs.slab[0].columns > 0) find_coupled(transform, symbol);
    transform->longest = longest;
    transform->room = memory_new((size_t)longest, sizeof *transform->room);
    transform->other = memory_new(3 * (size_t)longest, sizeof *transform->other);
    return transform;
}

void transform_free(struct transform *transform)
{
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) waves_free(transform->waves[a][b]);
    }
    for (int e = 0; e < SYMBOL_ENTRIES; e++) free(transform->inverse[e]);
    free(transform->room);
    free(transform->other);
    placement_free(transform->placement);
    slabs_free(&transform->slabs);
    free(transform);
}

double transform_filled(const struct transform *transform)
{
    return transform->filled;
}

bool transform_is_crowded(const struct transform *transform)
{
    return transform->crowded;
}

typedef float row __attribute__((vector_size(WIDTH * sizeof(float))));

/* Numbers of two rows that are so far apart change places. */
#define LOWER(k, apart) ((k) & (apart) ? WIDTH + (k) - (apart) : (k))
#define UPPER(k, apart) ((k) & (apart) ? WIDTH + (k) : (k) + (apart))
#define FOUR(PLACE, k, apart)                                                                      \
    PLACE(k, apart), PLACE(k + 1, apart), PLACE(k + 2, apart), PLACE(k + 3, apart)
#define PLACES(PLACE, apart)                                                                       \
    FOUR(PLACE, 0, apart), FOUR(PLACE, 4, apart), FOUR(PLACE, 8, apart), FOUR(PLACE, 12, apart)
#define EXCHANGE(rows, apart)                                                                      \
    for (int i = 0; i < WIDTH; i++) {                                                              \
        if (i & (apart)) continue;                                                                 \
        const row a = (rows)[i], b = (rows)[i + (apart)];                                          \
        (rows)[i] = __builtin_shufflevector(a, b, PLACES(LOWER, apart));                           \
        (rows)[i + (apart)] = __builtin_shufflevector(a, b, PLACES(UPPER, apart));                 \
    }
_Static_assert(WIDTH == 16, "places of a row");

/* A square of WIDTH rows of WIDTH numbers, turned. */
HS_INLINE void turn_square(const float *from, int64_t from_row, float *to, int64_t to_row)
{
    row rows[WIDTH];
    for (int i = 0; i < WIDTH; i++) memcpy(&rows[i], from + i * from_row, sizeof rows[i]);
    EXCHANGE(rows, 1)
    EXCHANGE(rows, 2)
    EXCHANGE(rows, 4)
    EXCHANGE(rows, 8)
    for (int i = 0; i < WIDTH; i++) memcpy(to + i * to_row, &rows[i], sizeof rows[i]);
}

/* WIDTH lines, or fewer, next to each other into their lanes, and back. */
HS_SIMD static void load_rows(int lines, int n, const float *restrict values,
                              float (*restrict room)[WIDTH])
{
    int i = 0;
    for (; lines == WIDTH && i + WIDTH <= n; i += WIDTH) turn_square(values + i, n, room[i], WIDTH);
    for (; i < n; i++)
        for (int l = 0; l < lines; l++) room[i][l] = values[(int64_t)l * n + i];
}
HS_SIMD static void store_rows(int lines, int n, float *restrict values,
                               const float (*restrict room)[WIDTH])
{
    int first = 0;
    for (; lines == WIDTH && first + WIDTH <= n; first += WIDTH)
        turn_square(room[first], WIDTH, values + first, n);
    for (int l = 0; l < lines; l++)
        for (int i = first; i < n; i++) values[(int64_t)l * n + i] = room[i][l];
}

static void along_rows(struct transform *transform, int a, bool back)
{
    const struct slab *slab = &transform->slabs.slab[a];
    const int n = slab->size[0];
    const int64_t count = (int64_t)slab->planes * slab->size[1];
    for (int64_t line = 0; line < count; line += WIDTH) {
        const int lines = count - line < WIDTH ? (int)(count - line) : WIDTH;
        float *values = slab->values + line * n;
        load_rows(lines, n, values, transform->room);
        waves_transform(transform->waves[a][0], back, transform->room, transform->other);
        store_rows(lines, n, values, (const float(*)[WIDTH])transform->other);
    }
}

/* Lanes from the first on, so many, as bits of numbers. */
struct lanes {
    uint32_t bits[WIDTH];
};
HS_INLINE struct lanes lanes_of(int first, int lines)
{
    struct lanes lanes;
    for (int l = 0; l < WIDTH; l++)
        lanes.bits[l] = l >= first && l < first + lines ? UINT32_MAX : 0;
    return lanes;
}
/* Those of a row, beside what is there. */
HS_INLINE void put_lanes(const struct lanes *lanes, const float *from, float *to)
{
    uint32_t given[WIDTH], there[WIDTH];
    memcpy(given, from, sizeof given);
    memcpy(there, to, sizeof there);
    for (int l = 0; l < WIDTH; l++)
        there[l] = (given[l] & lanes->bits[l]) | (there[l] & ~lanes->bits[l]);
    memcpy(to, there, sizeof there);
}

/* Rows of numbers into so many lanes from the first on, and back; what lies beside them is read and
 * written as it is, too, so that whole rows of lanes are taken. */
HS_SIMD static void load_lines(int first, int n, const float *values, int64_t apart,
                               float (*room)[WIDTH])
{
    const struct lanes lanes = lanes_of(first, WIDTH);
    for (int i = 0; i < n; i++) put_lanes(&lanes, values + i * apart - first, room[i]);
}
HS_SIMD static void store_lines(int first, int lines, int n, float *values, int64_t apart,
                                float (*room)[WIDTH])
{
    const struct lanes lanes = lanes_of(first, lines);
    for (int i = 0; i < n; i++) put_lanes(&lanes, room[i], values + i * apart - first);
}
HS_SIMD static void load_columns(int n, float *const *turned, int64_t first, float (*room)[WIDTH])
{
    for (int p = 0; p < n; p++) memcpy(room[p], turned[p] + first, sizeof room[p]);
}
HS_SIMD static void store_columns(int lines, int n, float *const *turned, int64_t first,
                                  float (*room)[WIDTH])
{
    const struct lanes lanes = lanes_of(0, lines);
    for (int p = 0; p < n; p++) put_lanes(&lanes, room[p], turned[p] + first);
}

/* Lines of several planes share lanes. */
static void across_rows(struct transform *transform, int a, bool back)
{
    const struct slab *slab = &transform->slabs.slab[a];
    const int n = slab->size[1], wide = slab->size[0];
    const int64_t count = (int64_t)slab->planes * wide;
    for (int64_t line = 0; line < count; line += WIDTH)
        for (int storing = 0; storing < 2; storing++) {
            for (int64_t at = line; at < count && at < line + WIDTH;) {
                const int64_t plane = at / wide, x = at % wide;
                const int first = (int)(at - line),
                          lines = (int)(wide - x < WIDTH - first ? wide - x : WIDTH - first);
                float *values = slab->values + plane * slab->plane + x;
                if (storing)
                    store_lines(first, lines, n, values, wide, transform->other);
                else
                    load_lines(first, n, values, wide, transform->room);
                at += lines;
            }
            if (!storing)
                waves_transform(transform->waves[a][1], back, transform->room, transform->other);
        }
}

HS_SIMD static void multiply(int64_t count, const float *restrict by, float *restrict values)
{
    for (int64_t i = 0; i < count; i++) values[i] *= by[i];
}

/* Across the planes, over the stiffness, and back. */
static void divide(struct transform *transform, int a)
{
    const struct slab *slab = &transform->slabs.slab[a];
    const struct waves *waves = transform->waves[a][2];
    const int n = slab->size[2];
    for (int64_t tile = 0; tile < tiles(slab); tile++) {
        const int64_t first = tile * WIDTH, left = slab->columns - first;
        const int lines = left < WIDTH ? (int)left : WIDTH;
        load_columns(n, slab->turned, first, transform->room);
        waves_transform(waves, false, transform->room, transform->other);
        multiply((int64_t)n * WIDTH, transform->inverse[a] + tile * n * WIDTH, transform->other[0]);
        waves_transform(waves, true, transform->other, transform->room);
        store_columns(lines, n, slab->turned, first, transform->room);
    }
}

/* (xx, yy, zz, yz, zx, xy) times (x, y, z) */
HS_SIMD static void multiply_coupled(int64_t count, const float *restrict xx,
                                     const float *restrict yy, const float *restrict zz,
                                     const float *restrict yz, const float *restrict zx,
                                     const float *restrict xy, float *restrict x, float *restrict y,
                                     float *restrict z)
{
    for (int64_t i = 0; i < count; i++) {
        const float u = x[i], v = y[i], w = z[i];
        x[i] = (xx[i] * u + xy[i] * v) + zx[i] * w;
        y[i] = (xy[i] * u + yy[i] * v) + yz[i] * w;
        z[i] = (zx[i] * u + yz[i] * v) + zz[i] * w;
    }
}

/* The same of all components. */
static void divide_coupled(struct transform *transform)
{
    const struct slab *slab = transform->slabs.slab;
    const int n = slab->size[2];
    for (int64_t tile = 0; tile < tiles(slab); tile++) {
        const int64_t first = tile * WIDTH, left = slab->columns - first, at = tile * n * WIDTH;
        const int lines = left < WIDTH ? (int)left : WIDTH;
        float(*other[3])[WIDTH], **inverse = transform->inverse;
        for (int a = 0; a < 3; a++) {
            other[a] = transform->other + (int64_t)a * transform->longest;
            load_columns(n, slab[a].turned, first, transform->room);
            waves_transform(transform->waves[a][2], false, transform->room, other[a]);
        }
        multiply_coupled((int64_t)n * WIDTH, inverse[0] + at, inverse[1] + at, inverse[2] + at,
                         inverse[3] + at, inverse[4] + at, inverse[5] + at, other[0][0],
                         other[1][0], other[2][0]);
        for (int a = 0; a < 3; a++) {
            waves_transform(transform->waves[a][2], true, other[a], transform->room);
            store_columns(lines, n, slab[a].turned, first, transform->room);
        }
    }
}

void transform_apply(struct transform *transform, const double *r, float *z)
{
    placement_put(transform->placement, r);
    for (int a = 0; a < 3; a++) {
        along_rows(transform, a, false);
        across_rows(transform, a, false);
    }
    slabs_turn(&transform->slabs);
    for (int a = 0; a < 3 && !transform->coupled; a++) divide(transform, a);
    if (transform->coupled) divide_coupled(transform);
    slabs_turn_back(&transform->slabs);
    for (int a = 0; a < 3; a++) {
        across_rows(transform, a, true);
        along_rows(transform, a, true);
    }
    placement_take(transform->placement, z);
}
