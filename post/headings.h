/* headings.h - what a column of a laboratory's table is, by its heading. */
#ifndef HS_HEADINGS_H
#define HS_HEADINGS_H

#include <stdbool.h>

enum quantity {
    QUANTITY_STRAIN, /* engineering ones */
    QUANTITY_STRESS,
    QUANTITY_FORCE,
    QUANTITY_EXTENSION,
    QUANTITY_TIME,
    QUANTITY_TRANSVERSE, /* strain across the specimen */
    QUANTITY_TRUE_STRAIN,
    QUANTITY_TRUE_STRESS,
    QUANTITIES, /* also: none of these */
};

struct heading {
    enum quantity quantity;
    int rank;      /* place of the name in the list of names: of two the lower one is meant */
    double factor; /* to SI; NAN where no unit is named and the quantity needs one */
    char unit[32]; /* as written; "" */
};

/* Name of the quantity for --columns-of, column in the table (SI), and unit. */
const char *quantity_name(enum quantity quantity);
const char *quantity_column(enum quantity quantity);
const char *quantity_unit(enum quantity quantity);

/* Reads "Standardkraft [kN]", "Load (N)", "stress_MPa", "Force / N"; unit (NULL: there is none)
 * is that of a row of units.  quantity = QUANTITIES where the name is not known, in English or
 * German. */
struct heading heading_read(const char *text, const char *unit);

/* The same for a column of which it is said what it is. */
struct heading heading_as(enum quantity quantity, const char *text, const char *unit);

/* Factor from a unit as laboratories write it ("%", "-", "N/mm²", "sec") to the SI unit; NAN:
 * not one of that kind. */
double heading_factor(const char *unit, const char *si);

/* Any unit, or "-". */
bool heading_is_unit(const char *text);

/* A value that stands above the table: "Querschnitt;20,0;mm²", "Gauge length = 50 mm", "Dicke a0
 * [mm];2".  "section_m2", "gauge_length_m", "thickness_m", "width_m" or "diameter_m" where words
 * name one, and *value is set; NULL where they do not, or where a mark may part thousands or
 * decimals. */
const char *heading_size(const char *words, char decimal, double *value);

/* Whether words name the specimen. */
bool heading_is_specimen(const char *words);

#endif
