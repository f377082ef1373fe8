/* phases.h - how stress and strain are shared between two phases. */
#ifndef HS_PHASES_H
#define HS_PHASES_H

#include "curve.h"

/* State of the phases at one row. */
struct partition {
    int hard, soft;                  /* indices into curve->phases; -1, -1: not two phases */
    double hard_stress, soft_stress; /* Pa, mean Cauchy */
    double hard_strain, soft_strain; /* mean nominal */
    double factor;                   /* Pa, q = (s_hard - s_soft) / (e_soft - e_hard) */
    double mixture;                  /* sum of fraction * nominal stress over engineering stress */
};

/* The harder of the two is the one with the greater stress at that row.  q is infinite for equal
 * strain (Voigt), zero for equal stress (Reuss); NAN where the strains are equal. */
struct partition phases_at(const struct curve *curve, long row);

/* Adds the column partition_q_Pa, row by row, where there are two phases. */
void phases_add_factor(struct curve *curve);

#endif
