#include "mesh.h"

#include "die.h"
#include "hexahedron.h"
#include "memory.h"
#include "neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 8 };

static int compare_numbers(const void *a, const void *b)
{
    const int64_t s = *(const int64_t *)a, t = *(const int64_t *)b;
    return (s > t) - (s < t);
}

static void join(int64_t *list, int64_t count, const int64_t *first)
{
    for (int64_t i = 0; i < count; i++) list[i] = first[list[i]];
}

int64_t mesh_coincident(struct domain *domain, const double period[3], bool joins)
{
    struct domain *nodes = domain->corners;
    double *const x[3] = {nodes->x, nodes->y, nodes->z};
    int64_t *first = memory_new((size_t)nodes->n_nodes, sizeof *first), found = 0;
    bool *used = memory_new((size_t)nodes->n_nodes, sizeof *used);
    for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++) used[domain->hexahedra[i]] = true;
    struct neighbours close =
        neighbours_new(x, period, nodes->n_nodes, 1e-5 * domain_spacing(domain));
    for (int64_t i = 0; i < nodes->n_nodes; i++) {
        const int64_t count = neighbours_find(&close, x, i);
        first[i] = i;
        for (int64_t k = count - 1; k >= 0 && used[i]; k--)
            if (used[close.found[k]] && close.found[k] < i) first[i] = close.found[k];
        found += first[i] < i;
        first[i] = first[first[i]];
    }
    neighbours_free(&close);
    free(used);
    if (joins) join(domain->hexahedra, CORNERS * domain->n_nodes, first);
    for (int k = 0; joins && k < nodes->n_sets; k++) {
        struct node_set *set = &nodes->sets[k];
        int64_t kept = 0;
        join(set->nodes, set->count, first);
        qsort(set->nodes, (size_t)set->count, sizeof *set->nodes, compare_numbers);
        for (int64_t i = 0; i < set->count; i++)
            if (kept == 0 || set->nodes[kept - 1] != set->nodes[i])
                set->nodes[kept++] = set->nodes[i];
        set->count = kept;
    }
    free(first);
    return found;
}

void mesh_fold(struct domain *domain)
{
    const struct domain *nodes = domain->corners;
    double *const x[3] = {nodes->x, nodes->y, nodes->z};
    const double close = 1e-5 * domain_spacing(domain);
    double period[3];
    lattice_periods(domain, period);
    for (int a = 0; a < 3; a++) {
        const double along[3] = {a == 0 ? period[0] : 0, a == 1 ? period[1] : 0,
                                 a == 2 ? period[2] : 0};
        double low = INFINITY;
        if (!(period[a] > 0)) continue;
        for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++)
            low = fmin(low, x[a][domain->hexahedra[i]]);
        struct neighbours images = neighbours_new(x, along, nodes->n_nodes, close);
        for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++) {
            const int64_t node = domain->hexahedra[i];
            if (x[a][node] > low + close || neighbours_find(&images, x, node) > 0) continue;
            die_user("the mesh is periodic along %c after %g m, and its node at (%g, %g, %g) m has "
                     "no image there: expected faces with the same nodes",
                     'x' + a, period[a], x[0][node], x[1][node], x[2][node]);
        }
        neighbours_free(&images);
    }
    mesh_coincident(domain, period, true);
}

/* New numbers of the mesh's nodes, -1 of those without an element; *used: how many have one. */
static int64_t *number_nodes(const struct domain *domain, int64_t *used)
{
    const int64_t n = domain->corners->n_nodes;
    int64_t *number = memory_new((size_t)n, sizeof *number), next = 0, spare = 0;
    /* -1: no element has it, -2: one has, it waits for its number. */
    for (int64_t i = 0; i < n; i++) number[i] = -1;
    for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++) number[domain->hexahedra[i]] = -2;
    *used = 0;
    for (int64_t i = 0; i < n; i++) *used += number[i] == -2;
    if (*used < domain->n_nodes)
        die_user("the mesh has %lld elements and fewer nodes, %lld, that belong to one: corner "
                 "cannot take it",
                 (long long)domain->n_nodes, (long long)*used);
    for (int64_t p = 0; p < domain->n_nodes; p++) {
        const int64_t *own = domain->hexahedra + CORNERS * p;
        int k = 0;
        while (k < CORNERS && number[own[k]] >= 0) k++;
        while (k == CORNERS && number[spare] != -2) spare++;
        number[k < CORNERS ? own[k] : spare] = next++;
    }
    for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++)
        if (number[domain->hexahedra[i]] == -2) number[domain->hexahedra[i]] = next++;
    return number;
}

static struct domain renumbered(const struct domain *nodes, const int64_t *number, int64_t used)
{
    struct domain corners = {.n_nodes = used};
    const double *const from[3] = {nodes->x, nodes->y, nodes->z};
    double **const to[3] = {&corners.x, &corners.y, &corners.z};
    for (int a = 0; a < 3; a++) {
        *to[a] = memory_new((size_t)used, sizeof(double));
        for (int64_t i = 0; i < nodes->n_nodes; i++)
            if (number[i] >= 0) (*to[a])[number[i]] = from[a][i];
    }
    for (int k = 0; k < nodes->n_sets; k++) {
        const struct node_set *set = &nodes->sets[k];
        int64_t *list = memory_new((size_t)set->count, sizeof *list), count = 0;
        for (int64_t i = 0; i < set->count; i++)
            if (number[set->nodes[i]] >= 0) list[count++] = number[set->nodes[i]];
        qsort(list, (size_t)count, sizeof *list, compare_numbers);
        domain_add_set(&corners, set->name, count, list);
        if (set->alias) domain_alias_set(&corners, set->alias);
        free(list);
    }
    return corners;
}

