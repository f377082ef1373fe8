#include "collection.h"

#include "memory.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct collection {
    int own;
    bool alone;           /* one rank */
    int *counts, *starts; /* [ranks] */
    int64_t *sites;       /* [n_nodes] */
};

struct collection *collection_new(const struct body *body)
{
    struct collection *collection = memory_new(1, sizeof *collection);
    const int size = body->ranks.size;
    int64_t *own = memory_new((size_t)body->grid.n_owned, sizeof *own), n = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++)
            own[n++] = body_number(body, body->owned.items[s].site + i);
    collection->own = (int)n;
    collection->counts = memory_new((size_t)size, sizeof(int));
    collection->starts = memory_new((size_t)size, sizeof(int));
    collection->sites = memory_new((size_t)body->n_nodes, sizeof(int64_t));
    collection->alone = size == 1;
    if (collection->alone) {
        collection->counts[0] = collection->own;
        for (int64_t i = 0; i < n; i++) collection->sites[i] = own[i];
    } else {
        MPI_Allgather(&collection->own, 1, MPI_INT, collection->counts, 1, MPI_INT, MPI_COMM_WORLD);
        for (int r = 1; r < size; r++)
            collection->starts[r] = collection->starts[r - 1] + collection->counts[r - 1];
        MPI_Allgatherv(own, collection->own, MPI_INT64_T, collection->sites, collection->counts,
                       collection->starts, MPI_INT64_T, MPI_COMM_WORLD);
    }
    free(own);
    return collection;
}

void collection_free(struct collection *collection)
{
    free(collection->counts);
    free(collection->starts);
    free(collection->sites);
    free(collection);
}

const int64_t *collection_sites(const struct collection *collection)
{
    return collection->sites;
}

void collection_gather(const struct collection *collection, int root, const double *own,
                       double *all)
{
    if (collection->alone)
        memcpy(all, own, (size_t)collection->own * sizeof *all);
    else
        MPI_Gatherv(own, collection->own, MPI_DOUBLE, all, collection->counts, collection->starts,
                    MPI_DOUBLE, root, MPI_COMM_WORLD);
}

void collection_scatter(const struct collection *collection, int root, const double *all,
                        double *own)
{
    if (collection->alone)
        memcpy(own, all, (size_t)collection->own * sizeof *own);
    else
        MPI_Scatterv(all, collection->counts, collection->starts, MPI_DOUBLE, own, collection->own,
                     MPI_DOUBLE, root, MPI_COMM_WORLD);
}
