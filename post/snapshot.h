/* snapshot.h - particle fields at one time: what a picture or a table of them is made of. */
#ifndef HS_SNAPSHOT_H
#define HS_SNAPSHOT_H

#include "exodus.h"
#include "view_request.h"

#include <stdint.h>

/* One quantity: a variable of the file, or the magnitude of one of its vectors. */
struct field {
    char *name;
    const char *unit; /* SI: "Pa", "N/m3"; "1" where there is none */
    double *values;   /* [n_nodes] */
    bool phase;       /* they are numbers of the domain's phases */
};

struct snapshot {
    struct domain domain;
    int64_t frame, n_frames; /* frame from 1 */
    double time;             /* s */
    int n_fields;
    struct field *fields;
    double *displacement[3]; /* [n_nodes] m; NULL where not wanted or of a sheet's missing axis */
    double *side;            /* [n_nodes] m, edge of the square or cube a particle stands for */
    double edge[3];          /* m, distances of a lattice's particles; 0: they are scattered */
    struct spool input;
    struct frames frames; /* open */
};

/* Reads the frame and the variables asked for (all of them where none are); dies (exit 2) where the
 * file has no such frame or variable, or no displacement where the factor needs one. */
struct snapshot snapshot_read(const struct view_request *request);
/* The same of another frame, from 1. */
void snapshot_go(struct snapshot *snapshot, const struct view_request *request, int64_t frame);
void snapshot_free(struct snapshot *snapshot);

/* Particles of a layer across an axis, ascending.  position NAN: middle of the body; else that
 * layer of a lattice which is nearest, or all that it cuts of scattered particles.  *found
 * becomes the layer's position.  Dies (exit 2) where the body does not reach so far. */
int64_t *snapshot_slice(const struct snapshot *snapshot, int normal, double position, double *found,
                        int64_t *count);

/* Reference positions along an axis, [n_nodes] m. */
const double *snapshot_axis(const struct snapshot *snapshot, int axis);

#endif