void mesh_hexahedron(const struct lattice *lattice, int64_t site, struct hexahedron *hexahedron)
{
    const int32_t *corner = lattice->hexahedron + CORNERS * site;
    for (int k = 0; k < CORNERS; k++) {
        lattice_between(lattice, corner[0], corner[k], hexahedron->corner[k]);
        for (int a = 0; a < 3; a++) hexahedron->corner[k][a] += lattice->point[a][corner[0]];
    }
}

/* Edge of the cube whose gradient reaches as far as the element's steepest: on a cube sqrt(3)/(4
 * dx). */
static double find_edge(const struct lattice *lattice, int64_t site)
{
    struct hexahedron hexahedron;
    struct hexahedron_shape shape;
    double steepest = 0;
    mesh_hexahedron(lattice, site, &hexahedron);
    if (!hexahedron_shape(&hexahedron, &shape))
        die_user("the element with the corners (%g, %g, %g) m and (%g, %g, %g) m is inside out in "
                 "its middle or at a Gauss point: expected four corners around a face, then the "
                 "four above them, and angles under 180 degrees",
                 hexahedron.corner[0][0], hexahedron.corner[0][1], hexahedron.corner[0][2],
                 hexahedron.corner[6][0], hexahedron.corner[6][1], hexahedron.corner[6][2]);
    for (int k = 0; k < CORNERS; k++) {
        const double *g = shape.gradient[k];
        steepest = fmax(steepest, sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]));
    }
    return sqrt(3) / 4 / steepest;
}

double *mesh_edges(const struct lattice *lattice)
{
    double *edges = memory_new((size_t)lattice->n_sites, sizeof *edges);
    for (int64_t i = 0; i < lattice->n_sites; i++) edges[i] = INFINITY;
    for (int64_t p = 0; p < lattice->n_particles; p++) {
        const double edge = find_edge(lattice, p);
        for (int k = 0; k < CORNERS; k++) {
            double *own = &edges[lattice->hexahedron[CORNERS * p + k]];
            *own = fmin(*own, edge);
        }
    }
    return edges;
}

static void place_particles(const struct lattice *lattice, struct domain *domain)
{
    for (int64_t p = 0; p < domain->n_nodes; p++) {
        double x[3];
        lattice_particle(lattice, (const int[]){(int)p, 0, 0}, x);
        domain->x[p] = x[0];
        domain->y[p] = x[1];
        domain->z[p] = x[2];
    }
}

struct lattice mesh_lattice(struct domain *domain, struct domain *corners)
{
    int64_t n, *number = number_nodes(domain, &n);
    if (n > INT32_MAX / CORNERS) die_user("more than 2^28 nodes of a mesh");
    *corners = renumbered(domain->corners, number, n);
    struct lattice lattice = lattice_scattered(domain, 0);
    free(lattice.phase);
    free(lattice.volume);
    for (int a = 0; a < 3; a++) free(lattice.point[a]);
    lattice.size[0] = (int)n;
    lattice.n_sites = lattice.n_nodes = n;
    lattice.phase = memory_new((size_t)n, 1);
    lattice.corner = memory_new(lattice_corner_bytes(&lattice), 1);
    lattice.volume = memory_new((size_t)n, sizeof *lattice.volume);
    lattice.hexahedron = memory_new(CORNERS * (size_t)n, sizeof *lattice.hexahedron);
    memset(lattice.phase, ABSENT, (size_t)n);
    memset(lattice.corner, 0xFF, lattice_corner_bytes(&lattice));
    memcpy(lattice.phase, domain->phase, (size_t)domain->n_nodes);
    memcpy(lattice.volume, domain->volume, (size_t)domain->n_nodes * sizeof *lattice.volume);
    for (int64_t i = 0; i < CORNERS * domain->n_nodes; i++)
        lattice.hexahedron[i] = (int32_t)number[domain->hexahedra[i]];
    const double *const position[3] = {corners->x, corners->y, corners->z};
    for (int a = 0; a < 3; a++) {
        lattice.point[a] = memory_new((size_t)n, sizeof(double));
        memcpy(lattice.point[a], position[a], (size_t)n * sizeof(double));
        lattice.extent[a] = lattice.period[a];
        if (lattice.periodic[a]) continue; /* from the lowest of the particles on */
        lattice.origin[a] = domain_smallest(position[a], n);
        lattice.extent[a] = domain_largest(position[a], n) - lattice.origin[a];
    }
    lattice.finest = INFINITY;
    for (int64_t p = 0; p < domain->n_nodes; p++)
        lattice.finest = fmin(lattice.finest, find_edge(&lattice, p));
    place_particles(&lattice, domain);
    free(number);
    domain_forget_mesh(domain);
    return lattice;
}
