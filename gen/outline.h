/* outline.h - what of a cell lies inside the body, and the body in numbers. */
#ifndef HS_OUTLINE_H
#define HS_OUTLINE_H

#include "specimen.h"

/* Whether a point (m, of the lattice's frame) is inside; one on the outline is. */
bool outline_holds(const struct specimen *specimen, const double point[3]);

/* Volume (m^3) of the part of a cell about a centre (m, of the lattice's frame) that lies in the
 * body.  Flat bodies: in closed form, from areas of polygons and of their parts in discs.  Round
 * ones: areas of rectangles in discs along the body's x, integrated between their corners with
 * GSL's doubly adaptive Clenshaw-Curtis to 1e-13 of the cell. */
double outline_of_cell(const struct specimen *specimen, const double centre[3]);

/* Volume (m^3) of the body between the planes x = -/+ length / 2 of its own frame, by the same
 * formulas. */
double outline_between(const struct specimen *specimen, double length);

/* Area of the section between the gauge planes (m^2), of the whole body where there is no gauge. Of
 * the body itself where cells are cut; else of its nodes, both layers included (of a turned body
 * those whose centres lie between the planes). */
double outline_section(const struct specimen *specimen, const struct sites *sites);

#endif
