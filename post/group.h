/* group.h - specimens or seeds of one kind: means and deviations of curves and of properties. */
#ifndef HS_GROUP_H
#define HS_GROUP_H

#include "analysis.h"
#include "labels.h"

#include <stdio.h>

/* Curves of one title on common strains. */
struct group {
    const char *title;
    int first; /* number of the first of its curves */
    int count; /* of curves */
    long n;
    double *strain, *mean,
        *deviation; /* [n] -, Pa, Pa; deviation: standard, of the sample; 0 for one curve */
    double *least, *largest; /* [n] Pa */
};

/* Of these curves: 401 strains (toe removed) from where the last of them begins to where the first
 * ends, each curve's envelope linear between its rows; n 0 where that is behind.  title lives
 * longer. */
struct group group_of(const struct analysis analyses[], const char *title, const int numbers[],
                      int count);
void group_free(struct group *group);

/* One group a title, in the order of the curves; *n_groups is their number, the caller frees
 * them. */
struct group *groups_make(const struct analysis analyses[], const struct label labels[], int count,
                          int *n_groups);
void groups_free(struct group groups[], int n_groups);

/* CSV:
 * group,curves,engineering_strain,mean_stress_MPa,standard_deviation_MPa,least_MPa,largest_MPa;
 * behind the group, in a study, what varied but the scatter. */
void groups_write(FILE *file, const struct group groups[], int n_groups,
                  const struct label labels[], int count);

/* Numbers of the curves of a title, and how many. */
int group_members(const struct label labels[], int count, const char *title, int numbers[]);

/* Of a property over some curves: of those that have a value (count); NAN where none has, the
 * deviation also where one has. */
struct statistic {
    int count;
    double mean, deviation, least, largest; /* in the property's unit */
};
struct statistic statistic_of(const double values[], int n);
struct statistic group_statistic(const struct properties lists[], const int numbers[], int n,
                                 const char *name);

/* CSV of the properties over each group:
 * group,property,symbol,unit,count,mean,standard_deviation,least,largest; of the curves that
 * have a value, in the order of the first of them; what varied as there. */
void groups_write_properties(FILE *file, const struct properties lists[],
                             const struct label labels[], int count);

#endif
