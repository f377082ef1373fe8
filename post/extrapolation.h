/* extrapolation.h - what a study at several spacings goes to, and how far it still is from
 * there. */
#ifndef HS_EXTRAPOLATION_H
#define HS_EXTRAPOLATION_H

#include "pairing.h"
#include "varied_columns.h"

/* Richardson's extrapolation of values at rising spacings, the finest first, and the error of the
 * finest as Roache estimates it (J. Fluids Eng. 116 (1994) 405): a factor times its distance from
 * the extrapolated value.
 *
 * Three spacings or more: of the finest three the order p follows from
 *     (f3 - f2)/(f2 - f1) = (h3^p - h2^p)/(h2^p - h1^p),
 * the factor is 1.25.  Where these do not go one way, or p is not within 0.5 to 3, and with two
 * spacings, the order is the one given, and the factor 3. */
struct limit {
    double value, band; /* NAN with one spacing */
    double order;
    bool observed; /* the order comes of the values */
};
struct limit limit_of(const double spacing[], const double values[], int count, double order);

/* A body at several spacings. */
struct extrapolation {
    char *title;      /* of its groups, without the spacing */
    int count;        /* of spacings */
    int *groups;      /* [count] indices, the finest first */
    double *spacing;  /* [count] SI */
    int curves;       /* at each spacing that are paired: of a scatter that all spacings have */
    int left_out;     /* of all spacings: not paired */
    struct limit all; /* its order is the whole curve's: of the areas between the curves */
    /* The finest mean, extrapolated (mean), and its band (deviation), on strains that all have;
     * least: the finest mean itself. */
    struct group curve;
};

/* Of groups as groups_make makes them of these curves; *count is their number.  Means are over the
 * curves alone whose scatter all spacings have. */
struct extrapolation *extrapolations_make(const struct group groups[], int n_groups,
                                          const struct analysis analyses[],
                                          const struct label labels[], int n_labels, double order,
                                          int *count);
void extrapolations_free(struct extrapolation extrapolations[], int count);

/* CSV: group, what varied, curves, left_out, spacings, engineering_strain, finest_stress_MPa,
 * extrapolated_stress_MPa, error_MPa, order, order_from. */
void extrapolations_write(FILE *file, const struct extrapolation extrapolations[], int count,
                          const struct group groups[], const struct label labels[], int n_labels);

/* A property of a body. */
struct extrapolated {
    int spacings; /* that have a value; 0: the finest has none, and nothing is extrapolated */
    int curves, left_out; /* as of the body, of the curves that have a value */
    double finest;        /* mean at the finest spacing */
    struct limit limit;
};
struct extrapolated extrapolation_of(const struct extrapolation *extrapolation,
                                     const struct group groups[], const struct properties lists[],
                                     const struct label labels[], int n_labels, const char *name,
                                     double order);

/* CSV: group, what varied, property, symbol, unit, curves, left_out, spacings, finest,
 * extrapolated, error, order, order_from. */
void extrapolations_write_properties(FILE *file, const struct extrapolation extrapolations[],
                                     int count, const struct group groups[],
                                     const struct properties lists[], const struct label labels[],
                                     int n_labels, double order);

#endif
