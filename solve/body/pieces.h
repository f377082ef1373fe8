/* pieces.h - whether scattered particles are one body. */
#ifndef HS_PIECES_H
#define HS_PIECES_H

#include <stdint.h>

/* How many parts no two of which have particles within reach [m] of each other; x, period and n as
 * of neighbours_new. */
int64_t pieces_count(double *const x[3], const double period[3], int64_t n, double reach);

#endif
