#include "halo.h"

#include "memory.h"
#include "profile.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FIELDS = 9 };

/* What goes to and comes from one rank, which may be this one: box indices in the order of the
 * sites that are wanted. */
struct peer {
    int rank;
    int64_t n_send, n_receive;
    int64_t *send, *receive;
    double *out, *in;
};

struct halo {
    struct profile *profile; /* NULL: none */
    int rank;
    int n_peers;
    struct peer *peers;
    MPI_Request *requests; /* [2 * n_peers] */
};

/* What a rank wants, grouped by the ranks that own it: wanted[r] sites from rank r, from number
 * start[r] on. */
struct wants {
    int *count, *start;
    int64_t *site; /* global */
    int64_t *box;  /* where it goes */
};

static int owner_of(const struct lattice *lattice, const struct partition *partition,
                    const int at[3])
{
    int original[3];
    lattice_original(lattice, at, original);
    return partition_owner(partition, original[0], original[1], original[2]);
}

static struct wants wants_new(const struct grid *grid, const struct lattice *lattice,
                              const struct partition *partition, int flag, int size)
{
    struct wants wants = {memory_new((size_t)size, sizeof(int)),
                          memory_new((size_t)size, sizeof(int)), NULL, NULL};
    int64_t total = 0;
    int at[3];
    for (int64_t site = 0; site < grid->n_sites; site++) {
        if (!(grid->flags[site] & flag)) continue;
        grid_position(grid, site, at);
        wants.count[owner_of(lattice, partition, at)]++;
        total++;
    }
    wants.site = memory_new((size_t)total, sizeof *wants.site);
    wants.box = memory_new((size_t)total, sizeof *wants.box);
    int64_t *next = memory_new((size_t)size, sizeof *next);
    for (int r = 1; r < size; r++)
        next[r] = wants.start[r] = wants.start[r - 1] + wants.count[r - 1];
    for (int64_t site = 0; site < grid->n_sites; site++) {
        if (!(grid->flags[site] & flag)) continue;
        grid_position(grid, site, at);
        const int64_t number = next[owner_of(lattice, partition, at)]++;
        wants.site[number] = lattice_site_of(lattice, at);
        wants.box[number] = site;
    }
    free(next);
    return wants;
}

static void wants_free(struct wants *wants)
{
    free(wants->count);
    free(wants->start);
    free(wants->site);
    free(wants->box);
}

/* What others want of this rank; one rank is alone without MPI. */
static struct wants ask(const struct wants *wants, int size)
{
    struct wants given = {memory_new((size_t)size, sizeof(int)),
                          memory_new((size_t)size, sizeof(int)), NULL, NULL};
    if (size == 1)
        given.count[0] = wants->count[0];
    else
        MPI_Alltoall(wants->count, 1, MPI_INT, given.count, 1, MPI_INT, MPI_COMM_WORLD);
    for (int r = 1; r < size; r++) given.start[r] = given.start[r - 1] + given.count[r - 1];
    const size_t total = (size_t)(given.start[size - 1] + given.count[size - 1]);
    given.site = memory_new(total, sizeof *given.site);
    if (size == 1)
        memcpy(given.site, wants->site, total * sizeof *given.site);
    else
        MPI_Alltoallv(wants->site, wants->count, wants->start, MPI_INT64_T, given.site, given.count,
                      given.start, MPI_INT64_T, MPI_COMM_WORLD);
    return given;
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
    halo->rank = grid->rank;
    if (size == 1 && !lattice_is_periodic(lattice)) return halo;
    struct wants wants = wants_new(grid, lattice, partition, flag, size), given = ask(&wants, size);
    halo->peers = memory_new((size_t)size, sizeof *halo->peers);
    for (int r = 0; r < size; r++) {
        if (!wants.count[r] && !given.count[r]) continue;
        struct peer *peer = &halo->peers[halo->n_peers++];
        peer->rank = r;
        peer->n_send = given.count[r];
        peer->n_receive = wants.count[r];
        peer->send = box_sites(grid, lattice, given.site + given.start[r], given.count[r]);
        peer->receive = memory_new((size_t)wants.count[r], sizeof *peer->receive);
        memcpy(peer->receive, wants.box + wants.start[r],
               (size_t)wants.count[r] * sizeof *peer->receive);
        if (r == halo->rank) continue;
        peer->out = memory_new((size_t)given.count[r] * MOST_FIELDS, sizeof(double));
        peer->in = memory_new((size_t)wants.count[r] * MOST_FIELDS, sizeof(double));
    }
    halo->requests = memory_new(2 * (size_t)halo->n_peers, sizeof(MPI_Request));
    wants_free(&wants);
    wants_free(&given);
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

/* Images of sites that this rank owns itself. */
static void copy_own(const struct peer *peer, double *const fields[], int count)
{
    for (int k = 0; k < count; k++)
        for (int64_t i = 0; i < peer->n_receive; i++)
            fields[k][peer->receive[i]] = fields[k][peer->send[i]];
}

static void begin_exchange(const struct halo *halo, const struct peer *peer, double *const fields[],
                           int count, MPI_Request requests[2])
{
    requests[0] = requests[1] = MPI_REQUEST_NULL;
    if (peer->rank == halo->rank) return;
    MPI_Irecv(peer->in, (int)(peer->n_receive * count), MPI_DOUBLE, peer->rank, 0, MPI_COMM_WORLD,
              &requests[0]);
    for (int k = 0; k < count; k++)
        for (int64_t i = 0; i < peer->n_send; i++)
            peer->out[k * peer->n_send + i] = fields[k][peer->send[i]];
    MPI_Isend(peer->out, (int)(peer->n_send * count), MPI_DOUBLE, peer->rank, 0, MPI_COMM_WORLD,
              &requests[1]);
}

void halo_exchange(struct halo *halo, double *const fields[], int count)
{
    if (halo->n_peers == 0) return;
    const enum profile_part before = profile_enter(halo->profile, PART_HALO);
    const bool alone = halo->n_peers == 1 && halo->peers[0].rank == halo->rank;
    for (int p = 0; p < halo->n_peers && !alone; p++)
        begin_exchange(halo, &halo->peers[p], fields, count, halo->requests + 2 * p);
    if (!alone) MPI_Waitall(2 * halo->n_peers, halo->requests, MPI_STATUSES_IGNORE);
    for (int p = 0; p < halo->n_peers; p++) {
        const struct peer *peer = &halo->peers[p];
        if (peer->rank == halo->rank) {
            copy_own(peer, fields, count);
            continue;
        }
        for (int k = 0; k < count; k++)
            for (int64_t i = 0; i < peer->n_receive; i++)
                fields[k][peer->receive[i]] = peer->in[k * peer->n_receive + i];
    }
    profile_enter(halo->profile, before);
}
