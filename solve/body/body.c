#include "body.h"

#include "box_fields.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

static void shape_tensors(struct body *body)
{
    struct exact_sum unsupported = exact_sum_new((double)body->lattice->n_nodes);
    for (int64_t s = 0; s < body->near.count; s++) {
        const struct strip *strip = &body->near.items[s];
        for (int i = 0; i < strip->count; i++) {
            int64_t site = strip->site + i;
            int at[3];
            double inverse[6], first[3];
            grid_position(&body->grid, site, at);
            bool spans = family_shape(body->family, body->lattice, at, inverse, first);
            for (int k = 0; k < 6; k++) body->inverse[k][site] = inverse[k];
            for (int k = 0; k < 3; k++) body->first[k][site] = first[k];
            if (!spans && (body->grid.flags[site] & SITE_OWNED)) exact_sum_add(&unsupported, 1);
        }
    }
    double count;
    exact_sum_finish(&unsupported, 1, &count);
    body->unsupported = (int64_t)count;
}

struct body body_new(const struct lattice *lattice, const struct family *family,
                     const struct offset *bonds, int n_bonds, struct ranks ranks)
{
    struct body body = {.ranks = ranks, .lattice = lattice, .family = family};
    body.partition = partition_new(lattice, ranks.size);
    body.grid = grid_new(lattice, &body.partition, family, bonds, n_bonds, ranks.rank);
    body.displacement_halo = halo_new(&body.grid, lattice, &body.partition, SITE_MOVES, ranks.size);
    body.stress_halo = halo_new(&body.grid, lattice, &body.partition, SITE_STRESSED, ranks.size);
    body.gradient_halo = halo_new(&body.grid, lattice, &body.partition, SITE_GHOST, ranks.size);
    body.owned = grid_strips(&body.grid, SITE_OWNED, 0);
    body.near = grid_strips(&body.grid, SITE_NEAR, 0);
    body.ghosts = grid_strips(&body.grid, SITE_NEAR, SITE_OWNED);
    body.volume = lattice->node_volume;
    body.n_nodes = lattice->n_nodes;
    body.whole_volume = lattice_whole_volume(lattice);
    double *fields[9];
    box_fields_new(fields, 9, body.grid.n_sites);
    memcpy(body.u, fields, sizeof body.u);
    memcpy(body.v, fields + 3, sizeof body.v);
    memcpy(body.f, fields + 6, sizeof body.f);
    if (lattice_is_scattered(lattice)) {
        body.volumes = memory_new((size_t)body.grid.n_sites, sizeof(double));
        memcpy(body.volumes, lattice->volume, (size_t)lattice->n_sites * sizeof(double));
    }
    if (n_bonds > 0) body_need_gradient(&body);
    return body;
}

void body_need_gradient(struct body *body)
{
    if (body->H[0]) return;
    box_fields_new(body->H, 9, body->grid.n_sites);
    box_fields_new(body->S, 9, body->grid.n_sites);
    box_fields_new(body->inverse, 6, body->grid.n_sites);
    box_fields_new(body->first, 3, body->grid.n_sites);
    if (!lattice_is_scattered(body->lattice)) shape_tensors(body);
}

void body_profile(struct body *body, struct profile *profile)
{
    body->profile = profile;
    halo_profile(body->displacement_halo, profile);
    halo_profile(body->stress_halo, profile);
    halo_profile(body->gradient_halo, profile);
}

void body_free(struct body *body)
{
    box_fields_free(body->u[0]);
    for (int a = 0; a < 3; a++) free(body->b[a]);
    box_fields_free(body->H[0]);
    box_fields_free(body->S[0]);
    box_fields_free(body->inverse[0]);
    box_fields_free(body->first[0]);
    free(body->volumes);
    free(body->densities);
    free(body->particle_volumes);
    strips_free(&body->owned);
    strips_free(&body->near);
    strips_free(&body->ghosts);
    halo_free(body->displacement_halo);
    halo_free(body->stress_halo);
    halo_free(body->gradient_halo);
    free(body->yield_shift);
    grid_free(&body->grid);
    partition_free(&body->partition);
    *body = (struct body){0};
}
