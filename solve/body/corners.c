#include "corners.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static bool has_corner(const struct lattice *lattice, int x, int y, int z)
{
    for (int k = 0; k < lattice_corners(lattice); k++) {
        int step[3];
        lattice_corner_step(k, step);
        if (lattice_phase(lattice, x - step[0], y - step[1], z - step[2]) != ABSENT) return true;
    }
    return false;
}

static void mark_corners(struct lattice *lattice)
{
    lattice->corner = memory_new(lattice_corner_bytes(lattice), 1);
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        lattice_position(lattice, site, at);
        if (!has_corner(lattice, at[0], at[1], at[2])) continue;
        lattice->corner[site / 8] |= (uint8_t)(1 << (site % 8));
        lattice->n_nodes++;
    }
}

struct lattice corners_lattice(const struct lattice *particles)
{
    struct lattice lattice = *particles;
    lattice.n_nodes = 0;
    lattice.n_sites = 1;
    for (int a = 0; a < 3; a++) {
        const bool flat = a == 2 && lattice.dimensions == 2;
        /* Along a periodic axis the last ones are images of the first. */
        lattice.size[a] += flat || lattice.periodic[a] ? 0 : 1;
        lattice.origin[a] -= flat ? 0 : 0.5 * lattice.edge[a];
        lattice.n_sites *= lattice.size[a];
    }
    lattice.phase = memory_new((size_t)lattice.n_sites, 1);
    memset(lattice.phase, ABSENT, (size_t)lattice.n_sites);
    if (particles->volume) lattice.volume = memory_new((size_t)lattice.n_sites, sizeof(double));
    if (particles->grain) lattice.grain = memory_new((size_t)lattice.n_sites, sizeof(double));
    for (int64_t site = 0; site < particles->n_sites; site++) {
        int at[3];
        lattice_position(particles, site, at);
        const int64_t to = lattice_site(&lattice, at[0], at[1], at[2]);
        lattice.phase[to] = particles->phase[site];
        if (lattice.volume) lattice.volume[to] = particles->volume[site];
        if (lattice.grain) lattice.grain[to] = particles->grain[site];
    }
    mark_corners(&lattice);
    return lattice;
}

/* Positions of corners, as they are asked for. */
struct corner_source {
    struct domain_source source;
    const struct lattice *lattice;
    int64_t site; /* the next one */
    double *x[3]; /* [AT_ONCE] */
};
enum { AT_ONCE = 1 << 16 };

static void read_corners(struct domain_source *source, struct domain_nodes *nodes)
{
    struct corner_source *own = (struct corner_source *)source;
    if (nodes->first == 0) own->site = 0;
    if (nodes->count > AT_ONCE) nodes->count = AT_ONCE;
    for (int64_t i = 0; i < nodes->count; own->site++) {
        int at[3];
        double x[3];
        if (!lattice_has_node(own->lattice, own->site)) continue;
        lattice_position(own->lattice, own->site, at);
        lattice_coordinates(own->lattice, at, x);
        for (int a = 0; a < 3; a++) own->x[a][i] = x[a];
        i++;
    }
    for (int a = 0; a < 3; a++) nodes->x[a] = own->x[a];
}

static void free_corners(struct domain_source *source)
{
    struct corner_source *own = (struct corner_source *)source;
    for (int a = 0; a < 3; a++) free(own->x[a]);
    free(own);
}

struct domain corners_domain(const struct lattice *lattice)
{
    struct corner_source *source = memory_new(1, sizeof *source);
    *source = (struct corner_source){.source = {.read = read_corners, .free = free_corners},
                                     .lattice = lattice};
    for (int a = 0; a < 3; a++) source->x[a] = memory_new(AT_ONCE, sizeof(double));
    return (struct domain){.n_nodes = lattice->n_nodes, .source = &source->source};
}

