/* j2.h - finite-strain J2 plasticity in logarithmic strain, a strip of points at a time.
 *
 *   b = F Cp^-1 F^T,  e = (ln b)/2,  tau = 2 mu dev e + K tr(e) 1,  P = tau F^-T          (j2.1)
 *   q = sqrt(3/2 dev tau : dev tau) <= sigma_y(p)                                         (j2.2)
 *   return: q_trial - 3 mu g = sigma_y(p + g),  dev tau *= 1 - 3 mu g/q_trial,  p += g    (j2.3)
 *   Cp^-1 = F^-1 exp(2 e_elastic) F^-T                                                    (j2.4)
 *
 * Simo, Comput. Methods Appl. Mech. Engrg. 99 (1992) 61, section 3; de Souza Neto, Peric, Owen,
 * Computational Methods for Plasticity (2008), box 14.3.  The flow is volume-preserving, the return
 * exact in the direction of the trial stress, and the stress derives from an incremental potential.
 * ln and exp are the series of artanh and tanh,
 *   (ln b)/2 = artanh X, X = (b - 1)(b + 1)^-1,
 * with an error below 1e-10 for elastic strains below 10 %.
 * No term reaches from one point to another: a point's result depends on its own data alone. */
#ifndef HS_J2_H
#define HS_J2_H

#include "simd.h"

#include <stdbool.h>
#include <stdint.h>

/* Components of a tensor: row by row; of a symmetric one: xx yy zz xy yz zx.  The state of a point: Cp^-1, p, and its
 * flow stress by the curve [Pa], which is looked up only where p has grown. */
enum { TENSOR = 9, SYMMETRIC = 6, J2_PLASTIC = 6, J2_YIELD, J2_STATE };

/* A strip of points. */
struct j2_strip {
    int count;                  /* at most LANES */
    double H[TENSOR][LANES];    /* in: displacement gradient F - 1 */
    double mu[LANES];           /* in: shear modulus [Pa] */
    double bulk[LANES];         /* in: bulk modulus [Pa] */
    int64_t curve[LANES];       /* in: index of the flow curve */
    double shift[LANES];        /* in: what the flow stress has over the curve [Pa] */
    bool flows;                 /* out: some point is beyond yield */
    double P[TENSOR][LANES];    /* out: first Piola-Kirchhoff stress [Pa] */
    double stored[LANES];       /* out, where asked for: elastic energy density [J/m^3] */
    double plastic[LANES];      /* out, where asked for: plastic work density [J/m^3] */
    double e[SYMMETRIC][LANES]; /* work: deviator of the elastic strain */
    double trace[LANES], q[LANES], yield[LANES], grown[LANES], open[LANES], scale[LANES];
};

struct j2_mode {
    bool commit; /* write the new state; otherwise it is only read */
    bool frozen; /* elastic answer whatever the stress (for the stable step) */
    bool energy; /* fill stored and plastic */
};

/* Virgin states, from strip->curve; arrays as below. */
void j2_start(const struct j2_strip *strip, double *state, int64_t stride, const double *table);

/* state[k * stride + lane], k < J2_STATE; table: struct flow_curves.table. */
void j2_update(struct j2_strip *strip, double *state, int64_t stride, const double *table,
               struct j2_mode mode);

/* Point i carries nothing and keeps its state: to be called before the update. */
static inline void j2_switch_off(struct j2_strip *strip, int i)
{
    for (int k = 0; k < TENSOR; k++) strip->H[k][i] = 0;
    strip->mu[i] = strip->bulk[i] = 0;
}

/* Cauchy stress [Pa], symmetric components, of the strip after j2_update. */
void j2_cauchy(const struct j2_strip *strip, double cauchy[SYMMETRIC][LANES]);

#endif
