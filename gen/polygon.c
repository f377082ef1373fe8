#include "polygon.h"

#include <math.h>

struct polygon polygon_box(double x_low, double x_high, double y_low, double y_high)
{
    if (x_low > x_high || y_low > y_high) return (struct polygon){0};
    return (struct polygon){4,
                            {{x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}}};
}

/* Sutherland and Hodgman, one line. */
struct polygon polygon_below(const struct polygon *polygon, int axis, double sign, double limit)
{
    struct polygon cut = {0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->at[i], *b = polygon->at[(i + 1) % polygon->count];
        const double over_a = sign * (a[axis] - limit), over_b = sign * (b[axis] - limit);
        if (over_a <= 0) {
            cut.at[cut.count][0] = a[0];
            cut.at[cut.count++][1] = a[1];
        }
        if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) {
            const double t = over_a / (over_a - over_b);
            cut.at[cut.count][axis] = limit;
            cut.at[cut.count++][1 - axis] = a[1 - axis] + t * (b[1 - axis] - a[1 - axis]);
        }
    }
    return cut;
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

double polygon_area(const struct polygon *polygon)
{
    /* From the first corner: no large terms where the polygon is far from the origin. */
    double twice = 0;
    for (int i = 1; i + 1 < polygon->count; i++) {
        const double *o = polygon->at[0], *a = polygon->at[i], *b = polygon->at[i + 1];
        const double to_a[2] = {a[0] - o[0], a[1] - o[1]}, to_b[2] = {b[0] - o[0], b[1] - o[1]};
        twice += cross(to_a, to_b);
    }
    return twice / 2;
}

static double sector(const double a[2], const double b[2], double radius)
{
    return 0.5 * radius * radius * atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
}

/* Of the triangle from the centre, at the origin, to a and b; negative where they go clockwise. */
static double triangle_in_disc(const double a[2], const double b[2], double radius)
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]};
    const double square = d[0] * d[0] + d[1] * d[1], half = a[0] * d[0] + a[1] * d[1];
    const double beyond = a[0] * a[0] + a[1] * a[1] - radius * radius;
    const double root = sqrt(fmax(0, half * half - square * beyond));
    const double enter = (-half - root) / square, leave = (-half + root) / square;
    if (!(root > 0) || leave <= 0 || enter >= 1) return sector(a, b, radius);
    const double from = fmax(enter, 0), to = fmin(leave, 1);
    const double p[2] = {a[0] + from * d[0], a[1] + from * d[1]};
    const double q[2] = {a[0] + to * d[0], a[1] + to * d[1]};
    double area = 0.5 * cross(p, q);
    if (enter > 0) area += sector(a, p, radius);
    if (leave < 1) area += sector(q, b, radius);
    return area;
}

double polygon_in_disc(const struct polygon *polygon, const double centre[2], double radius)
{
    double area = 0;
    for (int i = 0; i < polygon->count; i++) {
        const double *from = polygon->at[i], *to = polygon->at[(i + 1) % polygon->count];
        const double a[2] = {from[0] - centre[0], from[1] - centre[1]};
        const double b[2] = {to[0] - centre[0], to[1] - centre[1]};
        area += triangle_in_disc(a, b, radius);
    }
    return area;
}
