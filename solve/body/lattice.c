#include "lattice.h"

#include "die.h"
#include "memory.h"
#include "ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct lattice lattice_find(const struct domain *domain)
{
    struct lattice lattice = {.n_nodes = domain->n_nodes};
    const double *const position[3] = {domain->x, domain->y, domain->z};
    lattice.spacing = attributes_number(&domain->attributes, "spacing_m", cbrt(domain->volume[0]));
    lattice.n_sites = 1;
    for (int a = 0; a < 3; a++) {
        lattice.origin[a] = domain_smallest(position[a], domain->n_nodes);
        double length = domain_largest(position[a], domain->n_nodes) - lattice.origin[a];
        double steps = length / lattice.spacing;
        if (!(steps < 1e6)) die_user("the particles span %g m, over a million spacings", length);
        lattice.size[a] = (int)lround(steps) + 1;
        lattice.n_sites *= lattice.size[a];
    }
    if (lattice.n_sites > 64 * lattice.n_nodes + 1000000)
        die_user(
            "the particles fill less than 1/64 of their box: not a lattice with the spacing of "
            "%g m that their volume gives (scattered particles are not supported)",
            lattice.spacing);
    lattice.phase = memory_new((size_t)lattice.n_sites, 1);
    for (int64_t s = 0; s < lattice.n_sites; s++) lattice.phase[s] = ABSENT;

    const double volume = lattice.spacing * lattice.spacing * lattice.spacing;
    lattice.dimensions = 3;
    lattice.node_volume = volume;
    int64_t before = -1;
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        int at[3];
        for (int a = 0; a < 3; a++) {
            double x = (position[a][i] - lattice.origin[a]) / lattice.spacing;
            at[a] = (int)lround(x);
            if (fabs(x - at[a]) > 1e-6 * fmax(1, lattice.size[a]))
                die_user("node %lld at (%g, %g, %g) m lies off the lattice of spacing %g m "
                         "(scattered particles are not supported)",
                         (long long)i + 1, domain->x[i], domain->y[i], domain->z[i],
                         lattice.spacing);
        }
        if (fabs(domain->volume[i] / volume - 1) > 1e-6)
            die_user("node %lld has the volume %g m3, but spacing^3 is %g m3: particles of unequal "
                     "volume are not supported",
                     (long long)i + 1, domain->volume[i], volume);
        int64_t site = lattice_site(&lattice, at[0], at[1], at[2]);
        if (lattice.phase[site] != ABSENT)
            die_user("node %lld at (%g, %g, %g) m lies on another node", (long long)i + 1,
                     domain->x[i], domain->y[i], domain->z[i]);
        if (site < before)
            die_user("node %lld: the nodes are not in lattice order (x fastest, then y, then z)",
                     (long long)i + 1);
        lattice.phase[site] = domain->phase[i];
        before = site;
    }
    return lattice;
}

struct lattice lattice_scattered(const struct domain *domain, double thickness)
{
    const int64_t n = domain->n_nodes;
    const double *const position[3] = {domain->x, domain->y, domain->z};
    struct lattice lattice = {.size = {(int)n, 1, 1}, .dimensions = 3, .n_sites = n, .n_nodes = n};
    if (n > INT32_MAX) die_user("more than 2^31 scattered particles");
    lattice.phase = memory_new((size_t)n, 1);
    lattice.volume = memory_new((size_t)n, sizeof(double));
    memcpy(lattice.phase, domain->phase, (size_t)n);
    memcpy(lattice.volume, domain->volume, (size_t)n * sizeof(double));
    for (int64_t i = 0; i < n; i++) lattice.node_volume += domain->volume[i];
    lattice.node_volume /= (double)n;
    for (int a = 0; a < 3; a++) {
        lattice.point[a] = memory_new((size_t)n, sizeof(double));
        memcpy(lattice.point[a], position[a], (size_t)n * sizeof(double));
        lattice.origin[a] = domain_smallest(position[a], n);
        lattice.extent[a] = domain_largest(position[a], n) - lattice.origin[a];
    }
    lattice.spacing = cbrt(lattice.node_volume);
    if (thickness > 0 && lattice.extent[2] < 1e-6 * lattice.spacing) {
        lattice.dimensions = 2;
        lattice.thickness = thickness;
        lattice.spacing = sqrt(lattice.node_volume / thickness);
    }
    return lattice;
}

void lattice_share(struct lattice *lattice, int rank)
{
    void *own[5] = {lattice->phase, lattice->volume, lattice->point[0], lattice->point[1],
                    lattice->point[2]};
    ranks_share(lattice, sizeof *lattice);
    const size_t n = (size_t)lattice->n_sites;
    const int arrays = lattice->point[0] ? 5 : 1;
    for (int k = 0; k < arrays; k++) {
        const size_t size = k == 0 ? 1 : sizeof(double);
        if (rank != 0) own[k] = memory_new(n, size);
        ranks_share(own[k], n * size);
    }
    lattice->phase = own[0];
    if (arrays == 1) return;
    lattice->volume = own[1];
    for (int a = 0; a < 3; a++) lattice->point[a] = own[2 + a];
}

void lattice_free(struct lattice *lattice)
{
    free(lattice->phase);
    free(lattice->volume);
    for (int a = 0; a < 3; a++) free(lattice->point[a]);
    *lattice = (struct lattice){0};
}
