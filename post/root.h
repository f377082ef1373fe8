/* root.h - where a function of one variable is zero. */
#ifndef HS_ROOT_H
#define HS_ROOT_H

/* The root of function(x, context) between low and high, where its signs differ, to the last
 * digits of a double (Brent's method of GSL); an end that is a root is returned.  NAN where the
 * signs do not differ. */
double root_between(double (*function)(double x, void *context), void *context, double low,
                    double high);

#endif
