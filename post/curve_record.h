/* curve_record.h - what happened during a test, judged before anything is measured: loops,
 * holds, serrations, an extensometer that stands or falls, rows from the last to the first. */
#ifndef HS_CURVE_RECORD_H
#define HS_CURVE_RECORD_H

#include "strength.h"

enum excursion_kind {
    EXCURSION_LOOP,      /* strain goes back: unloading and reloading */
    EXCURSION_HOLD,      /* strain stands: relaxation */
    EXCURSION_SERRATION, /* strain goes on */
};

/* The stress falls from a row, and rises again with the elastic slope. */
struct excursion {
    enum excursion_kind kind;
    long begin, bottom, end; /* rows: before the fall, lowest stress, back on the curve */
};

struct record {
    bool *loading; /* [n] rows of the envelope that loading alone would have made */
    long count;
    struct excursion *excursions; /* [count] */
    long spikes;                  /* of a few rows, that no body makes; left out */
    bool unloaded;                /* the end of the record is an unloading, which is left out */
    bool broken;                  /* the specimen breaks; what is behind the fracture is left out */
    long strained;                /* the last row whose strain was measured; n - 1 where all are */
    double noise, strain_noise;   /* Pa, -; standard deviations on the envelope */
};

/* Turns rows that run from the last to the first, with a note; dies (exit 2) at a measured
 * record of compression, with signs that do not go together, or in no order. */
void record_turn(struct curve *curve);
/* line: of the elastic part, slope NAN where it is not known; the specimen is broken where the
 * stress falls below fracture_share of its highest. */
struct record record_judge(const struct curve *curve, const struct elastic_line *line,
                           double fracture_share);
void record_free(struct record *record);

/* How many there are of a kind. */
long record_count(const struct record *record, enum excursion_kind kind);

/* The rows of the envelope as a curve of their own; *rows [curve.n] are their numbers. */
struct curve record_envelope(const struct record *record, const struct curve *curve, long **rows);

#endif
