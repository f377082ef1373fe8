/* tidy.h - all curves in one long table, a row a point, for pandas and R as it is: no comments,
 * one header. */
#ifndef HS_TIDY_H
#define HS_TIDY_H

#include "curve.h"
#include "labels.h"

#include <stdio.h>

/* curve,group,file,varied, in a study what varied, then all columns that one of the curves has, empty where a curve has them not. */
void tidy_write(FILE *file, const struct curve curves[], const struct label labels[], int count);

#endif
