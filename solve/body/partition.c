#include "partition.h"

#include "die.h"
#include "memory.h"
#include "ranks.h"
#include "simd.h"

#include <metis.h>
#include <stdlib.h>
#include <string.h>

/* Of large bodies METIS sees wider cells: its graph stays small (8 MB), and its cuts become planes.
 */
enum { CELLS_MOST = 1 << 15, CELLS_OF_A_RANK = 64 };

/* METIS' compressed graph of the cells that hold particles. */
struct cell_graph {
    idx_t n;
    idx_t *start, *neighbour, *edge_weight, *weight;
    int64_t *cell; /* [n] index of the cell */
};

static int64_t cell_count(const struct partition *p)
{
    return (int64_t)p->cells[0] * p->cells[1] * p->cells[2];
}

static idx_t *particles_per_cell(const struct partition *p, const struct lattice *lattice)
{
    idx_t *count = memory_new((size_t)cell_count(p), sizeof *count);
    int64_t site = 0;
    for (int z = 0; z < lattice->size[2]; z++)
        for (int y = 0; y < lattice->size[1]; y++) {
            idx_t *row = count + partition_cell(p, 0, y, z);
            for (int x = 0; x < lattice->size[0]; x++)
                row[x / p->edge[0]] += lattice_has_node(lattice, site++);
        }
    return count;
}

/* Sites of a cell that see those of its neighbour there. */
static idx_t shared_sites(const struct partition *p, int dx, int dy, int dz)
{
    return (dx ? 1 : p->edge[0]) * (dy ? 1 : p->edge[1]) * (dz ? 1 : p->edge[2]);
}

/* None behind the period: a part that went on there would need a field over all of the body. */
static void add_neighbours(struct cell_graph *graph, const struct partition *p, const idx_t *vertex,
                           const int at[3])
{
    idx_t end = graph->start[graph->n];
    for (int dz = -1; dz <= 1; dz++)
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) {
                int to[3] = {at[0] + dx, at[1] + dy, at[2] + dz}, inside = 1;
                for (int a = 0; a < 3; a++) inside &= to[a] >= 0 && to[a] < p->cells[a];
                if (!inside || !(dx || dy || dz)) continue;
                idx_t v = vertex[((int64_t)to[2] * p->cells[1] + to[1]) * p->cells[0] + to[0]];
                if (v < 0) continue;
                graph->neighbour[end] = v;
                graph->edge_weight[end++] = shared_sites(p, dx, dy, dz);
            }
    graph->start[++graph->n] = end;
}

static struct cell_graph graph_new(const struct partition *p, const struct lattice *lattice)
{
    idx_t *count = particles_per_cell(p, lattice),
          *vertex = memory_new((size_t)cell_count(p), sizeof *vertex);
    size_t n = 0;
    for (int64_t c = 0; c < cell_count(p); c++) vertex[c] = count[c] ? (idx_t)n++ : -1;
    struct cell_graph graph = {.start = memory_new(n + 1, sizeof(idx_t)),
                               .weight = memory_new(n, sizeof(idx_t)),
                               .cell = memory_new(n, sizeof(int64_t)),
                               .neighbour = memory_new(26 * n, sizeof(idx_t)),
                               .edge_weight = memory_new(26 * n, sizeof(idx_t))};
    int64_t c = 0;
    for (int z = 0; z < p->cells[2]; z++)
        for (int y = 0; y < p->cells[1]; y++)
            for (int x = 0; x < p->cells[0]; x++, c++) {
                if (vertex[c] < 0) continue;
                graph.weight[graph.n] = count[c];
                graph.cell[graph.n] = c;
                add_neighbours(&graph, p, vertex, (int[]){x, y, z});
            }
    free(count);
    free(vertex);
    return graph;
}

static void graph_free(struct cell_graph *graph)
{
    free(graph->start);
    free(graph->weight);
    free(graph->cell);
    free(graph->neighbour);
    free(graph->edge_weight);
}

