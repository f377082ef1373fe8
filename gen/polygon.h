/* polygon.h - convex polygons in a plane: cut by lines, and their area inside a circle. */
#ifndef HS_POLYGON_H
#define HS_POLYGON_H

enum { MOST_CORNERS = 24 };

struct polygon {
    int count;
    double at[MOST_CORNERS][2]; /* counter-clockwise */
};

struct polygon polygon_box(double x_low, double x_high, double y_low, double y_high);

/* What lies where sign * coordinate <= sign * limit along an axis, 0 or 1; a line adds a corner at
 * most. */
struct polygon polygon_below(const struct polygon *polygon, int axis, double sign, double limit);

double polygon_area(const struct polygon *polygon);

/* Area of the common part of the polygon and a disc, in closed form: of each edge that of the
 * triangle with the centre, of which what lies beyond the circle is a sector. */
double polygon_in_disc(const struct polygon *polygon, const double centre[2], double radius);

#endif
