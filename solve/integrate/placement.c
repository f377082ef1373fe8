#include "placement.h"

#include "memory.h"
#include "simd.h"

#include <stdlib.h>
#include <string.h>

/* Numbers that follow each other at both ends. */
struct run {
    int64_t from, to;
    int32_t count;
    float share;
};

/* A run, of nodes from this site of the lattice on. */
struct piece {
    struct run run;
    int rank; /* that has the place */
    int64_t site;
};

struct pieces {
    int64_t count;
    struct piece *items;
};

struct runs {
    int64_t count;
    struct run *items;
};

struct placement {
    struct ranks ranks;
    float *values;
    int64_t n_values, length; /* of the slabs on this rank, of the vector */
    bool sums;                /* nodes have several places, or share them */
    struct runs owned;        /* from the vector to what is given; on one rank, to the values */
    struct runs taken;        /* from what is taken to the values; none on one rank */
    struct runs gaps;         /* of the values: places that start from 0 */
    struct shares out, in;
    float *given, *got; /* [out.all], [in.all] */
};

static void append(struct pieces *pieces, struct piece piece, bool joins)
{
    struct piece *last = joins && pieces->count > 0 ? &pieces->items[pieces->count - 1] : NULL;
    if (last && last->rank == piece.rank && last->run.from + last->run.count == piece.run.from &&
        last->run.to + last->run.count == piece.run.to) {
        last->run.count++;
        return;
    }
    pieces->items = memory_grow(pieces->items, pieces->count, sizeof *pieces->items);
    pieces->items[pieces->count++] = piece;
}

/* Where the numbers of component a go. */
static void find_pieces(const struct unknowns *unknowns, const struct box *box,
                        const struct slabs *slabs, int a, bool joins, bool held,
                        struct pieces *pieces)
{
    const struct body *body = unknowns->body;
    int64_t at = a * unknowns->n_nodes;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++, at++) {
            if (!(unknowns->free[at] > 0) && !held) continue;
            const int64_t site = body->owned.items[s].site + i, number = body_number(body, site);
            int places[BOX_PLACES][3];
            float shares[BOX_PLACES];
            const int count = box_places(box, body, site, places, shares);
            for (int k = 0; k < count; k++) {
                int64_t to;
                const int rank = slabs_find(slabs, a, places[k], &to);
                append(pieces, (struct piece){{at, to, 1, shares[k]}, rank, number}, joins);
            }
        }
}

/* By site, then as they came. */
static int compare_pieces(const void *left, const void *right)
{
    const struct piece *a = left, *b = right;
    if (a->site != b->site) return a->site < b->site ? -1 : 1;
    return (a->run.from > b->run.from) - (a->run.from < b->run.from);
}

static struct runs runs_of(struct pieces *pieces)
{
    struct runs runs = {pieces->count, memory_new((size_t)pieces->count, sizeof *runs.items)};
    for (int64_t i = 0; i < runs.count; i++) runs.items[i] = pieces->items[i].run;
    free(pieces->items);
    return runs;
}

enum { TOLD = 3 }; /* numbers about a piece: its place, its length, its site */

/* What other ranks have told about their pieces, in the order of the numbers that they give. */
static struct pieces exchange_pieces(const struct pieces *owned, struct ranks ranks)
{
    struct shares sent = shares_new(ranks);
    for (int64_t i = 0; i < owned->count; i++) sent.counts[owned->items[i].rank] += TOLD;
    shares_start(&sent, ranks);
    struct shares received = shares_answer(&sent, ranks);
    int64_t *out = memory_new((size_t)sent.all, sizeof *out),
            *in = memory_new((size_t)received.all, sizeof *in),
            *next = memory_new((size_t)ranks.size, sizeof *next), from = 0;
    for (int64_t i = 0; i < owned->count; i++) {
        const struct piece *piece = &owned->items[i];
        int64_t *told = out + sent.starts[piece->rank] + TOLD * next[piece->rank]++;
        told[0] = piece->run.to;
        told[1] = piece->run.count;
        told[2] = piece->site;
    }
    shares_send_integers(out, &sent, in, &received);
    struct pieces pieces = {.count = received.all / TOLD};
    pieces.items = memory_new((size_t)pieces.count, sizeof *pieces.items);
    for (int64_t i = 0; i < pieces.count; i++) {
        const int64_t *told = in + TOLD * i;
        pieces.items[i] = (struct piece){{from, told[0], (int32_t)told[1], 1}, 0, told[2]};
        from += told[1];
    }
    shares_free(&sent);
    shares_free(&received);
    free(out);
    free(in);
    free(next);
    return pieces;
}

/* Other ranks have the places: the pieces' numbers go there in the order of the pieces. */
static void make_messages(struct placement *placement, struct pieces *owned)
{
    const struct ranks ranks = placement->ranks;
    placement->out = shares_new(ranks);
    for (int64_t i = 0; i < owned->count; i++)
        placement->out.counts[owned->items[i].rank] += owned->items[i].run.count;
    shares_start(&placement->out, ranks);
    placement->in = shares_answer(&placement->out, ranks);
    placement->given = memory_new((size_t)placement->out.all, sizeof(float));
    placement->got = memory_new((size_t)placement->in.all, sizeof(float));
    struct pieces taken = exchange_pieces(owned, ranks);
    if (placement->sums)
        qsort(taken.items, (size_t)taken.count, sizeof *taken.items, compare_pieces);
    placement->taken = runs_of(&taken);
    int64_t *next = memory_new((size_t)ranks.size, sizeof *next);
    for (int64_t i = 0; i < owned->count; i++) {
        struct piece *piece = &owned->items[i];
        piece->run.to = placement->out.starts[piece->rank] + next[piece->rank];
        next[piece->rank] += piece->run.count;
    }
    free(next);
}

