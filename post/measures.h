/* measures.h - what is measured on a loading curve, and how far noise can be trusted to have
 * moved it. */
#ifndef HS_MEASURES_H
#define HS_MEASURES_H

#include "noise.h"
#include "true_curve.h"
#include "yield_point.h"

enum measure {
    MEASURE_MODULUS, /* Pa */
    MEASURE_TOE,
    MEASURE_PROOF_001, /* Pa, at the offsets of measures_offsets */
    MEASURE_PROOF_01,
    MEASURE_PROOF_02,
    MEASURE_PROOF_1,
    MEASURE_TOTAL_05, /* Pa, Rt0.5 */
    MEASURE_UPPER,    /* Pa */
    MEASURE_LOWER,    /* Pa */
    MEASURE_YIELD_EXTENSION,
    MEASURE_STRENGTH,          /* Pa */
    MEASURE_EXTENSION,         /* Agt */
    MEASURE_PLASTIC_EXTENSION, /* Ag */
    MEASURE_FRACTURE,          /* At */
    MEASURE_PLASTIC_FRACTURE,  /* A */
    MEASURE_EXPONENT,          /* n */
    MEASURE_COEFFICIENT,       /* Pa, K */
    MEASURES,
};

/* 0.01, 0.1, 0.2 and 1 % */
extern const double measures_offsets[4];

/* A curve without loops (record.h) and what is known of it. */
struct loading {
    const struct curve *curve;
    struct noise noise; /* of the stress, Pa */
    double strain_noise;
    long strained; /* the last row whose strain was measured */
    bool broken;   /* the specimen broke behind the last row */
};

struct measures {
    struct elastic_line line;
    double modulus; /* Pa, E of the plastic strain */
    struct yield_point yield;
    struct strength_maximum maximum;
    long uniform;  /* last row of uniform deformation: of the maximum, or the last strained one */
    long fracture; /* the last row, or the last strained one */
    struct power_law power_law;
    bool cut_at_maximum; /* the range of n ends at Ag */
    /* Engineering plastic strain where work hardening begins: 0, or behind a yield plateau. */
    double hardening;
    double value[MEASURES], error[MEASURES]; /* NAN: not defined; standard, 0 without noise */
};

/* line: as strength_line has it, for what is measured from it; the errors are left 0. */
struct measures measures_take(const struct loading *loading, const struct choices *choices,
                              struct elastic_line line);

/* The errors by a parametric bootstrap: noise of the deviations and the correlation found, drawn
 * from a fixed seed, is added to the curve without its noise, all is measured anew, and the root
 * mean square of the changes against that curve is the error; a bias such as that of a maximum
 * over noise is part of it. */
void measures_bootstrap(const struct loading *loading, const struct choices *choices,
                        struct measures *measures);

#endif
