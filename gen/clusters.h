/* clusters.h - connected pieces of a phase, and how near different cores come to each other. */
#ifndef HS_CLUSTERS_H
#define HS_CLUSTERS_H

#include "structure.h"

#include <stdbool.h>

/* Two nodes are neighbours when they share a face (6) or at least a corner (26). */
enum neighbourhood { NEIGHBOURS_6 = 3, NEIGHBOURS_26 = 13 };

struct clusters {
    int64_t nodes;   /* of the phase in the counted region */
    int64_t count;   /* of clusters */
    int64_t largest; /* nodes of the largest */
    /* One cluster reaches both ends of the counted region along x, y, z; of a periodic body, its
     * own image there. */
    bool percolates[3];
};

/* Along x, y and z. */
bool clusters_percolate_everywhere(const struct clusters *clusters);

/* Clusters of a phase in the counted region (union-find over half the neighbours). */
struct clusters clusters_find(const struct structure *structure, int phase,
                              enum neighbourhood neighbourhood);

struct contact {
    int64_t touching; /* pairs of coarse nodes of different cores that are 26-neighbours */
    double film; /* edges along x: least distance of coarse nodes of different cores, less a cell
                    (steps_film) */
};

/* On cubes film >= 1 says the same as touching = 0.  A film beyond `limit` edges of a cube of the
 * cell's volume is not looked for and comes out as infinity. */
struct contact clusters_contact(const struct structure *structure, int limit);

/* The offsets of half of a neighbourhood: [half][3], the 3 of faces first, then edges, corners. */
extern const int clusters_offset[NEIGHBOURS_26][3];

#endif
