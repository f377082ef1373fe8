/* points.h - the points of a body that obey constitutive laws: nodes, or bonds between two nodes.
 *
 * Who owns points says where they are (strips), and deforms them; here is what they remember, and
 * the call of their laws.  The states of a law are kept strip by strip, component by component, for
 * the points that obey it alone.  Where a strip has points of several laws, each law's are
 * gathered, moved on and scattered; the strips of one law, almost all, are handed over as they are.
 * Degradation is wrapped around whatever the law answers (degradation.h). */
#ifndef HS_POINTS_H
#define HS_POINTS_H

#include "law.h"
#include "model.h"

struct checkpoint;
struct point_store;

/* Points in these strips, each between a site and the one offset behind it; offset 0: the points
 * are nodes.  Their states begin.  body and materials live on, the strips need not. */
struct point_store *points_new(const struct body *body, const struct materials *materials,
                               const struct strips *strips, int64_t offset);
void points_free(struct point_store *store);

/* Moduli, pair and shift of the points of a strip. */
void points_load(const struct point_store *store, const struct strip *strip, struct points *points);

/* The law's answer to points->H; integrity: those of the points, NULL: all are sound.  In plane
 * stress H_zz becomes that at which the law's P_zz is zero. */
void points_update(struct point_store *store, const struct strip *strip, struct points *points,
                   struct force_mode mode, const double *integrity);

/* What is seen of a strip of nodes that are deformed by points->H, the laws unmoved; nominal: box
 * field of their axial stress. */
void points_observe(struct point_store *store, const struct body *body, const struct strip *strip,
                    struct points *points, const double *nominal, struct node_state *node);

/* A component of the state of a number (laws.h), and the current flow stress [Pa], of the points of
 * a strip: where it is kept, or in buffer, [LANES].  Of points whose law has no such state what it
 * begins with; infinite where nothing flows. */
const double *points_state(const struct point_store *store, const struct strip *strip, int number,
                           int component, double *buffer);
const double *points_flow_stress(const struct point_store *store, const struct strip *strip,
                                 double *buffer);

/* All that they remember, under names that begin with what they are; strips: those of points_new.
 */
void points_visit(struct point_store *store, struct checkpoint *checkpoint, const char *what,
                  const struct strips *strips);

#endif
