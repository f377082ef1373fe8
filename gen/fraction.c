#include "fraction.h"

#include "memory.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

static double weight_of(const struct ranks *ranks, int64_t node)
{
    return ranks->weight ? ranks->weight[node] : 1;
}

/* Weight of the counted nodes with a score of at most `limit`. */
static double weight_up_to(const struct ranks *ranks, int64_t limit)
{
    double weight = 0;
    for (int64_t node = 0; node < ranks->n_nodes; node++)
        if (ranks->counted[node] && ranks->score[node] <= limit) weight += weight_of(ranks, node);
    return weight;
}

/* Smallest score up to which nodes of at least the weight `wanted` are found: at most 64 passes. */
static int64_t score_of_rank(const struct ranks *ranks, double wanted)
{
    int64_t low = INT64_MAX, high = INT64_MIN;
    for (int64_t node = 0; node < ranks->n_nodes; node++) {
        if (!ranks->counted[node]) continue;
        low = ranks->score[node] < low ? ranks->score[node] : low;
        high = ranks->score[node] > high ? ranks->score[node] : high;
    }
    while (low < high) {
        int64_t middle = low + (high - low) / 2;
        if (weight_up_to(ranks, middle) >= wanted)
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

struct tie {
    uint64_t hash;
    double weight;
};

static int compare_ties(const void *a, const void *b)
{
    const struct tie *first = a, *second = b;
    return (first->hash > second->hash) - (first->hash < second->hash);
}

/* Takes nodes on the threshold, in the order of their hashes, as long as that brings the weight
 * nearer to what is wanted: the last one's hash becomes the threshold's. */
static void split_ties(const struct ranks *ranks, double under, double wanted,
                       struct threshold *threshold)
{
    struct tie *ties = memory_new((size_t)ranks->n_nodes, sizeof *ties);
    int64_t on = 0, taken = 0;
    for (int64_t node = 0; node < ranks->n_nodes; node++)
        if (ranks->counted[node] && ranks->score[node] == threshold->score)
            ties[on++] =
                (struct tie){tie_of(threshold->seed, ranks->site[node]), weight_of(ranks, node)};
    qsort(ties, (size_t)on, sizeof *ties, compare_ties);
    while (taken < on && under + 0.5 * ties[taken].weight <= wanted) under += ties[taken++].weight;
    if (taken == 0)
        threshold->score--;
    else if (taken < on) {
        threshold->tie = ties[taken - 1].hash;
        threshold->split = on;
    }
    free(ties);
}

/* What became coarse. */
static void sum_up(const struct ranks *ranks, struct threshold *threshold)
{
    double coarse = 0, total = 0;
    for (int64_t node = 0; node < ranks->n_nodes; node++) {
        if (!ranks->counted[node]) continue;
        const int64_t site = ranks->site ? ranks->site[node] : node;
        const bool is_coarse = fraction_is_coarse(threshold, ranks->score[node], site);
        threshold->counted++;
        threshold->coarse += is_coarse;
        total += weight_of(ranks, node);
        coarse += is_coarse ? weight_of(ranks, node) : 0;
    }
    threshold->share = coarse / total;
}

struct threshold fraction_exact(const struct ranks *ranks, double coarse_fraction, long seed)
{
    struct threshold threshold = {.tie = UINT64_MAX, .seed = seed, .score = INT64_MIN};
    double wanted = coarse_fraction * weight_up_to(ranks, INT64_MAX);
    if (!ranks->weight) wanted = (double)llround(wanted);
    if (wanted > 0) {
        threshold.score = score_of_rank(ranks, wanted);
        if (weight_up_to(ranks, threshold.score) > wanted)
            split_ties(ranks, weight_up_to(ranks, threshold.score - 1), wanted, &threshold);
    }
    sum_up(ranks, &threshold);
    threshold.below = threshold.above = threshold.share;
    return threshold;
}

struct threshold fraction_geometric(const struct ranks *ranks, double coarse_fraction)
{
    struct threshold threshold = {.tie = UINT64_MAX};
    const double total = weight_up_to(ranks, INT64_MAX);
    double wanted = coarse_fraction * total;
    if (!ranks->weight) wanted = fmax(1, ceil(wanted));
    threshold.score = score_of_rank(ranks, wanted);
    threshold.above = weight_up_to(ranks, threshold.score) / total;
    threshold.below = weight_up_to(ranks, threshold.score - 1) / total;
    threshold.score -= coarse_fraction - threshold.below < threshold.above - coarse_fraction;
    sum_up(ranks, &threshold);
    return threshold;
}

bool fraction_is_coarse(const struct threshold *threshold, int64_t score, int64_t site)
{
    if (score != threshold->score) return score < threshold->score;
    return threshold->tie == UINT64_MAX || tie_of(threshold->seed, site) <= threshold->tie;
}
