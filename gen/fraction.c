#include "fraction.h"

#include "memory.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

/* Counted nodes with a score of at most `limit`. */
static int64_t count_up_to(int64_t n_nodes, const int64_t *score, const uint8_t *counted,
                           int64_t limit)
{
    int64_t count = 0;
    for (int64_t node = 0; node < n_nodes; node++) count += counted[node] && score[node] <= limit;
    return count;
}

/* Smallest score up to which at least `wanted` nodes are found: at most 64 passes. */
static int64_t score_of_rank(int64_t n_nodes, const int64_t *score, const uint8_t *counted,
                             int64_t wanted)
{
    int64_t low = INT64_MAX, high = INT64_MIN;
    for (int64_t node = 0; node < n_nodes; node++) {
        if (!counted[node]) continue;
        low = score[node] < low ? score[node] : low;
        high = score[node] > high ? score[node] : high;
    }
    while (low < high) {
        int64_t middle = low + (high - low) / 2;
        if (count_up_to(n_nodes, score, counted, middle) >= wanted)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static uint64_t tie_of(long seed, int64_t site)
{
    return random_hash(seed, "ties", (uint64_t)site);
}

static int compare_ties(const void *a, const void *b)
{
    uint64_t first = *(const uint64_t *)a, second = *(const uint64_t *)b;
    return (first > second) - (first < second);
}

/* The hash of the last of the `wanted` nodes that are taken among those on the threshold. */
static uint64_t last_tie(int64_t n_nodes, const int64_t *score, const int64_t *site,
                         const uint8_t *counted, const struct threshold *threshold, int64_t on,
                         int64_t wanted)
{
    uint64_t *ties = memory_new((size_t)on, sizeof *ties);
    int64_t count = 0;
    for (int64_t node = 0; node < n_nodes; node++)
        if (counted[node] && score[node] == threshold->score)
            ties[count++] = tie_of(threshold->seed, site[node]);
    qsort(ties, (size_t)on, sizeof *ties, compare_ties);
    uint64_t last = ties[wanted - 1];
    free(ties);
    return last;
}

struct threshold fraction_exact(int64_t n_nodes, const int64_t *score, const int64_t *site,
                                const uint8_t *counted, double coarse_fraction, long seed)
{
    struct threshold threshold = {.tie = UINT64_MAX, .seed = seed};
    threshold.counted = count_up_to(n_nodes, score, counted, INT64_MAX);
    threshold.coarse = (int64_t)llround(coarse_fraction * (double)threshold.counted);
    threshold.below = threshold.above = (double)threshold.coarse / (double)threshold.counted;
    if (threshold.coarse == 0) {
        threshold.score = INT64_MIN;
        return threshold;
    }
    threshold.score = score_of_rank(n_nodes, score, counted, threshold.coarse);
    int64_t up_to = count_up_to(n_nodes, score, counted, threshold.score);
    int64_t under = count_up_to(n_nodes, score, counted, threshold.score - 1);
    if (up_to > threshold.coarse) {
        threshold.split = up_to - under;
        threshold.tie = last_tie(n_nodes, score, site, counted, &threshold, up_to - under,
                                 threshold.coarse - under);
    }
    return threshold;
}

struct threshold fraction_geometric(int64_t n_nodes, const int64_t *score, const uint8_t *counted,
                                    double coarse_fraction)
{
    struct threshold threshold = {.tie = UINT64_MAX};
    threshold.counted = count_up_to(n_nodes, score, counted, INT64_MAX);
    double total = (double)threshold.counted;
    int64_t wanted = (int64_t)ceil(coarse_fraction * total);
    threshold.score = score_of_rank(n_nodes, score, counted, wanted < 1 ? 1 : wanted);
    int64_t above = count_up_to(n_nodes, score, counted, threshold.score);
    int64_t below = count_up_to(n_nodes, score, counted, threshold.score - 1);
    threshold.above = (double)above / total;
    threshold.below = (double)below / total;
    bool lower = coarse_fraction - threshold.below < threshold.above - coarse_fraction;
    threshold.coarse = lower ? below : above;
    threshold.score -= lower;
    return threshold;
}

bool fraction_is_coarse(const struct threshold *threshold, int64_t score, int64_t site)
{
    if (score != threshold->score) return score < threshold->score;
    return threshold->tie == UINT64_MAX || tie_of(threshold->seed, site) <= threshold->tie;
}
