/* loops.h - what loops of unloading and reloading tell: back stress and effective stress,
 * hysteresis, damage.
 *
 * After Yang, Pan, Yuan, Zhu and Wu, Mater. Res. Lett. 4 (2016) 145: with sigma_u the stress of
 * reverse yield in unloading and sigma_r that of yield in reloading, the back stress (of
 * heterogeneous deformation, HDI) is (sigma_r + sigma_u)/2 and the effective (friction) stress
 * (sigma_r - sigma_u)/2.  Stresses and strains are true ones. */
#ifndef HS_LOOPS_H
#define HS_LOOPS_H

#include "analysis.h"

#include <stdio.h>

struct loop {
    double strain, plastic,
        flow;      /* true strain, its plastic part and stress [Pa] where unloading begins */
    double lowest; /* Pa, stress at the bottom */
    double unloading, reloading; /* Pa, slopes of the beginnings of both branches */
    double reverse, yield;       /* Pa, sigma_u and sigma_r; NAN where the branch does not yield */
    double back, effective;      /* Pa */
    double width, area;          /* largest difference of strain between the branches; J/m^3 */
    double damage;               /* 1 - unloading/m_E */
    struct {                     /* standard, of the noise; NAN: none that is known */
        double unloading, reloading, reverse, yield, back, effective;
    } error;
    const char *flag; /* NULL; few_points, no_reverse_yield, no_yield */
};

/* The loop of an excursion of kind loop.  Slopes are least squares over 10 to 40 % of the change
 * of stress of a branch; a branch yields where its strain is off that line by offset.  next: the
 * row up to which the reloading goes on. */
struct loop loop_measure(const struct curve *curve, const struct excursion *excursion, long next,
                         double offset, double modulus);

/* All loops of a curve, of a measured one with the errors of its noise, by a bootstrap as that
 * of measures.h; the caller frees them.  *count is their number. */
struct loop *loops_find(const struct curve *curve, const struct analysis *analysis, double offset,
                        long *count);

/* A header, and a row a loop; label: what the first column says, NULL: there is none. */
void loops_write_header(FILE *file, bool labelled);
void loops_write(FILE *file, const struct loop loops[], long count, const char *label);

/* One line a loop, by note(). */
void loops_print(const struct loop loops[], long count);

#endif
