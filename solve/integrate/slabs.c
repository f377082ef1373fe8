#include "slabs.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Of the boxes before a, those in planes of rank r. */
static int64_t planes_before(const struct slabs *slabs, int a, int r)
{
    int64_t numbers = 0;
    for (int b = 0; b < a; b++)
        numbers +=
            slabs->slab[b].plane * shares_count(slabs->slab[b].size[2], r, slabs->ranks.size);
    return numbers;
}

/* Of the boxes before a, those in planes of rank r and columns of rank s. */
static int64_t crossings_before(const struct slabs *slabs, int a, int r, int s)
{
    const int size = slabs->ranks.size;
    int64_t numbers = 0;
    for (int b = 0; b < a; b++)
        numbers += shares_count(slabs->slab[b].size[2], r, size) *
                   shares_count(slabs->slab[b].plane, s, size);
    return numbers;
}

static void make_columns(struct slabs *slabs)
{
    const int size = slabs->ranks.size, rank = slabs->ranks.rank;
    slabs->cut = shares_new(slabs->ranks);
    slabs->joined = shares_new(slabs->ranks);
    for (int r = 0; r < size; r++) {
        slabs->cut.counts[r] = (int)crossings_before(slabs, 3, rank, r);
        slabs->joined.counts[r] = (int)crossings_before(slabs, 3, r, rank);
    }
    shares_start(&slabs->cut, slabs->ranks);
    shares_start(&slabs->joined, slabs->ranks);
    if (size == 1) return;
    slabs->out = memory_new((size_t)slabs->cut.all, sizeof(float));
    slabs->columns = memory_new((size_t)slabs->joined.all + SLABS_SPARE, sizeof(float));
}

static void find_columns(struct slabs *slabs, int a)
{
    struct slab *slab = &slabs->slab[a];
    int plane = 0;
    slab->turned = memory_new((size_t)slab->size[2], sizeof *slab->turned);
    for (int r = 0; r < slabs->ranks.size; r++) {
        const int64_t start =
            slabs->joined.starts[r] + crossings_before(slabs, a, r, slabs->ranks.rank);
        const int planes = (int)shares_count(slab->size[2], r, slabs->ranks.size);
        for (int p = 0; p < planes; p++)
            slab->turned[plane++] =
                (slabs->columns ? slabs->columns : slabs->values) + start + p * slab->columns;
    }
}

struct slabs slabs_new(const struct box box[3], struct ranks ranks)
{
    struct slabs slabs = {.ranks = ranks, .axis = {0, 1, 2}};
    int64_t y = 0, z = 0;
    for (int a = 0; a < 3; a++) {
        y += box[a].size[1];
        z += box[a].size[2];
    }
    if (y > z) {
        slabs.axis[1] = 2;
        slabs.axis[2] = 1;
    }
    for (int a = 0; a < 3; a++) {
        struct slab *slab = &slabs.slab[a];
        for (int b = 0; b < 3; b++)
            slab->size[b] = box[a].count > 0 ? box[a].size[slabs.axis[b]] : 0;
        slab->plane = (int64_t)slab->size[0] * slab->size[1];
        slab->planes = (int)shares_count(slab->size[2], ranks.rank, ranks.size);
        slab->first = shares_first(slab->plane, ranks.rank, ranks.size);
        slab->columns = shares_count(slab->plane, ranks.rank, ranks.size);
    }
    slabs.n_values = planes_before(&slabs, 3, ranks.rank);
    slabs.values = memory_new((size_t)slabs.n_values + SLABS_SPARE, sizeof(float));
    make_columns(&slabs);
    for (int a = 0; a < 3; a++) {
        slabs.slab[a].values = slabs.values + planes_before(&slabs, a, ranks.rank);
        find_columns(&slabs, a);
    }
    return slabs;
}

void slabs_free(struct slabs *slabs)
{
    for (int a = 0; a < 3; a++) free(slabs->slab[a].turned);
    free(slabs->values);
    free(slabs->out);
    free(slabs->columns);
    shares_free(&slabs->cut);
    shares_free(&slabs->joined);
}

int slabs_find(const struct slabs *slabs, int a, const int place[3], int64_t *number)
{
    const struct slab *slab = &slabs->slab[a];
    const int plane = place[slabs->axis[2]],
              rank = shares_owner(slab->size[2], plane, slabs->ranks.size);
    *number = planes_before(slabs, a, rank) +
              (plane - shares_first(slab->size[2], rank, slabs->ranks.size)) * slab->plane +
              (int64_t)place[slabs->axis[1]] * slab->size[0] + place[slabs->axis[0]];
    return rank;
}

/* Numbers of the planes as they are sent, rank by rank, and back. */
static void pack(struct slabs *slabs, bool back)
{
    float *at = slabs->out;
    for (int r = 0; r < slabs->ranks.size; r++)
        for (int a = 0; a < 3; a++) {
            const struct slab *slab = &slabs->slab[a];
            const int64_t first = shares_first(slab->plane, r, slabs->ranks.size),
                          columns = shares_count(slab->plane, r, slabs->ranks.size);
            for (int p = 0; p < slab->planes; p++, at += columns) {
                float *values = slab->values + p * slab->plane + first;
                memcpy(back ? values : at, back ? at : values, (size_t)columns * sizeof *at);
            }
        }
}

void slabs_turn(struct slabs *slabs)
{
    if (!slabs->columns) return;
    pack(slabs, false);
    shares_send(slabs->out, &slabs->cut, slabs->columns, &slabs->joined);
}

void slabs_turn_back(struct slabs *slabs)
{
    if (!slabs->columns) return;
    shares_send(slabs->columns, &slabs->joined, slabs->out, &slabs->cut);
    pack(slabs, true);
}
