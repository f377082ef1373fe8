/* ordinary.h - ordinary state-based materials: the force along a bond depends on all bonds of its
 * ends.
 *
 *   theta_i = D_i sum_j a_ij (e_ij - e^p_ij) V_j,  e = |y| - |xi|                   (ordinary.1)
 *   psi_i = k_i theta_i^2/2 + (b_i/2) sum_j w_ij (e_ij - e^p_ij)^2 V_j               (ordinary.2)
 *   t_ij = k_i D_i theta_i a_ij + b_i w_ij (e_ij - e^p_ij)                          (ordinary.3)
 *   f_i = sum_j (t_ij + t_ji) V_j y/|y|                                             (ordinary.4)
 *
 * w is the weight of the bond, a = w |xi| or w.  (ordinary.3) is the derivative of psi_i with
 * respect to e_ij over V_j, so that (ordinary.4) is minus the gradient of the energy whatever the
 * weights and whatever has been broken.  A law gives k, D and b; two passes over the bonds do the
 * rest, the first for the sums of the nodes, the second for the forces.  An end of a bond through
 * two phases sees r e instead of e, and its terms count g/r times in (ordinary.1) and (ordinary.2),
 * g times in (ordinary.4): (interface.2).  Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88
 * (2007) 151, section 15. */
#ifndef HS_ORDINARY_H
#define HS_ORDINARY_H

#include "bonds.h"
#include "material.h"
#include "model.h"
#include "surface_correction.h"

struct ordinary_plastic;

/* Of a node. */
struct ordinary_moduli {
    double dilatation; /* D */
    double volumetric; /* k [Pa] */
    double distortion; /* b */
};

struct ordinary_law {
    bool by_length; /* a = w |xi|; else a = w */
    /* weighted_volume: sum of w |xi|^2 V over the bonds of the node; isotropic: its sum of w |xi| V
     * over that of a node deep inside the body, where a surface correction is wanted, else 1. */
    struct ordinary_moduli (*moduli)(const struct material *material, enum plane plane,
                                     const struct body *body, double weighted_volume,
                                     double isotropic);
};
extern const struct ordinary_law ordinary_linear, ordinary_madenci_oterkus;

/* k of (ordinary.2) [Pa]. */
double ordinary_volumetric(const struct material *material, enum plane plane);

/* What the first pass sums up of each node, over its bonds, times V_j. */
enum {
    SUM_DILATATION, /* theta/D, of a (e - e^p) */
    SUM_SQUARE,     /* w (e - e^p)^2 */
    SUM_COUNT
};

/* What the second pass reads of each node: t_ij = pull a_ij + spring w_ij (e_ij - e^p_ij), and with
 * yield e^p_ij += flow (e_ij - e^p_ij - centre |xi|).  Until a node yields there are the first two
 * alone, and spring is b. */
enum { NODE_PULL, NODE_SPRING, NODE_FLOW, NODE_CENTRE, NODE_COUNT };

struct ordinary {
    const struct materials *materials;
    const struct ordinary_law *law;
    enum surface_correction correction;
    struct bonds *bonds;
    /* Box fields. */
    double *fields; /* what volumetric, distortion, pull and weighted volume are in */
    double *volumetric, *distortion; /* k D^2, b */
    double *node[NODE_COUNT];
    double *sum[SUM_COUNT];   /* fields of the body, see find_nodes */
    double *weighted_volume;  /* where a phase yields: of the bonds there are */
    int64_t weighted_changes; /* of the bonds' weights that it has seen */
    bool series;              /* bonds through two phases */
    double **ends; /* [strips] of those with such bonds r and g/r of both ends, else NULL; NULL:
                      there are none */
    struct ordinary_plastic *plastic; /* NULL: no phase yields */
};

/* ordinary_plastic.c: the state of the phases that yield. */
struct ordinary_plastic *ordinary_plastic_new(const struct ordinary *model);
void ordinary_plastic_free(struct ordinary_plastic *plastic);

/* Whether a node anywhere is beyond yield, from the sums of the owned nodes.  Collective. */
bool ordinary_plastic_beyond(const struct ordinary *model, const struct body *body);

/* Makes of the sums of the owned nodes the numbers that the second pass reads; energy may be NULL.
 */
void ordinary_plastic_nodes(struct ordinary *model, const struct body *body, struct force_mode mode,
                            struct force_energy *energy);

/* e^p of the bonds of a strip, of the lower ends [0] and the upper ends [1]; NULL: none yet. */
struct slip {
    double *end[2];
};
struct slip ordinary_plastic_slip(const struct ordinary *model, int64_t strip);
/* Makes the e^p of the strip, 0, where there are none. */
void ordinary_plastic_make_slip(struct ordinary *model, int64_t strip);
/* Whether an end of a bond of the strip is about to flow. */
bool ordinary_plastic_flows(const struct ordinary *model, int64_t strip);

void ordinary_plastic_visit(struct ordinary *model, const struct body *body,
                            struct checkpoint *checkpoint);

/* Equivalent plastic strain, a box field, where a phase yields. */
const double *ordinary_plastic_strain(const struct ordinary *model);

#endif
