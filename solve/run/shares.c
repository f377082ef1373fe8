#include "shares.h"

#include "memory.h"

#include <mpi.h>
#include <stdlib.h>

struct shares shares_new(struct ranks ranks)
{
    return (struct shares){memory_new((size_t)ranks.size, sizeof(int)),
                           memory_new((size_t)ranks.size, sizeof(int)), 0};
}

void shares_free(struct shares *shares)
{
    free(shares->counts);
    free(shares->starts);
    *shares = (struct shares){0};
}

void shares_start(struct shares *shares, struct ranks ranks)
{
    shares->all = 0;
    for (int r = 0; r < ranks.size; r++) {
        shares->starts[r] = (int)shares->all;
        shares->all += shares->counts[r];
    }
}

struct shares shares_answer(const struct shares *sent, struct ranks ranks)
{
    struct shares received = shares_new(ranks);
    MPI_Alltoall(sent->counts, 1, MPI_INT, received.counts, 1, MPI_INT, MPI_COMM_WORLD);
    shares_start(&received, ranks);
    return received;
}

void shares_send(const float *out, const struct shares *sent, float *in,
                 const struct shares *received)
{
    MPI_Alltoallv(out, sent->counts, sent->starts, MPI_FLOAT, in, received->counts,
                  received->starts, MPI_FLOAT, MPI_COMM_WORLD);
}

void shares_send_integers(const int64_t *out, const struct shares *sent, int64_t *in,
                          const struct shares *received)
{
    MPI_Alltoallv(out, sent->counts, sent->starts, MPI_INT64_T, in, received->counts,
                  received->starts, MPI_INT64_T, MPI_COMM_WORLD);
}