int64_t *corners_of_particles(const struct lattice *lattice, const int64_t *particles,
                              int64_t *count)
{
    uint8_t *chosen = memory_new((size_t)lattice->n_sites, 1);
    int64_t particle = 0, next = 0, node = 0, found = 0;
    for (int64_t site = 0; site < lattice->n_sites && next < *count; site++) {
        if (lattice->phase[site] == ABSENT || particle++ != particles[next]) continue;
        for (int k = 0; k < lattice_corners(lattice); k++)
            chosen[lattice_corner_site(lattice, site, k)] = 1;
        next++;
    }
    int64_t *list = NULL;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        if (chosen[site]) {
            list = memory_grow(list, found, sizeof *list);
            list[found++] = node;
        }
        node += lattice_has_node(lattice, site);
    }
    free(chosen);
    *count = found;
    return list;
}

/* Shares of a corner in the volume and mass of its particles. */
static void fill_corner(struct body *body, const double density[], int64_t site)
{
    const struct lattice *lattice = body->lattice;
    const int each = lattice_corners(lattice);
    double mass = 0, volume = 0;
    int at[3], step[3];
    grid_position(&body->grid, site, at);
    for (int k = 0; k < each; k++) {
        lattice_corner_step(k, step);
        const int x = at[0] - step[0], y = at[1] - step[1], z = at[2] - step[2];
        const int phase = lattice_phase(lattice, x, y, z);
        if (phase == ABSENT) continue;
        const int64_t particle = lattice_site_of(lattice, (const int[]){x, y, z});
        const double share = lattice_volume(lattice, particle) / each;
        volume += share;
        mass += density[phase] * share;
    }
    body->volumes[site] = volume;
    body->densities[site] = volume > 0 ? mass / volume : 0;
}

/* The same of a mesh, of which a rank has the whole row. */
static void fill_mesh(struct body *body, const double density[])
{
    const struct lattice *lattice = body->lattice;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        const double share = lattice->volume[site] / 8;
        if (lattice->phase[site] == ABSENT) continue;
        for (int k = 0; k < 8; k++) {
            const int64_t corner = lattice->hexahedron[8 * site + k];
            body->volumes[corner] += share;
            body->densities[corner] += density[lattice->phase[site]] * share;
        }
        body->particle_volumes[site] = lattice->volume[site];
    }
    for (int64_t site = 0; site < lattice->n_sites; site++)
        body->densities[site] /= body->volumes[site];
}

void corners_fill(struct body *body, const double density[])
{
    const struct lattice *lattice = body->lattice;
    const size_t n = (size_t)body->grid.n_sites;
    body->volumes = memory_new(n, sizeof *body->volumes);
    body->densities = memory_new(n, sizeof *body->densities);
    if (lattice->volume) body->particle_volumes = memory_new(n, sizeof *body->particle_volumes);
    if (lattice->hexahedron) {
        fill_mesh(body, density);
        return;
    }
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        fill_corner(body, density, site);
        if (body->particle_volumes && body->grid.phase[site] != ABSENT)
            body->particle_volumes[site] = lattice->volume[body_number(body, site)];
    }
}

const double *corners_mean(const struct body *body, double *field, double *out)
{
    const struct grid *grid = &body->grid;
    const struct lattice *lattice = body->lattice;
    const int each = lattice_corners(body->lattice);
    if (!body->lattice->corner) return field;
    halo_exchange(body->displacement_halo, &field, 1);
    for (int64_t s = 0; s < body->near.count; s++)
        for (int i = 0; i < body->near.items[s].count; i++) {
            const int64_t site = body->near.items[s].site + i;
            double sum = 0;
            for (int k = 0; k < each; k++) {
                int step[3];
                lattice_corner_step(k, step);
                sum += field[lattice->hexahedron ? lattice->hexahedron[8 * site + k]
                                                 : site + grid_shift(grid, step)];
            }
            out[site] = sum / each;
        }
    return out;
}
