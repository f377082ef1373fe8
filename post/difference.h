/* difference.h - how far one engineering curve lies from another. */
#ifndef HS_DIFFERENCE_H
#define HS_DIFFERENCE_H

#include "curve.h"

/* Relative differences of stress, (s - reference)/reference, at the points of the reference
 * whose strain lies in [low, high]; the curve is taken linear between its points. */
struct difference {
    double largest, mean, root_mean_square;
    double at; /* strain of the largest */
    double low, high;
    long count;
};

/* NAN as a bound of the range: 0.002, and the end of the shorter curve.  Dies (exit 2) where the
 * range holds no point of the reference. */
struct difference difference_of(const struct curve *curve, const struct curve *reference,
                                const double range[2]);

/* CSV rows quantity,value,unit. */
void difference_write(FILE *file, const struct difference *difference);

#endif
