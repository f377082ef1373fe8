/* box.h - the box of places around the free components along one axis, which the preconditioner's
 * waves fill.
 *
 * A place is a site of the lattice.  A scattered particle is put where the nearest site of a
 * lattice of its mean distance would be, a node of a mesh between the eight sites around it. */
#ifndef HS_BOX_H
#define HS_BOX_H

#include "unknowns.h"

struct box {
    int low[3], size[3];
    bool held[3][2]; /* whether there is something of the body below, above */
    bool periodic[3];
    bool floats; /* nothing is held of the component */
    int64_t count;
};

/* Around the free components along axis a.  Collective. */
struct box box_new(const struct unknowns *unknowns, int a);

enum { BOX_PLACES = 8 };

/* Places of the node at a site of the body in the box's own numbers, and the shares it has in them;
 * how many: none where it lies outside. */
int box_places(const struct box *box, const struct body *body, int64_t site,
               int places[BOX_PLACES][3], float shares[BOX_PLACES]);

#endif
