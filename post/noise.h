/* noise.h - how much of a measured curve is noise, and the curve without most of it. */
#ifndef HS_NOISE_H
#define HS_NOISE_H

#include "random.h"

/* Of the stress of a curve [Pa], or of another quantity. */
struct noise {
    double deviation;   /* standard, of a row; 0: none that is known */
    double correlation; /* of the noise of a row with that of the next one, 0 to 1: a filter's */
};

/* Standard deviation of the mean of very many rows times the root of their number: that of a
 * row, and more where rows are correlated, as an autoregressive sequence is. */
double noise_of_means(struct noise noise);

/* Standard deviation of the noise of y [n] over its rows: from second and fourth differences of
 * rows and from what lies off the line between the neighbours in x, by the median, so that few
 * corners do not count; the least of the three, as each also sees the bends of the curve.  Where
 * a quarter of the rows or more repeat the one before, the values are steps, and it is that of
 * rounding to the step at least.  0 for fewer than 50 rows. */
double noise_of(const double x[], const double y[], long n);

/* The same of the strain, which is noise only where it goes back and forth: that of rounding
 * alone where fewer than one step in a hundred falls.  It is rounded
 * where all changes are whole numbers of a step, or where rows are repeated among count rows from
 * first on, of the elastic part, where rows lie closest, or among all. */
double noise_of_strain(const double strain[], long n, long first, long count);

/* Noise behind a filter, as an autoregressive sequence, by fourth differences of rows that are
 * farther and farther apart.  n >= 16. */
struct noise noise_filtered(const double y[], long n);

/* What a filter hides from differences of rows: deviation and correlation of y about a cubic in
 * x, over rows that ought to be straight.  deviation 0 where these are too few, or where y
 * crosses the cubic so seldom that it has a bend of another kind. */
struct noise noise_about_line(const double x[], const double y[], long n);

/* Standard deviation of y about a cubic in x; INFINITY for fewer rows than five. */
double noise_about_cubic(const double x[], const double y[], long n);

/* Mean of y over the rows whose x lies within width/2 of each row's, as many on one side as on
 * the other, so that a straight line stays, and no more than 25 that are independent.
 * noise.deviation 0: y as it is.  *left: standard deviation of the noise that is left in all but
 * a twentieth of the rows. */
void noise_smooth(const double x[], const double y[], long n, double width, struct noise noise,
                  double smooth[], double *left);

/* Noise row by row, of a stream of random numbers. */
struct noise_sequence {
    struct noise noise;
    double last;
};
struct noise_sequence noise_begin(struct noise noise, struct random_stream *stream);
double noise_next(struct noise_sequence *sequence, struct random_stream *stream);

/* Takes most of the noise out of values [n]: of each row the mean over the widest width of x
 * that differs from the next narrower one by no more than noise does, so that corners, and the
 * fall at the end, stay. */
void noise_trend(const double x[], double values[], long n, struct noise noise);

#endif
