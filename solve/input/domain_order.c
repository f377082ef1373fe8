#include "domain_order.h"

#include "die.h"
#include "memory.h"
#include "neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void refuse_coincident(const struct domain *domain)
{
    double *const x[3] = {domain->x, domain->y, domain->z};
    double period[3];
    lattice_periods(domain, period);
    struct neighbours close =
        neighbours_new(x, period, domain->n_nodes, 1e-4 * domain_spacing(domain));
    for (int64_t i = 0; i < domain->n_nodes; i++)
        if (neighbours_find(&close, x, i) > 0) {
            const int64_t other = close.found[0];
            die_user("node %lld at (%g, %g, %g) m lies on another node, %lld", (long long)other + 1,
                     x[0][other], x[1][other], x[2][other], (long long)i + 1);
        }
    neighbours_free(&close);
}

/* --- keys --- */

struct place {
    uint64_t key; /* site, or number along the curve */
    double x[3];
    int64_t node;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *s = a, *t = b;
    if (s->key != t->key) return s->key < t->key ? -1 : 1;
    for (int axis = 2; axis >= 0; axis--)
        if (s->x[axis] != t->x[axis]) return s->x[axis] < t->x[axis] ? -1 : 1;
    return (s->node > t->node) - (s->node < t->node);
}

enum { CURVE_BITS = 21 }; /* of each coordinate: three fill 63 */

/* The cube about the body that the curve fills. */
struct cube {
    double low[3], width; /* m */
};

static struct cube cube_about(const struct domain *domain)
{
    const double *const position[3] = {domain->x, domain->y, domain->z};
    struct cube cube = {.width = 0};
    for (int a = 0; a < 3; a++) {
        cube.low[a] = domain_smallest(position[a], domain->n_nodes);
        double span = domain_largest(position[a], domain->n_nodes) - cube.low[a];
        cube.width = fmax(cube.width, span);
    }
    return cube;
}

/* Number of a point's cell along the curve of Morton: the bits of its three coordinates in turn (G.
 * M. Morton, A computer oriented geodetic data base, IBM, 1966). */
static uint64_t curve_number(const struct cube *cube, const double x[3])
{
    const uint64_t cells = UINT64_C(1) << CURVE_BITS;
    uint64_t number = 0;
    for (int a = 0; a < 3; a++) {
        double share = cube->width > 0 ? (x[a] - cube->low[a]) / cube->width : 0;
        uint64_t cell = (uint64_t)(share * (double)cells);
        if (cell >= cells) cell = cells - 1;
        for (int bit = 0; bit < CURVE_BITS; bit++) number |= (cell >> bit & 1) << (3 * bit + a);
    }
    return number;
}

/* --- the order --- */

static int compare_numbers(const void *a, const void *b)
{
    int64_t s = *(const int64_t *)a, t = *(const int64_t *)b;
    return (s > t) - (s < t);
}

static void permute(double *values, const struct place *order, int64_t count)
{
    double *copy = memory_new((size_t)count, sizeof *copy);
    memcpy(copy, values, (size_t)count * sizeof *copy);
    for (int64_t i = 0; i < count; i++) values[i] = copy[order[i].node];
    free(copy);
}

static void permute_hexahedra(struct domain *domain, const struct place *order)
{
    enum { CORNERS = 8 };
    const size_t row = CORNERS * sizeof *domain->hexahedra;
    int64_t *hexahedra = memory_new((size_t)domain->n_nodes, row);
    for (int64_t i = 0; i < domain->n_nodes; i++)
        memcpy(hexahedra + CORNERS * i, domain->hexahedra + CORNERS * order[i].node, row);
    free(domain->hexahedra);
    domain->hexahedra = hexahedra;
}

static void reorder(struct domain *domain, const struct place *order)
{
    const int64_t n = domain->n_nodes;
    permute(domain->x, order, n);
    permute(domain->y, order, n);
    permute(domain->z, order, n);
    permute(domain->volume, order, n);
    if (domain->grain) permute(domain->grain, order, n);
    uint8_t *phase = memory_new((size_t)n, 1);
    int64_t *new_number = memory_new((size_t)n, sizeof *new_number);
    for (int64_t i = 0; i < n; i++) {
        phase[i] = domain->phase[order[i].node];
        new_number[order[i].node] = i;
    }
    free(domain->phase);
    domain->phase = phase;
    if (domain->hexahedra) permute_hexahedra(domain, order);
    for (int k = 0; k < domain->n_sets; k++) {
        struct node_set *set = &domain->sets[k];
        for (int64_t i = 0; i < set->count; i++) set->nodes[i] = new_number[set->nodes[i]];
        qsort(set->nodes, (size_t)set->count, sizeof *set->nodes, compare_numbers);
    }
    free(new_number);
}

/* What a lattice from elsewhere does not say of itself. */
static void complete_facts(struct attributes *facts, const struct lattice *lattice)
{
    if (!(attributes_number(facts, "spacing_m", 0) > 0))
        attributes_set_number(facts, "spacing_m", lattice->spacing);
    if (lattice->dimensions == 3) return;
    attributes_set_number(facts, "dimensions", 2);
    if (!(attributes_number(facts, "thickness_m", 0) > 0))
        attributes_set_number(facts, "thickness_m", lattice->thickness);
}

static void check_plane(const struct domain *domain)
{
    const double low = domain_smallest(domain->z, domain->n_nodes);
    const double high = domain_largest(domain->z, domain->n_nodes);
    if (attributes_number(&domain->attributes, "dimensions", 0) != 2) return;
    if (high - low > 1e-6 * domain_spacing(domain))
        die_user(
            "the particles lie between z = %g m and %g m, but the domain has two dimensions, where "
            "they lie in one plane",
            low, high);
}

static void sort(struct domain *domain, const struct lattice *lattice)
{
    const int64_t n = domain->n_nodes;
    struct cube cube = cube_about(domain);
    struct place *order = memory_new((size_t)n, sizeof *order);
    bool sorted = true;
    for (int64_t i = 0; i < n; i++) {
        order[i] = (struct place){0, {domain->x[i], domain->y[i], domain->z[i]}, i};
        order[i].key = lattice ? (uint64_t)lattice_nearest(lattice, order[i].x)
                               : curve_number(&cube, order[i].x);
        sorted = sorted && (i == 0 || compare_places(&order[i - 1], &order[i]) < 0);
    }
    if (!sorted) {
        qsort(order, (size_t)n, sizeof *order, compare_places);
        reorder(domain, order);
    }
    free(order);
}

bool domain_sort(struct domain *domain, struct lattice *lattice)
{
    check_plane(domain);
    if (lattice_recognise(domain, lattice)) {
        if (!lattice->sorted) sort(domain, lattice);
        complete_facts(&domain->attributes, lattice);
        return true;
    }
    refuse_coincident(domain);
    sort(domain, NULL);
    attributes_set_number(&domain->attributes, "mean_spacing_m", domain_spacing(domain));
    return false;
}
