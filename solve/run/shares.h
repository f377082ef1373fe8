/* shares.h - what each rank has of a row of things, and messages from all ranks to all. */
#ifndef HS_SHARES_H
#define HS_SHARES_H

#include "ranks.h"

/* Of n things rank r of so many has those from shares_first(n, r, size) to that of r + 1. */
static inline int64_t shares_first(int64_t n, int r, int size)
{
    return n * r / size;
}
static inline int64_t shares_count(int64_t n, int r, int size)
{
    return shares_first(n, r + 1, size) - shares_first(n, r, size);
}
/* Rank that has thing i. */
static inline int shares_owner(int64_t n, int64_t i, int size)
{
    int r = (int)(i * size / n);
    while (shares_first(n, r + 1, size) <= i) r++;
    return r;
}

/* Numbers that go to each rank, or come from it, one rank's behind the other's. */
struct shares {
    int *counts, *starts; /* [ranks] */
    int64_t all;
};

struct shares shares_new(struct ranks ranks); /* of nothing */
void shares_free(struct shares *shares);
void shares_start(struct shares *shares, struct ranks ranks); /* starts and all, of the counts */

/* What the others send where they are sent this.  Collective. */
struct shares shares_answer(const struct shares *sent, struct ranks ranks);

/* Collective, both. */
void shares_send(const float *out, const struct shares *sent, float *in,
                 const struct shares *received);
void shares_send_integers(const int64_t *out, const struct shares *sent, int64_t *in,
                          const struct shares *received);

#endif
