/* noise.h - how much of a measured curve is noise, and the curve without most of it. */
#ifndef HS_NOISE_H
#define HS_NOISE_H

/* Standard deviation of the noise of y [n] over its rows: from second and fourth differences of rows and from what lies
 * off the line between the neighbours in x, by the median, so that few corners do not count; the least of the three, as
 * each also sees the bends of the curve.  0 for fewer than 50 rows. */
double noise_of(const double x[], const double y[], long n);

/* The same of the strain, which is noise only where it goes back and forth: 0 where fewer than one step in a hundred
 * falls. */
double noise_of_strain(const double strain[], long n);

/* Mean of y over the rows whose x lies within width/2 of each row's, at most 25 on either side and as many on one as on
 * the other, so that a straight line stays.  noise 0: y as it is.  *left: standard deviation of the noise that is left in
 * all but a twentieth of the rows. */
void noise_smooth(const double x[], const double y[], long n, double width, double noise,
                  double smooth[], double *left);

#endif
