/* forest.h - sets of nodes that are joined pair by pair (union-find), and whether a set closes upon
 * itself around a periodic body. */
#ifndef HS_FOREST_H
#define HS_FOREST_H

#include <stdbool.h>
#include <stdint.h>

struct forest {
    int32_t *parent; /* [n] */
    /* Of a periodic body, else NULL: */
    int32_t (
        *around)[3]; /* [n] in which image of the body the node is met on the way from its parent */
    bool (*closed)[3]; /* [n] a way from the node to an image of itself, beyond the body along this
                          axis, was found */
};

struct forest forest_new(int64_t n, bool periodic);
void forest_free(struct forest *forest);

/* The node that stands for the set. */
int32_t forest_root(struct forest *forest, int32_t node);

/* Joins the sets of a node and of a neighbour that is met in the image `around` of the body.  Where
 * both are in one set already and the ways to its root end in different images, the set goes around
 * the body (J. Machta, Y. S. Choi, A. Lucke, T. Schweizer and L. M. Chayes, Phys. Rev. E 54 (1996)
 * 1332; M. E. J. Newman and R. M. Ziff, Phys. Rev. E 64 (2001) 016706). */
void forest_join(struct forest *forest, int32_t node, int32_t neighbour, const int32_t around[3]);

#endif
