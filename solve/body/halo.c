#include "halo.h"

#include "memory.h"
#include "profile.h"

#include <mpi.h>
#include <stdlib.h>

enum { MOST_FIELDS = 9 };

/* What goes to and comes from one rank: box indices in the order of the global sites. */
struct peer {
    int rank;
    int64_t n_send, n_receive;
    int64_t *send, *receive;
    double *out, *in;
};

struct halo {
    struct profile *profile; /* NULL: none */
    int n_peers;
    struct peer *peers;
    MPI_Request *requests; /* [2 * n_peers] */
};

/* The global sites wanted from other ranks, grouped by rank; wanted[r] of them from rank r. */
static int64_t *wanted_sites(const struct grid *grid, const struct lattice *lattice,
                             const struct partition *partition, int flag, int size, int *wanted)
{
    int64_t total = 0;
    int *owner = memory_new((size_t)grid->n_sites, sizeof *owner), at[3];
    for (int64_t site = 0; site < grid->n_sites; site++) {
        if (!(grid->flags[site] & flag)) continue;
        grid_position(grid, site, at);
        owner[site] = partition_owner(partition, at[0], at[1], at[2]);
        wanted[owner[site]]++;
        total++;
    }
    int64_t *sites = memory_new((size_t)total, sizeof *sites);
    int64_t *next = memory_new((size_t)size, sizeof *next);
    for (int r = 1; r < size; r++) next[r] = next[r - 1] + wanted[r - 1];
    for (int64_t site = 0; site < grid->n_sites; site++) {
        if (!(grid->flags[site] & flag)) continue;
        grid_position(grid, site, at);
        sites[next[owner[site]]++] = lattice_site(lattice, at[0], at[1], at[2]);
    }
    free(owner);
    free(next);
    return sites;
}

static int64_t *box_sites(const struct grid *grid, const struct lattice *lattice,
                          const int64_t *sites, int64_t count)
{
    int64_t *box = memory_new((size_t)count, sizeof *box);
    for (int64_t i = 0; i < count; i++) {
        int at[3];
        lattice_position(lattice, sites[i], at);
        box[i] = grid_site(grid, at);
    }
    return box;
}

struct halo *halo_new(const struct grid *grid, const struct lattice *lattice,
                      const struct partition *partition, int flag, int size)
{
    struct halo *halo = memory_new(1, sizeof *halo);
    if (size == 1) return halo;
    int *wanted = memory_new((size_t)size, sizeof *wanted),
        *given = memory_new((size_t)size, sizeof *given);
    int *wanted_at = memory_new((size_t)size, sizeof *wanted_at);
    int *given_at = memory_new((size_t)size, sizeof *given_at);
    int64_t *want = wanted_sites(grid, lattice, partition, flag, size, wanted);
    MPI_Alltoall(wanted, 1, MPI_INT, given, 1, MPI_INT, MPI_COMM_WORLD);
    for (int r = 1; r < size; r++) {
        wanted_at[r] = wanted_at[r - 1] + wanted[r - 1];
        given_at[r] = given_at[r - 1] + given[r - 1];
    }
    int64_t *give = memory_new((size_t)(given_at[size - 1] + given[size - 1]), sizeof *give);
    MPI_Alltoallv(want, wanted, wanted_at, MPI_INT64_T, give, given, given_at, MPI_INT64_T,
                  MPI_COMM_WORLD);

    halo->peers = memory_new((size_t)size, sizeof *halo->peers);
    for (int r = 0; r < size; r++) {
        if (!wanted[r] && !given[r]) continue;
        struct peer *peer = &halo->peers[halo->n_peers++];
        peer->rank = r;
        peer->n_send = given[r];
        peer->n_receive = wanted[r];
        peer->send = box_sites(grid, lattice, give + given_at[r], given[r]);
        peer->receive = box_sites(grid, lattice, want + wanted_at[r], wanted[r]);
        peer->out = memory_new((size_t)given[r] * MOST_FIELDS, sizeof(double));
        peer->in = memory_new((size_t)wanted[r] * MOST_FIELDS, sizeof(double));
    }
    halo->requests = memory_new(2 * (size_t)halo->n_peers, sizeof(MPI_Request));
    free(wanted);
    free(given);
    free(wanted_at);
    free(given_at);
    free(want);
    free(give);
    return halo;
}

void halo_free(struct halo *halo)
{
    if (!halo) return;
    for (int p = 0; p < halo->n_peers; p++) {
        free(halo->peers[p].send);
        free(halo->peers[p].receive);
        free(halo->peers[p].out);
        free(halo->peers[p].in);
    }
    free(halo->peers);
    free(halo->requests);
    free(halo);
}

void halo_profile(struct halo *halo, struct profile *profile)
{
    halo->profile = profile;
}

void halo_exchange(struct halo *halo, double *const fields[], int count)
{
    if (halo->n_peers == 0) return;
    const enum profile_part before = profile_enter(halo->profile, PART_HALO);
    for (int p = 0; p < halo->n_peers; p++) {
        struct peer *peer = &halo->peers[p];
        MPI_Irecv(peer->in, (int)(peer->n_receive * count), MPI_DOUBLE, peer->rank, 0,
                  MPI_COMM_WORLD, &halo->requests[2 * p]);
        for (int k = 0; k < count; k++)
            for (int64_t i = 0; i < peer->n_send; i++)
                peer->out[k * peer->n_send + i] = fields[k][peer->send[i]];
        MPI_Isend(peer->out, (int)(peer->n_send * count), MPI_DOUBLE, peer->rank, 0, MPI_COMM_WORLD,
                  &halo->requests[2 * p + 1]);
    }
    MPI_Waitall(2 * halo->n_peers, halo->requests, MPI_STATUSES_IGNORE);
    for (int p = 0; p < halo->n_peers; p++) {
        const struct peer *peer = &halo->peers[p];
        for (int k = 0; k < count; k++)
            for (int64_t i = 0; i < peer->n_receive; i++)
                fields[k][peer->receive[i]] = peer->in[k * peer->n_receive + i];
    }
    profile_enter(halo->profile, before);
}
