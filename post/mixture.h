/* mixture.h - the curves between which a mixture of two constituents lies.
 *
 * Both constituents are taken as J2 solids in uniaxial tension, eps = eps_p + sigma/E, with a
 * fitted hardening law that also speaks beyond the range of its data.  Iso-strain is Voigt's
 * (1889) assumption, iso-stress Reuss's (1929), both for true stress and true strain. */
#ifndef HS_MIXTURE_H
#define HS_MIXTURE_H

#include "hardening.h"

struct constituent {
    struct hardening law;
    double modulus; /* Pa */
};

/* True stress [Pa] of one constituent at true strain >= 0, and its true strain at stress >= 0;
 * INFINITY where the law never reaches the stress. */
double constituent_stress(const struct constituent *constituent, double strain);
double constituent_strain(const struct constituent *constituent, double stress);

/* True stress [Pa] of the mixture at true strain >= 0; fraction is that of the second. */
double mixture_voigt(const struct constituent pair[2], double fraction, double strain);
double mixture_reuss(const struct constituent pair[2], double fraction, double strain);

#endif
