/* neighbours.h - who lies within a distance of a scattered particle: bins as wide as the distance.
 */
#ifndef HS_NEIGHBOURS_H
#define HS_NEIGHBOURS_H

#include <stdint.h>

struct neighbours {
    double reach, width[3]; /* m; of a bin, at least the reach */
    double origin[3];
    double period[3]; /* m; 0: none */
    int64_t size[3];  /* bins */
    int64_t *start;   /* [bins + 1] */
    int64_t *nodes;   /* [n] bin by bin, ascending in each */
    int64_t *found;   /* what neighbours_find found last */
};

/* x[3][n] in m.  period: after which the places repeat themselves, 0 along axes along which they do
 * not, or NULL.  Linear in n. */
struct neighbours neighbours_new(double *const x[3], const double period[3], int64_t n,
                                 double reach);
void neighbours_free(struct neighbours *neighbours);

/* Puts the nodes j != i of which the nearest image is no farther than reach (1 + 1e-9) into found,
 * ascending, and returns how many there are. */
int64_t neighbours_find(const struct neighbours *neighbours, double *const x[3], int64_t i);

#endif
