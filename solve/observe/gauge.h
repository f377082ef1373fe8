/* gauge.h - the virtual extensometer: what is measured between the gauge planes. */
#ifndef HS_GAUGE_H
#define HS_GAUGE_H

#include "domain.h"
#include "model.h"

struct gauge;

/* From the node sets gauge_left and gauge_right, of a body that is periodic along x the whole of
 * it; NULL where there is neither, dies where one set is missing.  Collective. */
struct gauge *gauge_new(const struct body *body, const struct domain *domain, int n_phases);
void gauge_free(struct gauge *gauge);

double gauge_length(const struct gauge *gauge); /* m, between the planes */

/* Mean displacement along the axis of the test of the left and of the right plane [m].  Collective.
 */
struct gauge_planes {
    double left, right;
};
struct gauge_planes gauge_displacements(const struct gauge *gauge, const struct body *body);

/* Volume fraction of a phase between the planes. */
double gauge_fraction(const struct gauge *gauge, int phase);

/* What is averaged over the nodes of each phase between the planes: one row, one column a phase. */
struct gauge_mean {
    const char *name, *unit;
    size_t member; /* of struct node_state, [LANES] */
    double most;   /* no node has more */
    const char *help;
};
extern const struct gauge_mean gauge_means[];
extern const int gauge_mean_count;

/* Smallest section along the axis of the test: over its initial size, and where [m]. */
struct gauge_section {
    double ratio, x;
};

/* means: gauge_means of the first phase, then of the next.  model_prepare goes before it.
 * Collective. */
void gauge_measure(const struct gauge *gauge, struct model *model, const struct body *body,
                   double *means, struct gauge_section *section);

#endif
