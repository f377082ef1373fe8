/* across.c - plane stress by the secant method on the logarithm of the stretch across.
 *
 *   tau(l) = F_zz P_zz = 0,  l = ln F_zz;  l -= tau/s,  s = d tau/d l                    (across.1)
 *
 * In logarithmic strain tau is linear in l while the point is elastic, s = kappa + 4 mu/3, and one
 * step finds it; flow leaves s between kappa and that, where a secant keeps it.  A Kirchhoff stress
 * so small counts as none: rounding of strains times moduli. */
#include "across.h"

#include <math.h>

enum { MOST = 200 };
static const double none = 1e-12; /* of kappa + 4 mu/3 */

static double elastic_slope(const struct points *points, int i)
{
    return points->bulk[i] + 4. / 3 * points->mu[i];
}

void across_begin(struct across *across, const double *stretch, struct points *points)
{
    across->asked = 0;
    for (int i = 0; i < points->count; i++) {
        across->found[i] = false;
        across->stretch[i] = stretch[i];
        across->slope[i] = elastic_slope(points, i);
        points->H[8][i] = stretch[i] - 1;
    }
}

/* exp(x) of small x as the quotient of Pade: what it is off by goes into the next step. */
static double grown(double x)
{
    return (1 + x / 2 + x * x / 12) / (1 - x / 2 + x * x / 12);
}

bool across_improve(struct across *across, struct points *points)
{
    bool left = false;
    for (int i = 0; i < points->count; i++) {
        const double tau = points->P[8][i] * across->stretch[i], stiff = elastic_slope(points, i);
        /* Points that carry nothing, and what is no number, are found, too. */
        if (across->found[i] || !(fabs(tau) > none * stiff)) {
            across->found[i] = true;
            continue;
        }
        if (across->asked > 0) {
            const double slope = (tau - across->last[i]) / across->moved[i];
            across->slope[i] = slope > 0.5 * points->bulk[i] && slope < stiff ? slope : stiff;
        }
        across->last[i] = tau;
        across->moved[i] = fmin(fmax(-tau / across->slope[i], -0.5), 0.5);
        across->stretch[i] *= grown(across->moved[i]);
        points->H[8][i] = across->stretch[i] - 1;
        left = true;
    }
    return left && ++across->asked < MOST;
}
