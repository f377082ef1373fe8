/* small_ranks.h - ranks of a test's own, started before the group and stopped behind it. */
#ifndef HS_SMALL_RANKS_H
#define HS_SMALL_RANKS_H

#include "ranks.h"

static inline int small_ranks_start(void **state)
{
    (void)state;
    ranks_start(NULL, NULL);
    return 0;
}

static inline int small_ranks_stop(void **state)
{
    (void)state;
    ranks_stop();
    return 0;
}

#endif
