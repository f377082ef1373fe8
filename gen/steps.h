/* steps.h - from site to site of a lattice, shortest first.  All lengths in edges along x. */
#ifndef HS_STEPS_H
#define HS_STEPS_H

#include <stdbool.h>

struct step {
    int offset[3];
    double distance;
    double edge; /* of a cell in the direction of the step: sqrt(sum (u_a edge_a)^2), u its unit
                    vector */
};

/* spacing: the edges of a cell, of which the ratios count. */
struct step steps_to(const double spacing[3], const int offset[3]);

/* Thickness of what lies between two nodes that far apart: n layers of cells along an axis are n of
 * its edges. */
double steps_film(const struct step *step);

/* Whether the two cells share a face, an edge or a corner. */
bool steps_touch(const struct step *step);

/* The edge along x of cubes of the same volume; a sheet's squares of the same area. */
double steps_unit(const double spacing[3], bool sheet);

double steps_longest_edge(const double spacing[3], bool sheet);

enum steps_order { STEPS_BY_DISTANCE, STEPS_BY_FILM /* those that touch before all others */ };

/* All offsets but the zero with a distance of at most radius, of a sheet those in its plane; half:
 * one of each pair of opposite ones.  The caller frees them. */
struct step *steps_ball(const double spacing[3], double radius, bool half, bool sheet,
                        enum steps_order order, int *count);

#endif
