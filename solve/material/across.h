/* across.h - the stretch of a point across a sheet in plane stress: that at which its law's stress
 * across is zero.
 *
 * Whatever the law, each point is asked again and again, nothing being committed, until it is
 * found.  A point's search depends on nothing but the point: it has the same bits in any strip. */
#ifndef HS_ACROSS_H
#define HS_ACROSS_H

#include "law.h"

struct across {
    int asked;
    bool found[LANES];
    double stretch[LANES]; /* F_zz */
    double slope[LANES], last[LANES],
        moved[LANES]; /* of F_zz P_zz by ln F_zz; before, and what has moved it since */
};

/* From the stretches of the last commit; fills points->H. */
void across_begin(struct across *across, const double *stretch, struct points *points);

/* After an answer of the law to points->H: false where the stress across has vanished at all
 * points, else points->H has the next ones to try. */
bool across_improve(struct across *across, struct points *points);

#endif
