/* bounds.h - Voigt's and Reuss's engineering curves of two constituents' curves. */
#ifndef HS_BOUNDS_H
#define HS_BOUNDS_H

#include "analysis.h"

enum bound { BOUND_VOIGT, BOUND_REUSS };

/* The bound for a fraction of the second curve, from the law fitted to each up to its maximum
 * force, over engineering strain range[0] (NAN: 0) to range[1] (NAN: 0.3).  The law speaks
 * beyond its data: the provenance says so.  Dies (exit 2) where a law could not be fitted. */
struct curve bounds_curve(enum bound bound, const struct curve pair[2],
                          const struct analysis analyses[2], const struct hardening_law *law,
                          double fraction, const double range[2]);

#endif