static int owns_something(const idx_t *part, idx_t n, int size)
{
    int *count = memory_new((size_t)size, sizeof *count), all = 1;
    for (idx_t i = 0; i < n; i++) count[part[i]]++;
    for (int r = 0; r < size; r++) all &= count[r] > 0;
    free(count);
    return all;
}

static void cut(struct partition *p, const struct lattice *lattice, int size)
{
    struct cell_graph graph = graph_new(p, lattice);
    if (size > graph.n)
        die_user("%d ranks for %d cells of %d x %d x %d sites: take fewer ranks", size,
                 (int)graph.n, p->edge[0], p->edge[1], p->edge[2]);
    idx_t *part = memory_new((size_t)graph.n, sizeof *part);
    idx_t constraints = 1, parts = size, edge_cut, options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    int result = METIS_OK;
    if (size > 1)
        result = METIS_PartGraphRecursive(&graph.n, &constraints, graph.start, graph.neighbour,
                                          graph.weight, NULL, graph.edge_weight, &parts, NULL, NULL,
                                          options, &edge_cut, part);
    if (result != METIS_OK) die_run("METIS failed with code %d", result);
    if (!owns_something(part, graph.n, size))
        die_user("%d ranks are too many for this domain: one of them would hold no particle", size);
    for (idx_t i = 0; i < graph.n; i++) p->owner[graph.cell[i]] = (int)part[i];
    free(part);
    graph_free(&graph);
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

/* The owner of each scattered particle: that of the cell, as wide as on a lattice, where it lies.
 */
static struct partition partition_scattered(const struct lattice *lattice, int reach, int rank,
                                            int size)
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
    struct partition p = {.edge = {1, 1, 1}, .cells = {(int)n, 1, 1}};
    p.owner = memory_new((size_t)n, sizeof *p.owner);
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        for (int a = 0; a < 3; a++) {
            at[a] = (int)((lattice->point[a][i] - lattice->origin[a]) / width);
            at[a] = at[a] < bins.size[a] ? at[a] : bins.size[a] - 1;
        }
        bin[i] = lattice_site(&bins, at[0], at[1], at[2]);
        bins.phase[bin[i]] = 0;
    }
    struct partition cells = partition_new(&bins, reach, rank, size);
    for (int64_t i = 0; i < n; i++) {
        int at[3];
        lattice_position(&bins, bin[i], at);
        p.owner[i] = partition_owner(&cells, at[0], at[1], at[2]);
    }
    partition_free(&cells);
    lattice_free(&bins);
    free(bin);
    return p;
}

/* Cells of those edges; how many. */
static int64_t divide(struct partition *p, const struct lattice *lattice)
{
    for (int a = 0; a < 3; a++) p->cells[a] = (lattice->size[a] + p->edge[a] - 1) / p->edge[a];
    return cell_count(p);
}

/* As many cells as balance the ranks, of whole strips where there are enough of those. */
static void choose_cells(struct partition *p, const struct lattice *lattice, int reach, int size)
{
    const int least = reach > 2 ? reach : 2;
    const int64_t enough = CELLS_OF_A_RANK * (int64_t)size,
                  most = enough < CELLS_MOST ? CELLS_MOST : enough;
    p->edge[0] = LANES;
    p->edge[1] = p->edge[2] = least;
    while (divide(p, lattice) < enough && p->edge[0] > least)
        p->edge[0] = p->edge[0] / 2 > least ? p->edge[0] / 2 : least;
    while (divide(p, lattice) > most) p->edge[1] = ++p->edge[2];
}

struct partition partition_new(const struct lattice *lattice, int reach, int rank, int size)
{
    if (lattice_is_row(lattice)) return partition_scattered(lattice, reach, rank, size);
    struct partition p = {0};
    choose_cells(&p, lattice, reach, size);
    p.owner = memory_new((size_t)cell_count(&p), sizeof *p.owner);
    for (int64_t c = 0; c < cell_count(&p); c++) p.owner[c] = -1;
    if (rank == 0) cut(&p, lattice, size);
    ranks_share(p.owner, (size_t)cell_count(&p) * sizeof *p.owner);
    return p;
}

void partition_free(struct partition *partition)
{
    free(partition->owner);
    *partition = (struct partition){0};
}
