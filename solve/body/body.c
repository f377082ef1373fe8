#include "body.h"

#include "box_fields.h"
#include "memory.h"
#include "simd.h"

#include <math.h>
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
    body.partition = partition_new(lattice, family->reach, ranks.rank, ranks.size);
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
    for (int a = 0; a < 3; a++) body.frame[4 * a] = 1;
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

/* xx: of K^-1; 0: the node has no gradient */
HS_SIMD static void add_mean(int count, double mean, const double *restrict xx, double *restrict H)
{
    for (int i = 0; i < count; i++) H[i] += xx[i] > 0 ? mean : 0;
}

void body_add_mean(struct body *body, int64_t site, int count)
{
    if (!lattice_is_periodic(body->lattice)) return;
    for (int k = 0; k < 9; k++)
        add_mean(count, body->lattice_gradient[k], body->inverse[0] + site, body->H[k] + site);
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

static void normalise(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int a = 0; a < 3; a++) v[a] /= length;
}

void body_turn(struct body *body, const double direction[3])
{
    double *x = body->frame, *y = x + 3, *z = x + 6;
    memcpy(x, direction, 3 * sizeof *x);
    normalise(x);
    body->turned = x[0] < 1;
    if (!body->turned) return;
    const bool upright = fabs(x[2]) < 1;
    const double up[3] = {upright ? 0 : -1, 0, upright ? 1 : 0},
                 along = up[0] * x[0] + up[2] * x[2];
    for (int a = 0; a < 3; a++) z[a] = up[a] - along * x[a];
    normalise(z);
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        y[a] = z[b] * x[c] - z[c] * x[b];
    }
}

/* out_ab = sum R_ac T_cd R_bd, R with these distances between rows and columns. */
static void turn(const double *R, int row, int column, const double T[9], double out[9])
{
    for (int k = 0; k < 9; k++) {
        out[k] = 0;
        for (int m = 0; m < 9; m++)
            out[k] += R[k / 3 * row + m / 3 * column] * T[m] * R[k % 3 * row + m % 3 * column];
    }
}

void body_to_test(const struct body *body, const double T[9], double out[9])
{
    if (body->turned)
        turn(body->frame, 3, 1, T, out);
    else
        memcpy(out, T, 9 * sizeof *out);
}

void body_to_lattice(const struct body *body, const double T[9], double out[9])
{
    if (body->turned)
        turn(body->frame, 1, 3, T, out);
    else
        memcpy(out, T, 9 * sizeof *out);
}
