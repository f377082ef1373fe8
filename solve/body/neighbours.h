/* neighbours.h - who lies within a distance of a scattered particle: bins as wide as the distance. */
#ifndef HS_NEIGHBOURS_H
#define HS_NEIGHBOURS_H

#include <stdint.h>

struct neighbours {
    double reach, width; /* m; of a bin, at least the reach */
    double origin[3];
    int64_t size[3]; /* bins */
    int64_t *start;  /* [bins + 1] */
    int64_t *nodes;  /* [n] bin by bin, ascending in each */
};

/* x[3][n] in m.  Linear in n. */
struct neighbours neighbours_new(double *const x[3], int64_t n, double reach);
void neighbours_free(struct neighbours *neighbours);

/* The nodes j != i with |x_j - x_i| <= reach (1 + 1e-9), ascending.  Returns how many there are; members grows
 * as it must, *room being its length; freed by the caller. */
int64_t neighbours_find(const struct neighbours *neighbours, double *const x[3], int64_t i,
                        int64_t **members, int64_t *room);

#endif
