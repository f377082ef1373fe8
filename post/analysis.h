/* analysis.h - everything hspost finds on one curve, and the list of properties made of it. */
#ifndef HS_ANALYSIS_H
#define HS_ANALYSIS_H

#include "curve_record.h"
#include "measures.h"
#include "phases.h"
#include "properties.h"

struct analysis {
    struct record record; /* what happened during the test */
    struct curve
        envelope;       /* its rows without loops, holds and serrations, on which all is measured */
    long *rows;         /* [envelope.n] their numbers in the curve */
    struct noise noise; /* of the stress of the envelope [Pa], of a measured curve, else 0 */
    double strain_noise; /* standard deviation, likewise */
    long strained;       /* the last row of the envelope whose strain was measured */
    struct measures measures;
    struct considere considere;
    double window;       /* true strain over which slopes were taken */
    double fit_range[2]; /* true plastic strain, of the laws */
};

/* Judges the record, puts the machine's compliance right where asked for, fills the true curve
 * and the columns that follow from it, and notes in the provenance by which rules.  Rows that
 * run backwards are turned.  Without errors those of a measured curve stay 0, which take longer
 * than all else of a long record.  Dies (exit 2) at a measured record of compression. */
struct analysis analysis_make(struct curve *curve, const struct choices *choices, bool errors);
void analysis_free(struct analysis *analysis);

/* Dies (exit 2) where a measured curve cannot be what it says (E outside 1 GPa to 1.2 TPa,
 * strain over 3, stress over 20 GPa), with the likely cause; only warns of a history. */
void analysis_check_plausible(const struct curve *curve, const struct analysis *analysis);

/* The properties of docs/tensile.md, in its order; without those of fitted laws, which take as
 * long as all else of a long record, where nobody asks for them. */
struct properties analysis_report(const struct curve *curve, const struct analysis *analysis,
                                  const struct choices *choices, bool fits);

#endif
