/* gauge.h - the virtual extensometer: what is measured between the gauge planes. */
#ifndef HS_GAUGE_H
#define HS_GAUGE_H

#include "domain.h"
#include "model.h"

struct gauge;

/* From the node sets gauge_left and gauge_right; NULL where there is neither, dies where one is missing.
 * Collective. */
struct gauge *gauge_new(const struct body *body, const struct domain *domain, int n_phases);
void gauge_free(struct gauge *gauge);

double gauge_length(const struct gauge *gauge); /* m, between the planes */

/* Mean displacement along x of the left and of the right plane [m].  Collective. */
struct gauge_planes {
    double left, right;
};
struct gauge_planes gauge_displacements(const struct gauge *gauge, const struct body *body);

/* Volume fraction of a phase between the planes. */
double gauge_fraction(const struct gauge *gauge, int phase);

/* Mean values of one phase between the planes. */
struct gauge_phase {
    double stress;         /* nominal (first Piola-Kirchhoff) xx, Pa */
    double true_stress;    /* Cauchy xx, Pa */
    double strain;         /* F_xx - 1 */
    double plastic_strain; /* equivalent */
};

/* Smallest section along x: over its initial size, and where [m]. */
struct gauge_section {
    double ratio, x;
};

/* phases[n_phases].  model_prepare goes before it.  Collective. */
void gauge_measure(const struct gauge *gauge, struct model *model, const struct body *body,
                   struct gauge_phase *phases, struct gauge_section *section);

#endif
