/* properties.h - a list of named values with unit, uncertainty and definition. */
#ifndef HS_PROPERTIES_H
#define HS_PROPERTIES_H

#include "labels.h"

#include <stdio.h>

struct property {
    char *name, *symbol;
    double value; /* in the unit; NAN: not valid, written as an empty field */
    const char *unit;
    double uncertainty; /* standard error in the unit; NAN where there is none */
    char *definition;
    const char *flag; /* NULL, or a word that limits the value: not_reached, few_points */
};

struct properties {
    int count;
    struct property *items;
};

/* Appends a row.  definition is a printf format. */
struct property *properties_add(struct properties *list, const char *name, const char *symbol,
                                double value, const char *unit, double uncertainty,
                                const char *definition, ...) __attribute__((format(printf, 7, 8)));

/* Lists of one curve or several; with several, leading columns (members in JSON) say of which:
 * curve, file, varied, and, in a study, a column (in JSON the member values) of each thing that
 * varied. */
void properties_write_csv(FILE *file, const struct properties lists[], const struct label labels[],
                          int count);
void properties_write_json(FILE *file, const struct properties lists[], const struct label labels[],
                           int count);

/* The value of a property by its name; NAN where the list does not have it. */
double properties_value(const struct properties *list, const char *name);

/* Names of what people look at first, from 0; NULL behind the last. */
const char *properties_main(int i);

/* These rows, rounded, by note(). */
void properties_print(const struct properties *list, const char *title);

void properties_free(struct properties *list);

#endif
