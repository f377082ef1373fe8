/* cracks.h - cracks that are there from the start, from the deck's section "cracks".
 *
 * A bond whose segment of line crosses a crack is cut: it has weight 0 before any model looks at
 * it.  A node exactly on the plane of a crack (within 1e-9 spacings) belongs to the side that the
 * normal points to (of a rectangle: first edge times second), so that each bond is cut or whole,
 * never half; a segment that meets the rim within 1e-9 spacings is cut.  In a body of one layer a
 * rectangle reaches through the layer: it is the line of the edge that lies in the plane; a disc is
 * a line of twice its radius. */
#ifndef HS_CRACKS_H
#define HS_CRACKS_H

#include "bonds.h"
#include "keys.h"

#include <stdbool.h>

struct crack {
    bool disc;
    double corner[3]; /* of a rectangle; the centre of a disc, m */
    double edge[2][3];
    double normal[3]; /* of length 1 */
    double radius, slack;
};

struct cracks {
    int count;
    struct crack *items;
};

extern const struct section section_cracks;

/* section.index may be 0: none.  spacing [m] for lengths in spacings. */
struct cracks cracks_read(struct deck_node section, double spacing, int dimensions);
void cracks_free(struct cracks *cracks);

/* Whether the crack crosses the segment between two points. */
bool crack_cuts(const struct crack *crack, const double from[3], const double to[3]);

/* Cuts the body's bonds; returns how many in the whole body.  Collective. */
int64_t cracks_cut(const struct cracks *cracks, struct body *body, struct bonds *bonds);

#endif
