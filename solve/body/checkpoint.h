/* checkpoint.h - the state of a run between two steps: one walk over it that writes it, or reads it
 * back.
 *
 * Who owns state has one function that goes through all of it under names; whether the numbers go
 * into the file or come from it is not its business.  What belongs to points goes by keys that are
 * the same on any number of ranks: the site in the lattice; of a bond its offset and lower end,
 * between scattered particles both ends.  Its owner writes it, and whoever has a copy reads it, so
 * that ghosts need no message. */
#ifndef HS_CHECKPOINT_H
#define HS_CHECKPOINT_H

#include "bonds.h"
#include "checkpoint_file.h"

struct checkpoint;

/* A walk over this body with the file as it was opened. */
struct checkpoint *checkpoint_new(struct checkpoint_file *file, const struct body *body);
void checkpoint_free(struct checkpoint *checkpoint);

/* Whether the numbers come from the file: what is made of them has to be made again. */
bool checkpoint_reads(const struct checkpoint *checkpoint);

/* Numbers that are alike on all ranks; of those that rank 0 alone has the others read what they do
 * not need. */
void checkpoint_numbers(struct checkpoint *checkpoint, const char *name, double *values,
                        int64_t count);
void checkpoint_integer(struct checkpoint *checkpoint, const char *name, int64_t *value);
void checkpoint_flag(struct checkpoint *checkpoint, const char *name, bool *flag);

/* Box fields, at the nodes. */
void checkpoint_fields(struct checkpoint *checkpoint, const char *name, double *const fields[],
                       int count);

/* Where the numbers of a point of a strip are kept.  False: it has none; where make is true they
 * are wanted all the same. */
typedef bool checkpoint_place(void *owner, int64_t strip, int point, bool make, double *places[]);

/* Points in strips of nodes, or of bonds along one offset, by the site of the node or of the lower
 * end. */
void checkpoint_points(struct checkpoint *checkpoint, const char *name, const struct strips *strips,
                       int width, checkpoint_place *place, void *owner);
/* Of those whose numbers lie component by component in each strip (grid.h): component k of point i
 * at state[components * store + k * stride + i]; state NULL: nothing. */
void checkpoint_strips(struct checkpoint *checkpoint, const char *name, const struct strips *strips,
                       int components, double *state);

/* Bonds; strip: in body->bonds.  The second as above. */
void checkpoint_bonds(struct checkpoint *checkpoint, const char *name, int width,
                      checkpoint_place *place, void *owner);
void checkpoint_bond_strips(struct checkpoint *checkpoint, const char *name, int components,
                            double *state);

#endif
