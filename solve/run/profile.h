/* profile.h - where the time of a run goes, and what it could leave out.
 *
 * A rank is in one part at a time: who enters another one puts the old one back when it leaves.
 * Without --profile there is no profile (NULL), and nothing of this does anything. */
#ifndef HS_PROFILE_H
#define HS_PROFILE_H

#include "ranks.h"

enum profile_part {
    PART_READ,
    PART_PARTITION,
    PART_BONDS,
    PART_PLAN,
    PART_STABLE_STEP,
    PART_FORCE,
    PART_FORCE_ENERGIES,
    PART_HALO,
    PART_DAMAGE,
    PART_PRECONDITION,
    PART_ADVANCE,
    PART_BALANCE,
    PART_RECORD,
    PART_FRAME,
    PART_CHECKPOINT,
    PART_REST,
    PARTS
};

/* What may be left out. */
enum profile_work {
    WORK_ENERGIES,
    WORK_FLOW_STRIPS,
    WORK_BOND_TESTS,
    WORK_NODE_TESTS,
    WORK_RECORDS,
    WORK_FRAMES,
    WORKS
};

struct profile;

struct profile *profile_new(void); /* in PART_REST */
void profile_free(struct profile *profile);

/* The part it was in. */
enum profile_part profile_enter(struct profile *profile, enum profile_part part);

/* Of so many pieces of work, those were done. */
void profile_count(struct profile *profile, enum profile_work work, double done, double possible);

/* The table on rank 0's standard error: seconds, as the mean and the most of all ranks; nodes: of
 * the body. evaluations: of the force.  Collective. */
void profile_print(struct profile *profile, struct ranks ranks, double nodes, double evaluations);

#endif
