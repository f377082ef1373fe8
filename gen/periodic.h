/* periodic.h - a body that goes on with its own image along some of its axes, such as a
 * representative cell. */
#ifndef HS_PERIODIC_H
#define HS_PERIODIC_H

#include "specimen.h"

/* Reads the key `periodic` of the section domain, a list of axes, into the specimen, and dies where
 * the body cannot go on along them: with ends that are held or measured, turned, round, or not
 * everywhere as wide. */
void periodic_read(struct deck_node domain, struct specimen *specimen);

/* The core distance (m) with which whole cubic cells, `edge` distances wide, fill the specimen
 * along its periodic axes: the distance itself where there are none, else the nearest to it.  Dies
 * where that is further than PERIODIC_SLACK from it, or where other axes hold no whole number of
 * these cells; says what sizes and distances would do. */
double periodic_distance(struct deck_node domain, const struct specimen *specimen,
                         const char *lattice, double edge, double distance);

/* Numbers with square roots are rounded where people write them. */
#define PERIODIC_SLACK 1e-3

#endif
