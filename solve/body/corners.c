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
    lattice->corner = memory_new((size_t)lattice->n_sites, 1);
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        lattice_position(lattice, site, at);
        lattice->corner[site] = has_corner(lattice, at[0], at[1], at[2]);
        lattice->n_nodes += lattice->corner[site];
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
    for (int64_t site = 0; site < particles->n_sites; site++) {
        int at[3];
        lattice_position(particles, site, at);
        const int64_t to = lattice_site(&lattice, at[0], at[1], at[2]);
        lattice.phase[to] = particles->phase[site];
        if (lattice.volume) lattice.volume[to] = particles->volume[site];
    }
    mark_corners(&lattice);
    return lattice;
}

struct domain corners_domain(const struct lattice *lattice)
{
    const size_t n = (size_t)lattice->n_nodes;
    struct domain domain = {.n_nodes = lattice->n_nodes,
                            .x = memory_new(n, sizeof(double)),
                            .y = memory_new(n, sizeof(double)),
                            .z = memory_new(n, sizeof(double))};
    double *const position[] = {domain.x, domain.y, domain.z};
    int64_t node = 0;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        double x[3];
        if (!lattice->corner[site]) continue;
        lattice_position(lattice, site, at);
        lattice_coordinates(lattice, at, x);
        for (int a = 0; a < 3; a++) position[a][node] = x[a];
        node++;
    }
    return domain;
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
    int64_t *nodes = memory_new((size_t)lattice->n_nodes, sizeof *nodes);
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        if (chosen[site]) nodes[found++] = node;
        node += lattice->corner[site];
    }
    free(chosen);
    int64_t *list = memory_new((size_t)found, sizeof *list);
    memcpy(list, nodes, (size_t)found * sizeof *list);
    free(nodes);
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