/* Those that end in the values of this rank. */
static const struct runs *runs_to_values(const struct placement *placement)
{
    return placement->given ? &placement->taken : &placement->owned;
}

/* Places without a node, or all where nodes are summed. */
static struct runs find_gaps(const struct placement *placement)
{
    const struct runs *runs = runs_to_values(placement);
    bool *filled = memory_new((size_t)placement->n_values, sizeof *filled);
    struct pieces gaps = {0};
    for (int64_t r = 0; r < runs->count && !placement->sums; r++)
        memset(filled + runs->items[r].to, true, (size_t)runs->items[r].count);
    for (int64_t i = 0; i < placement->n_values; i++)
        if (!filled[i]) append(&gaps, (struct piece){{i, i, 1, 0}, 0, 0}, true);
    free(filled);
    return runs_of(&gaps);
}

struct placement *placement_new(const struct unknowns *unknowns, const struct box box[3],
                                const struct slabs *slabs, bool held)
{
    struct placement *placement = memory_new(1, sizeof *placement);
    struct pieces owned = {0};
    *placement = (struct placement){.ranks = slabs->ranks,
                                    .values = slabs->values,
                                    .n_values = slabs->n_values,
                                    .length = unknowns->length,
                                    .sums = lattice_is_row(unknowns->body->lattice)};
    for (int a = 0; a < 3; a++)
        find_pieces(unknowns, &box[a], slabs, a, !placement->sums, held, &owned);
    if (slabs->ranks.size > 1) make_messages(placement, &owned);
    placement->owned = runs_of(&owned);
    placement->gaps = find_gaps(placement);
    return placement;
}

void placement_free(struct placement *placement)
{
    free(placement->owned.items);
    free(placement->taken.items);
    free(placement->gaps.items);
    shares_free(&placement->out);
    shares_free(&placement->in);
    free(placement->given);
    free(placement->got);
    free(placement);
}

bool placement_is_crowded(const struct placement *placement)
{
    const struct runs *runs = runs_to_values(placement);
    bool *taken = memory_new((size_t)placement->n_values, sizeof *taken);
    double crowded = 0;
    for (int64_t i = 0; i < runs->count && placement->sums; i++) {
        bool *place = &taken[runs->items[i].to];
        if (*place) crowded = -1;
        *place = true;
    }
    free(taken);
    ranks_minimum(&crowded, 1);
    return crowded < 0;
}

HS_SIMD static void put(struct runs runs, const double *restrict from, float *restrict to)
{
    for (int64_t r = 0; r < runs.count; r++) {
        const struct run run = runs.items[r];
        for (int32_t i = 0; i < run.count; i++)
            to[run.to + i] = run.share * (float)from[run.from + i];
    }
}
HS_SIMD static void take(struct runs runs, const float *restrict to, float *restrict from)
{
    for (int64_t r = 0; r < runs.count; r++) {
        const struct run run = runs.items[r];
        for (int32_t i = 0; i < run.count; i++) from[run.from + i] = to[run.to + i];
    }
}
HS_SIMD static void sort_in(struct runs runs, const float *restrict from, float *restrict to)
{
    for (int64_t r = 0; r < runs.count; r++) {
        const struct run run = runs.items[r];
        for (int32_t i = 0; i < run.count; i++) to[run.to + i] = from[run.from + i];
    }
}
/* The same of single numbers that meet others. */
static void put_sums(struct runs runs, const double *from, float *to)
{
    for (int64_t r = 0; r < runs.count; r++)
        to[runs.items[r].to] += runs.items[r].share * (float)from[runs.items[r].from];
}
static void take_sums(struct runs runs, const float *to, float *from)
{
    for (int64_t r = 0; r < runs.count; r++)
        from[runs.items[r].from] += runs.items[r].share * to[runs.items[r].to];
}
static void sort_in_sums(struct runs runs, const float *from, float *to)
{
    for (int64_t r = 0; r < runs.count; r++) to[runs.items[r].to] += from[runs.items[r].from];
}

void placement_put(struct placement *p, const double *vector)
{
    for (int64_t g = 0; g < p->gaps.count; g++)
        memset(p->values + p->gaps.items[g].to, 0,
               (size_t)p->gaps.items[g].count * sizeof *p->values);
    if (p->given) {
        put(p->owned, vector, p->given);
        shares_send(p->given, &p->out, p->got, &p->in);
        (p->sums ? sort_in_sums : sort_in)(p->taken, p->got, p->values);
    } else
        (p->sums ? put_sums : put)(p->owned, vector, p->values);
}

void placement_take(struct placement *p, float *direction)
{
    const float *values = p->values;
    if (p->given) {
        take(p->taken, p->values, p->got);
        shares_send(p->got, &p->in, p->given, &p->out);
        values = p->given;
    }
    if (p->sums) memset(direction, 0, (size_t)p->length * sizeof *direction);
    (p->sums ? take_sums : take)(p->owned, values, direction);
}
