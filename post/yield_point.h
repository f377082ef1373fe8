/* yield_point.h - discontinuous yielding: upper and lower yield strength, and the yield point
 * extension. */
#ifndef HS_YIELD_POINT_H
#define HS_YIELD_POINT_H

/* A loading curve without loops, and its stress without most of the noise. */
struct yield_record {
    long n;
    const double *strain, *stress, *smooth; /* [n] -, Pa, Pa */
    double noise, left; /* Pa, standard deviations of the noise of stress and of smooth */
    double width;       /* strain over which smooth is a mean */
    double slope, toe;  /* Pa, -; of the elastic part, NAN where it is not known */
};

struct yield_point {
    double upper, lower; /* Pa; NAN where there is none */
    double extension;    /* Ae, from the upper yield point to the start of uniform work hardening */
    long row, end; /* of the upper yield point, and of the last minimum before work hardening; -1 */
};

/* ISO 6892-1, A.4.2: the highest stress before a fall of at least the share drop of it (and of
 * ten standard deviations of the noise), not exceeded over 0.05 % of strain, behind no more than
 * 0.5 % of plastic strain, and followed by a rise.  Lower: the lowest stress of the plateau
 * behind its first valley (the initial transient), of the only valley where there is one.  Ae
 * (annex A.4): to the intersection of the horizontal through the last minimum with the steepest
 * line of work hardening. */
struct yield_point yield_point_find(const struct yield_record *record, double drop);

#endif
