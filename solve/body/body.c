#include "body.h"

#include "box_fields.h"
#include "die.h"
#include "memory.h"

#include <mpi.h>
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

/* Owned values in site order, as this rank sends them. */
static int64_t pack(const struct body *body, const double *field, double *values, int64_t *sites)
{
    int64_t n = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            values[n] = field[body->owned.items[s].site + i];
            sites[n++] = body_number(body, body->owned.items[s].site + i);
        }
    return n;
}

void body_gather(const struct body *body, const double *field, double *out)
{
    const size_t n = (size_t)body->grid.n_owned;
    double *values = memory_new(n, sizeof *values);
    int64_t *sites = memory_new(n, sizeof *sites);
    pack(body, field, values, sites);
    if (body->ranks.rank != 0) {
        MPI_Send(sites, (int)n, MPI_INT64_T, 0, 1, MPI_COMM_WORLD);
        MPI_Send(values, (int)n, MPI_DOUBLE, 0, 2, MPI_COMM_WORLD);
    } else {
        const struct lattice *lattice = body->lattice;
        double *all = memory_new((size_t)lattice->n_sites, sizeof *all);
        for (size_t i = 0; i < n; i++) all[sites[i]] = values[i];
        for (int r = 1; r < body->ranks.size; r++) {
            MPI_Status status;
            int count;
            MPI_Probe(r, 1, MPI_COMM_WORLD, &status);
            MPI_Get_count(&status, MPI_INT64_T, &count);
            sites = realloc(sites, (size_t)count * sizeof *sites);
            values = realloc(values, (size_t)count * sizeof *values);
            if (!sites || !values) die_run("no memory to gather a field");
            MPI_Recv(sites, count, MPI_INT64_T, r, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
            MPI_Recv(values, count, MPI_DOUBLE, r, 2, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
            for (int i = 0; i < count; i++) all[sites[i]] = values[i];
        }
        int64_t node = 0;
        for (int64_t site = 0; site < lattice->n_sites; site++)
            if (lattice->phase[site] != ABSENT) out[node++] = all[site];
        free(all);
    }
    free(values);
    free(sites);
}
