/* slabs.h - boxes of numbers that all ranks share: in slabs of planes, in which two axes lie whole
 * on a rank, or turned, in columns across the planes.
 *
 * Along a row of a plane is x; across the planes is the longer one of y and z.  In both forms each
 * rank has about as much as any other. */
#ifndef HS_SLABS_H
#define HS_SLABS_H

#include "box.h"
#include "shares.h"

/* Numbers behind the values and the columns that may be read and written as they are: who takes
 * some together need not stop at the last. */
enum { SLABS_SPARE = 16 };

/* The box of one component. */
struct slab {
    int size[3];     /* places along a row, across rows, across planes */
    int64_t plane;   /* numbers in one: size[0] size[1] */
    int planes;      /* on this rank */
    float *values;   /* [planes][size[1]][size[0]] */
    int64_t first;   /* number of a plane of this rank's first column */
    int64_t columns; /* on this rank */
    float **turned;  /* [size[2]] where the columns' numbers of each plane lie */
};

struct slabs {
    struct ranks ranks;
    int axis[3]; /* of the body, along a row, across rows, across planes */
    struct slab slab[3];
    float *values; /* those of all three */
    int64_t n_values;
    float *out, *columns;      /* for messages; on one rank NULL: columns lie in the planes */
    struct shares cut, joined; /* numbers of planes to columns, in them */
};

struct slabs slabs_new(const struct box box[3], struct ranks ranks);
void slabs_free(struct slabs *slabs);

/* Rank that has a place of box a, and the number of the place among that rank's values. */
int slabs_find(const struct slabs *slabs, int a, const int place[3], int64_t *number);

/* From planes to columns and back; the other form is then used up.  Collective. */
void slabs_turn(struct slabs *slabs);
void slabs_turn_back(struct slabs *slabs);

#endif
