#include "profile.h"

#include "memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char *const parts[PARTS] = {
    [PART_READ] = "reading domain and deck",
    [PART_PARTITION] = "partition, fields",
    [PART_BONDS] = "families, bonds, state",
    [PART_PLAN] = "plan of steps and outputs",
    [PART_STABLE_STEP] = "stable step",
    [PART_FORCE] = "force",
    [PART_FORCE_ENERGIES] = "force, with energies",
    [PART_HALO] = "exchange between ranks",
    [PART_DAMAGE] = "damage",
    [PART_PRECONDITION] = "preconditioner",
    [PART_ADVANCE] = "integrator, boundary",
    [PART_BALANCE] = "energy balance, reactions",
    [PART_RECORD] = "records of the history",
    [PART_FRAME] = "frames of the fields",
    [PART_CHECKPOINT] = "records to disk, checkpoints",
    [PART_REST] = "the rest",
};

/* What is counted, and what each piece is. */
static const char *const works[WORKS] = {
    [WORK_ENERGIES] = "energies of a force evaluation",
    [WORK_FLOW_STRIPS] = "plastic flow of a strip",
    [WORK_BOND_TESTS] = "damage test of a strip of bonds",
    [WORK_NODE_TESTS] = "damage test of a strip of nodes",
    [WORK_RECORDS] = "record of a step",
    [WORK_FRAMES] = "frame of a step",
};

struct profile {
    enum profile_part part;
    double since, computed; /* clocks when it was entered: of the wall, of the processor */
    double seconds[PARTS], processor[PARTS], done[WORKS], possible[WORKS];
};

struct profile *profile_new(void)
{
    struct profile *profile = memory_new(1, sizeof *profile);
    profile->part = PART_REST;
    profile->since = ranks_clock();
    profile->computed = ranks_processor();
    return profile;
}

void profile_free(struct profile *profile)
{
    free(profile);
}

enum profile_part profile_enter(struct profile *profile, enum profile_part part)
{
    if (!profile) return PART_REST;
    const enum profile_part before = profile->part;
    const double now = ranks_clock(), computed = ranks_processor();
    profile->seconds[before] += now - profile->since;
    profile->processor[before] += computed - profile->computed;
    profile->since = now;
    profile->computed = computed;
    profile->part = part;
    return before;
}

void profile_count(struct profile *profile, enum profile_work work, double done, double possible)
{
    if (!profile) return;
    profile->done[work] += done;
    profile->possible[work] += possible;
}

/* Shares are those of the processors' time, which others on the machine do not change. */
static void print_parts(const double mean[PARTS], const double most[PARTS],
                        const double processor[PARTS], double per_node)
{
    double total = 0, all = 0;
    for (int p = 0; p < PARTS; p++) {
        total += mean[p];
        all += processor[p];
    }
    fprintf(stderr, "%-28s %10s %10s %10s %7s %12s\n", "part", "seconds", "most", "processor",
            "share", "ns/node/force");
    for (int p = 0; p < PARTS; p++)
        if (most[p] > 0)
            fprintf(stderr, "%-28s %10.3f %10.3f %10.3f %6.1f%% %12.1f\n", parts[p], mean[p],
                    most[p], processor[p], 100 * processor[p] / all, processor[p] * per_node);
    fprintf(stderr, "%-28s %10.3f %10s %10.3f\n", "all", total, "", all);
}

static void print_works(const double done[WORKS], const double possible[WORKS])
{
    for (int w = 0; w < WORKS; w++)
        if (possible[w] > 0)
            fprintf(stderr, "%-32s done %.0f of %.0f, left out %.2f%%\n", works[w], done[w],
                    possible[w], 100 * (1 - done[w] / possible[w]));
}

void profile_print(struct profile *profile, struct ranks ranks, double nodes, double evaluations)
{
    if (!profile) return;
    profile_enter(profile, PART_REST);
    double mean[PARTS], most[PARTS], processor[PARTS];
    for (int p = 0; p < PARTS; p++) {
        mean[p] = profile->seconds[p] / ranks.size;
        most[p] = -profile->seconds[p];
        processor[p] = profile->processor[p] / ranks.size;
    }
    ranks_sum(mean, PARTS);
    ranks_sum(processor, PARTS);
    ranks_minimum(most, PARTS);
    for (int p = 0; p < PARTS; p++) most[p] = -most[p];
    ranks_sum(profile->done, WORKS);
    ranks_sum(profile->possible, WORKS);
    const double bytes = ranks_memory();
    if (ranks.rank != 0) return;
    fprintf(stderr,
            "%.0f nodes, %d ranks, %.0f evaluations of the force; %.0f bytes a node at most\n",
            nodes, ranks.size, evaluations, bytes / nodes);
    print_parts(mean, most, processor, 1e9 * ranks.size / nodes / fmax(evaluations, 1));
    print_works(profile->done, profile->possible);
}
