/* analysis.h - everything hspost finds on one curve, and the list of properties made of it. */
#ifndef HS_ANALYSIS_H
#define HS_ANALYSIS_H

#include "phases.h"
#include "properties.h"
#include "true_curve.h"

struct analysis {
    struct elastic_line line;
    double modulus; /* Pa, E of the plastic strain */
    struct strength_maximum maximum;
    long fracture;
    bool broken;
    struct considere considere;
    struct power_law power_law;
    bool cut_at_maximum; /* the range of n ends at Ag */
    double fit_range[2]; /* true plastic strain, of the laws */
};

/* Puts the machine's compliance right where asked for, fills the true curve and the columns that follow
 * from it, and notes in the provenance by which rules. */
struct analysis analysis_make(struct curve *curve, const struct choices *choices);

/* The properties of docs/tensile.md, in its order. */
struct properties analysis_report(const struct curve *curve, const struct analysis *analysis,
                                  const struct choices *choices);

#endif
