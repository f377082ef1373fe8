#include "partition.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Nodes in each layer of a box, across each axis. */
struct layers {
    int64_t all, *count[3];
};

static struct layers count_layers(const struct lattice *lattice, const struct partition_box *box)
{
    struct layers layers = {0};
    for (int a = 0; a < 3; a++)
        layers.count[a] = memory_new((size_t)lattice->size[a], sizeof *layers.count[a]);
    for (int z = box->low[2]; z < box->high[2]; z++)
        for (int y = box->low[1]; y < box->high[1]; y++) {
            const int64_t row = lattice_site(lattice, 0, y, z);
            int64_t here = 0;
            for (int x = box->low[0]; x < box->high[0]; x++) {
                const bool node = lattice_has_node(lattice, row + x);
                layers.count[0][x] += node;
                here += node;
            }
            layers.count[1][y] += here;
            layers.count[2][z] += here;
            layers.all += here;
        }
    return layers;
}

static void shrink(struct partition_box *box, const struct layers *layers)
{
    for (int a = 0; a < 3 && layers->all > 0; a++) {
        while (layers->count[a][box->low[a]] == 0) box->low[a]++;
        while (layers->count[a][box->high[a] - 1] == 0) box->high[a]--;
    }
}

/* The cut across an axis that is nearest to a share of the nodes below it, where either side has
 * nodes for its ranks.  What it costs: nodes that are on the wrong side and missed on the other,
 * and those along the cut; below 0 where there is none. */
static int64_t best_cut(const int64_t *count, int low, int high, int64_t all, const int ranks[2],
                        int *at)
{
    const int64_t share = all * ranks[0] / (ranks[0] + ranks[1]);
    int64_t below = 0, best = -1;
    for (int layer = low; layer + 1 < high; layer++) {
        below += count[layer];
        const int64_t along = count[layer] > count[layer + 1] ? count[layer] : count[layer + 1],
                      cost = 2 * llabs(below - share) + along;
        if (below < ranks[0] || all - below < ranks[1] || (best >= 0 && cost >= best)) continue;
        best = cost;
        *at = layer + 1;
    }
    return best;
}

static void free_layers(struct layers *layers)
{
    for (int a = 0; a < 3; a++) free(layers->count[a]);
}

/* Parts of the box for so many ranks from the first one on; next: of the list of cuts. */
static void divide(struct partition *p, const struct lattice *lattice, struct partition_box box,
                   int first, int ranks, int *next)
{
    struct layers layers = count_layers(lattice, &box);
    struct partition_cut *cut = &p->cuts[(*next)++];
    const int sides[2] = {ranks / 2, ranks - ranks / 2};
    int64_t best = -1;
    *cut = (struct partition_cut){-1, 0, first};
    shrink(&box, &layers);
    /* Of equals z: rows along x stay whole, which vectors run over. */
    for (int a = 2; a >= 0 && ranks > 1; a--) {
        int at = 0;
        const int64_t cost =
            best_cut(layers.count[a], box.low[a], box.high[a], layers.all, sides, &at);
        if (cost < 0 || (best >= 0 && cost >= best)) continue;
        best = cost;
        cut->axis = a;
        cut->at = at;
    }
    free_layers(&layers);
    if (ranks == 1) {
        p->boxes[first] = box;
        return;
    }
    if (best < 0)
        die_user("%d ranks for %lld nodes, of which each takes whole layers: take fewer ranks",
                 p->ranks, (long long)lattice->n_nodes);
    struct partition_box below = box, above = box;
    below.high[cut->axis] = above.low[cut->axis] = cut->at;
    divide(p, lattice, below, first, sides[0], next);
    cut->above = *next;
    divide(p, lattice, above, first + sides[0], sides[1], next);
}

/* The spacing, or so much more that the bins of a loose set take no more room than its particles.
 */
static double bin_width(const struct lattice *lattice)
{
    for (double width = lattice->spacing;; width *= 2) {
        double bins = 1;
        for (int a = 0; a < 3; a++) bins *= lattice->extent[a] / width + 1;
        if (bins <= 64 * (double)lattice->n_sites + 4096) return width;
    }
}

/* The owner of each scattered particle: that of the bin where it lies. */
static struct partition partition_row(const struct lattice *lattice, int size)
{
    struct lattice bins = {.n_sites = 1};
    const int64_t n = lattice->n_sites;
    const double width = bin_width(lattice);
    int64_t *bin = memory_new((size_t)n, sizeof *bin);
    for (int a = 0; a < 3; a++) {
        bins.size[a] = (int)(lattice->extent[a] / width) + 1;
        bins.n_sites *= bins.size[a];
    }
    bins.phase = memory_new((size_t)bins.n_sites, 1);
    memset(bins.phase, ABSENT, (size_t)bins.n_sites);
    int *owner = memory_new((size_t)n, sizeof *owner);
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        for (int a = 0; a < 3; a++) {
            at[a] = (int)((lattice->point[a][i] - lattice->origin[a]) / width);
            at[a] = at[a] < bins.size[a] ? at[a] : bins.size[a] - 1;
        }
        bin[i] = lattice_site(&bins, at[0], at[1], at[2]);
        bins.phase[bin[i]] = 0;
    }
    struct partition p = partition_new(&bins, size);
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        lattice_position(&bins, bin[i], at);
        owner[i] = partition_owner(&p, at[0], at[1], at[2]);
    }
    lattice_free(&bins);
    free(bin);
    p.owner = owner;
    return p;
}

struct partition partition_new(const struct lattice *lattice, int size)
{
    if (lattice_is_row(lattice)) return partition_row(lattice, size);
    struct partition p = {.ranks = size,
                          .cuts = memory_new(2 * (size_t)size, sizeof *p.cuts),
                          .boxes = memory_new((size_t)size, sizeof *p.boxes)};
    struct partition_box whole = {{0}, {lattice->size[0], lattice->size[1], lattice->size[2]}};
    int next = 0;
    divide(&p, lattice, whole, 0, size, &next);
    return p;
}

void partition_free(struct partition *partition)
{
    free(partition->cuts);
    free(partition->boxes);
    free(partition->owner);
    *partition = (struct partition){0};
}
